// What one batch of photons scored. One worker fills it; then it is merged into the Totals and
// cleared.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "tally/shape.hpp"
#include "tally/state.hpp"

namespace photic::tally {

/// The octave of a score's size, 0 … score_octaves - 1.
inline int score_octave(double value) {
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52) - 1023;
  return exponent < -score_octaves ? 0
                                   : (exponent >= 0 ? score_octaves - 1 : exponent + score_octaves);
}

/// One contribution of a collision to a telescope, at one line.
struct Score {
  std::size_t telescope = 0;
  std::int32_t line = 0, order = 0;
  double depth = 0;  ///< of the collision [m]
  double path = 0;   ///< group path from the laser's disc to the aperture [m]
  double value = 0;  ///< expected photons
};

class BatchTally {
 public:
  BatchTally(const Shape& shape, const Gates& gates);

  void score(const Score& s);
  void clear();

  // Sums over the batch. The echo of a cell is the sum of by_order over its orders.
  std::vector<double> by_order;    ///< [cell][order]
  std::vector<double> by_process;  ///< [cell][process]
  std::vector<double> by_depth;    ///< [cell][depth]
  std::vector<double> cut_order;   ///< [cell] first order beyond max_order
  std::vector<double> largest;     ///< [cell] largest single score
  std::vector<std::array<std::uint32_t, score_octaves>> octaves;  ///< [cell]
  std::vector<std::uint32_t> touched_cells, touched_depths;

  Ledger ledger;  ///< sums of weights
  std::uint64_t photons = 0, collisions = 0, scores = 0, too_many_events = 0, not_finite = 0;

 private:
  const Shape* shape_;
  const Gates* gates_;
};

}  // namespace photic::tally
