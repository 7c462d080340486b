// Everything a history needs, immutable and shared by all threads.
#pragma once

#include <cmath>
#include <vector>

#include "instrument/laser.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"
#include "tally/gates.hpp"
#include "tally/shape.hpp"

namespace photic::engine {

template <class T>
struct World {
  medium::MediumView sea;
  instrument::Laser<T> laser;
  Index<T> laser_layer{};
  std::vector<instrument::Telescope<T>> telescopes;
  std::vector<Index<T>> telescope_layer;
  T last_path{};            ///< end of the last gate [m]
  T least_group_index{};    ///< of all lines
  T directed{};             ///< share of directions drawn towards a telescope
  T conversion{};           ///< probability of a branch into the inelastic processes
  T roulette_threshold{};
  std::int32_t last_order = 0;  ///< scores go on to this order; 0: no limit
  std::uint64_t seed = 0;
};

/// Below this analog weight absorption is by Russian roulette, as in a plain walk.
inline constexpr double roulette_threshold = 1e-3;

template <class T>
World<T> make_world(const scene::Scene& scene, const medium::Medium& medium, const tally::Gates& gates) {
  World<T> world;
  world.sea = medium.view();
  world.laser = instrument::make_laser<T>(scene.source);
  world.laser_layer = Index<T>(medium.layer_at(std::max(0.0, -scene.source.position_m.z)));
  for (const auto& t : scene.telescope) {
    world.telescopes.push_back(instrument::make_telescope<T>(t));
    world.telescope_layer.push_back(Index<T>(medium.layer_at(std::max(0.0, -t.position_m.z))));
  }
  world.last_path = T(gates.last_path());
  double least = medium.line.front().group_index;
  for (const auto& line : medium.line) least = std::min(least, line.group_index);
  world.least_group_index = T(least);
  world.directed = T(scene.simulation.directed_fraction);
  world.conversion = T(scene.simulation.conversion_probability);
  world.roulette_threshold = T(roulette_threshold);
  world.last_order = scene.simulation.max_order ? static_cast<std::int32_t>(*scene.simulation.max_order) + 1 : 0;
  world.seed = scene.simulation.seed;
  return world;
}

}  // namespace photic::engine
