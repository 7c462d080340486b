// Histories of the forward estimator beside the walks of the bidirectional one, where a film of oil
// shines. They score what walks leave out: the film's light, and the surface's own echo.
#pragma once

#include <cstdint>

#include "estimator/air.hpp"
#include "estimator/model.hpp"
#include "estimator/world.hpp"
#include "tally/batch_tally.hpp"

namespace photic::estimator {

/// Folded into the seed: they share no random number with the walks.
inline constexpr std::uint64_t beside_walks_stream = 0x5be0cd19137e2179;

/// A world of such histories, and the model that it looks into.
template <class T>
class BesideWalks {
 public:
  BesideWalks(const Model& walks, const World<T>& of_walks)
      : model_(by_histories(walks)), world_(make_world<T>(model_)) {
    world_.scored = Scored::film;
    // What the water converts is left to the walks.
    world_.conversion = T(0);
    world_.views.clear();
    world_.cones.clear();
    world_.key = model_.scene.simulation.seed ^ beside_walks_stream;
    world_.batch_photons = of_walks.batch_photons;
    if (world_.points.dimensions() > 0)
      world_.points = {world_.batch_photons, quasi_random_dimensions};
  }
  BesideWalks(const BesideWalks&) = delete;
  BesideWalks& operator=(const BesideWalks&) = delete;

  [[nodiscard]] const World<T>& world() const { return world_; }

  /// Has run() follow them. The accounts of their weights are not kept: light of the laser is in
  /// those of the walks.
  template <class Run>
  static void follow(tally::BatchTally& tally, Run run) {
    const tally::Ledger of_walks = tally.ledger;
    run();
    tally.ledger = of_walks;
  }

 private:
  Model model_;
  World<T> world_;
};

}  // namespace photic::estimator
