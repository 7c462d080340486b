// Histories of the forward estimator beside the walks of the bidirectional one. They score what
// walks leave out: the light of a film of oil that shines, with the surface's own echo; and light
// that is scattered in the water and in the air.
#pragma once

#include <cstdint>

#include "estimator/air.hpp"
#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "estimator/random_blocks.hpp"

namespace photic::estimator {

/// Gives a world beside walks random numbers of a stream.
template <class T>
void draw_from(World<T>& world, const Model& walks, std::uint64_t stream) {
  world.key = walks.scene.simulation.seed ^ stream;
  world.batch_photons = batch_photons(walks.scene.simulation);
  if (world.points.dimensions() > 0) world.points = {world.batch_photons, quasi_random_dimensions};
}

/// A world of histories that score the light of a film, and the model that it looks into.
template <class T>
class FilmBesideWalks {
 public:
  explicit FilmBesideWalks(const Model& walks)
      : model_(by_histories(walks)), world_(make_world<T>(model_)) {
    world_.scored = Scored::film;
    // Light that the water converts is left to the walks.
    world_.conversion = T(0);
    world_.views.clear();
    world_.cones.clear();
    draw_from(world_, walks, beside_walks_stream);
  }
  FilmBesideWalks(const FilmBesideWalks&) = delete;
  FilmBesideWalks& operator=(const FilmBesideWalks&) = delete;

  [[nodiscard]] const World<T>& world() const { return world_; }

 private:
  Model model_;
  World<T> world_;
};

/// Worlds of histories that score light of both media.
template <class T>
struct BothMediaBesideWalks {
  Model water_model, air_model;
  World<T> setting_out;  ///< light of the laser in the water; it is not scored
  World<T> water, air;

  explicit BothMediaBesideWalks(const Model& walks)
      : water_model(by_histories(walks)),
        air_model(model_of_air(water_model)),
        water(make_world<T>(water_model)),
        air(make_world<T>(air_model)) {
    draw_from(water, walks, beside_water_stream);
    draw_from(air, walks, beside_air_stream);
    join(air_model, walks.scene.source, water, air);
    air.scored = Scored::from_water;
    setting_out = water;
    setting_out.scored = Scored::none;
  }
  BothMediaBesideWalks(const BothMediaBesideWalks&) = delete;
  BothMediaBesideWalks& operator=(const BothMediaBesideWalks&) = delete;
};

}  // namespace photic::estimator
