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
constexpr Prices forward_prices{.photons = 1119, .collisions = 0, .scores = 438, .local_estimates = 42, .facets = 1306, .ratios = 101};
constexpr Prices bidirectional_prices{.photons = 1881, .collisions = 0, .scores = 0, .local_estimates = 9828, .facets = 6968, .vertex_pairs = 629, .ray_pairs = 87, .meetings = 506, .free_meetings = 373, .meetings_by_waves = 638, .ratios = 63};
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
