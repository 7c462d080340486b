// Batches of quiet gates, and the flags of a gate.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "unit/tally/tallies.hpp"

namespace photic::tally {

/// Batches of 1000 photons, each with `scores` equal scores in gate 0 that add up to
/// `total(batch)`.
inline void add_batches(Tallies& t, int batches, int scores,
                        const std::function<double(int)>& total) {
  for (int b = 0; b < batches; ++b) {
    for (int k = 0; k < scores; ++k) t.score(0, total(b) / scores);
    t.end_batch(1000);
  }
}

/// The score of a well-behaved gate: batches that differ by ten per cent, made of many scores.
inline double steady(int batch) {
  test::Random random(static_cast<std::uint64_t>(batch) + 100);
  return 1e-3 * random.between(0.9, 1.1);
}

inline std::int32_t flags(const Tallies& t) { return t.totals.health(0).flags; }

/// A quiet gate, made of the laser's walks, and of so many smaller scores a batch of both walks,
/// whose tail has such an index.
inline void add_beside_quiet_scores(Tallies& t, double index, int scores, test::Random& random) {
  for (int b = 0; b < 64; ++b) {
    for (int k = 0; k < 100; ++k) t.score(0, 1e-4 * random.between(0.9, 1.1), Technique::laser);
    for (int k = 0; k < scores; ++k)
      t.score(0, std::min(0.5, 3e-7 * std::pow(random.uniform(), -1 / index)), Technique::both);
    t.end_batch(1000);
  }
}

}  // namespace photic::tally
