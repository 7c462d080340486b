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
#include <optional>

#include "estimator/model.hpp"
#include "estimator/world.hpp"

namespace photic::estimator {

/// Folded into the seed: light in the air shares no random number with the light in the water, nor
/// histories with the walks that they are beside.
inline constexpr std::uint64_t air_stream = 0x1f83d9abfb41bd6b,
                               beside_air_stream = 0xa54ff53a5f1d36f1,
                               beside_water_stream = 0x3c6ef372fe94f82b;

/// Of a model with air.
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

/// Worlds of histories in both media beside walks.
template <class T>
struct HistoriesBesideWalks {
  Model water_model, air_model;
  World<T> setting_out;  ///< light of the laser in the water; it is not scored
  World<T> water, air;

  explicit HistoriesBesideWalks(const Model& walks)
      : water_model(by_histories(walks)),
        air_model(model_of_air(water_model)),
        water(make_world<T>(water_model)),
        air(make_world<T>(air_model)) {
    const std::uint64_t batch = batch_photons(walks.scene.simulation);
    const auto prepare = [&](World<T>& world, std::uint64_t stream) {
      world.key = walks.scene.simulation.seed ^ stream;
      world.batch_photons = batch;
      if (world.points.dimensions() > 0) world.points = {batch, quasi_random_dimensions};
    };
    prepare(water, beside_water_stream);
    prepare(air, beside_air_stream);
    join(air_model, walks.scene.source, water, air);
    air.scored = Scored::from_water;
    setting_out = water;
    setting_out.scored = Scored::none;
  }
  HistoriesBesideWalks(const HistoriesBesideWalks&) = delete;
  HistoriesBesideWalks& operator=(const HistoriesBesideWalks&) = delete;
};

/// The worlds of a model with air, besides that of the water.
template <class T>
class AirWorlds {
 public:
  /// `water`: that of the model.
  AirWorlds(const Model& model, World<T>& water)
      : model_(model_of_air(model)), air_(make_world<T>(model_)) {
    air_.key = model.scene.simulation.seed ^ air_stream;
    if (water.estimator == scene::Estimator::bidirectional)
      beside_walks_.emplace(model);
    else
      join(model_, model.scene.source, water, air_);
  }
  AirWorlds(const AirWorlds&) = delete;
  AirWorlds& operator=(const AirWorlds&) = delete;

  /// Of walks that stay in the air, or of histories.
  [[nodiscard]] const World<T>& air() const { return air_; }
  [[nodiscard]] const HistoriesBesideWalks<T>& beside_walks() const { return *beside_walks_; }

 private:
  Model model_;
  World<T> air_;
  std::optional<HistoriesBesideWalks<T>> beside_walks_;
};

}  // namespace photic::estimator
