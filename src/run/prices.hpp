// The price of a simulation: its operations by kind, each at the price of its instructions. So
// estimators and settings are compared without a clock.
#pragma once

#include <cstddef>

#include "tally/state.hpp"

namespace photic::run {

/// Instructions of each operation by lanes of AVX2.
struct Prices {
  double photons = 0, collisions = 0, scores = 0, local_estimates = 0, facets = 0, vertex_pairs = 0,
         ray_pairs = 0, meetings = 0, free_meetings = 0, meetings_by_waves = 0;
  double ratios = 0;  ///< of a score in an environment to that in the scene
};

// clang-format off
// Both are written by benchmarks/prices.py.
constexpr Prices forward_prices{.photons = 1278, .collisions = 0, .scores = 338, .local_estimates = 52, .facets = 1438, .ratios = 89};
constexpr Prices bidirectional_prices{.photons = 2997, .collisions = 0, .scores = 0, .local_estimates = 0, .facets = 6660, .vertex_pairs = 789, .ray_pairs = 47, .meetings = 496, .free_meetings = 481, .meetings_by_waves = 331, .ratios = 56};
// clang-format on

/// The instructions that a simulation has taken, as predicted by its operations.
inline double instructions(const Prices& price, const tally::TotalsState& state,
                           std::size_t environments) {
  const auto at = [](double one, std::uint64_t count) { return one * static_cast<double>(count); };
  const tally::Operations& n = state.operations;
  return at(price.photons, state.photons) + at(price.collisions, state.collisions) +
         at(price.scores, state.scores) + at(price.local_estimates, n.local_estimates) +
         at(price.facets, n.facets) + at(price.vertex_pairs, n.vertex_pairs) +
         at(price.ray_pairs, n.ray_pairs) + at(price.meetings, n.meetings) +
         at(price.free_meetings, n.free_meetings) +
         at(price.meetings_by_waves, n.meetings_by_waves) +
         at(price.ratios, state.scores * environments);
}

}  // namespace photic::run
