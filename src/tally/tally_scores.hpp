// The scores of a batch of photons in the tallies beside echoes, and their sums over batches.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/zeroed.hpp"
#include "tally/state.hpp"

namespace photic::tally {

/// Scores may be greater than 1, as lengths in metres are: they are kept as so much of themselves,
/// a power of two, for octaves to hold them.
inline constexpr double tally_score_unit = 0x1p-32;

/// Of a batch, by cell of all grids.
struct TallyScores {
  explicit TallyScores(std::size_t cells) : sums(cells), largest(cells), octaves(cells) {}

  void add(std::size_t cell, double score) {
    if (!(score > 0)) return;
    const double kept = score * tally_score_unit;
    sums[cell] += kept;
    largest[cell] = std::max(largest[cell], kept);
    ++octaves[cell][static_cast<std::size_t>(score_octave(kept))];
  }
  void clear() {
    for (std::size_t cell = 0; cell < sums.size(); ++cell) {
      if (sums[cell] == 0) continue;
      sums[cell] = largest[cell] = 0;
      octaves[cell] = {};
    }
  }

  std::vector<double> sums, largest;
  ZeroedVector<OctavesOfBatch> octaves;
};

}  // namespace photic::tally
