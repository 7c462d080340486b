// The price of a simulation: its operations by kind, each at the price of its instructions. So
// estimators and settings are compared without a clock.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tally/state.hpp"

namespace photic::run {

/// Instructions of each operation by lanes of AVX2.
struct Prices {
  double photons = 0, collisions = 0, scores = 0;
  double layered_scores = 0;  ///< what a score takes more between layers
  double local_estimates = 0, facets = 0;
  double film_facets = 0;  ///< what a facet takes more under a film
  double vertex_pairs = 0, ray_pairs = 0, meetings = 0, free_meetings = 0, meetings_by_waves = 0;
  double ratios = 0;  ///< of a score in an environment to that in the scene
};

/// The properties of a scene that make its operations dearer.
struct PricedScene {
  bool layered = false, film = false;
  std::size_t environments = 0;  ///< whole groups of them (tally::EnvironmentScores)
};

// clang-format off
// Both are written by benchmarks/prices.py.
constexpr Prices forward_prices{.photons = 1456, .collisions = 0, .scores = 417, .layered_scores = 188, .facets = 757, .film_facets = 7871, .ratios = 97};
constexpr Prices bidirectional_prices{.photons = 2867, .collisions = 141, .scores = 0, .layered_scores = 0, .local_estimates = 5489, .facets = 3161, .film_facets = 10605, .vertex_pairs = 710, .ray_pairs = 72, .meetings = 481, .free_meetings = 448, .meetings_by_waves = 628, .ratios = 66};
// clang-format on

/// The instructions that a simulation has taken, as predicted by its operations.
inline double instructions(const Prices& price, const tally::TotalsState& state,
                           const PricedScene& scene) {
  const auto at = [](double one, std::uint64_t count) { return one * static_cast<double>(count); };
  const tally::Operations& n = state.operations;
  const double of_score = price.scores + (scene.layered ? price.layered_scores : 0) +
                          at(price.ratios, scene.environments);
  const double of_facet = price.facets + (scene.film ? price.film_facets : 0);
  return at(price.photons, state.photons) + at(price.collisions, state.collisions) +
         at(of_score, state.scores) + at(price.local_estimates, n.local_estimates) +
         at(of_facet, n.facets) + at(price.vertex_pairs, n.vertex_pairs) +
         at(price.ray_pairs, n.ray_pairs) + at(price.meetings, n.meetings) +
         at(price.free_meetings, n.free_meetings) +
         at(price.meetings_by_waves, n.meetings_by_waves);
}

}  // namespace photic::run
