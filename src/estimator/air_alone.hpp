// Light that is scattered in the air and never gets into the water: a simulation of its own, upside
// down (medium/upside_down.hpp), by the same estimator. The sea mirrors it.
#pragma once

#include <cstdint>

#include "estimator/model.hpp"
#include "estimator/world.hpp"
#include "tally/batch_tally.hpp"

namespace photic::estimator {

/// Folded into the seed: it shares no random number with the light in the water.
inline constexpr std::uint64_t air_stream = 0x1f83d9abfb41bd6b;

/// Of a model with air.
Model model_of_air(const Model& model);

/// A world of such light, and the model that it looks into.
template <class T>
class AirAlone {
 public:
  explicit AirAlone(const Model& model)
      : model_(model_of_air(model)), world_(make_world<T>(model_)) {
    world_.key = model_.scene.simulation.seed ^ air_stream;
  }
  AirAlone(const AirAlone&) = delete;
  AirAlone& operator=(const AirAlone&) = delete;

  [[nodiscard]] const World<T>& world() const { return world_; }

  /// Has run(world) follow it. The accounts of its weights are not kept: for the light in the water
  /// it is lost on the way.
  template <class Run>
  void follow(tally::BatchTally& tally, Run run) const {
    const tally::Ledger of_water = tally.ledger;
    run(world_);
    tally.ledger = of_water;
  }

 private:
  Model model_;
  World<T> world_;
};

}  // namespace photic::estimator
