// Light in the air above the sea: worlds of their own, upside down (medium/upside_down.hpp), in
// which it is followed by what follows light in the water. Light that passes the surface goes on in
// the other medium's world (forward/passing.hpp).
//
// Histories of the forward estimator may change between both as often as they like. The
// bidirectional estimator's walks stay in one medium. They score what is scattered in the water
// alone, and what is scattered in the air alone. Histories beside them score the rest.
#pragma once

#include <algorithm>
#include <cstdint>

#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "estimator/random_blocks.hpp"

namespace photic::estimator {

/// The model of the air of a model.
Model model_of_air(const Model& model);

/// The same model by the forward estimator's histories.
Model by_histories(const Model& model);

/// The share of light that leaves the water which is followed in the air: most never comes back.
inline double share_that_passes(const medium::Medium& air) {
  constexpr double least = 0.05, per_optical_depth = 2;
  return std::clamp(per_optical_depth * air.scattering(), least, 1.0);
}

/// Has light that passes the surface go on from one world to the other, and back.
template <class T>
void join(const Model& air, const scene::Source& source, World<T>& water_world,
          World<T>& air_world) {
  const scene::Source& laser = air.scene.source;
  const auto left_out =
      geometry::ahead_of_air(laser.position_m, normalised(laser.direction), air.medium.air_m);
  const T ahead = T(way_ahead(source) - left_out.length - left_out.to_sea);
  water_world.beyond = {true, T(share_that_passes(air.medium)), ahead};
  air_world.beyond = {true, T(1), T(0) - ahead};
  water_world.flies_on = air_world.flies_on = false;  // past the surface without meeting it
}

/// The world of a model's air.
template <class T>
class AirWorld {
 public:
  /// `water`: the model's world.
  AirWorld(const Model& model, World<T>& water)
      : model_(model_of_air(model)), air_(make_world<T>(model_)) {
    air_.key = model.scene.simulation.seed ^ air_stream;
    if (water.estimator != scene::Estimator::bidirectional)
      join(model_, model.scene.source, water, air_);
  }
  AirWorld(const AirWorld&) = delete;
  AirWorld& operator=(const AirWorld&) = delete;

  /// The world of walks that stay in the air, or of histories.
  [[nodiscard]] const World<T>& air() const { return air_; }

 private:
  Model model_;
  World<T> air_;
};

}  // namespace photic::estimator
