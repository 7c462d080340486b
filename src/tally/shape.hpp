// The extents of the tallies and where a score belongs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tally/decay.hpp"
#include "tally/grid.hpp"
#include "tally/tally_grid.hpp"

namespace photic::tally {

/// A channel that counts light, and the share that it does.
struct Counting {
  std::int32_t channel = 0;
  double share = 1;
};

/// Immutable; shared by all batches.
struct Shape {
  std::size_t telescopes = 0, channels = 0, gates = 0, environments = 0;
  std::size_t tangents = 0;  ///< of parameters: the last environments, whose echo is none
  /// Each holds what of an echo is within its axes; the first one, by order, all of it.
  std::vector<Grid> grids;
  bool keeps_groups = false;  ///< of batches (batch_groups.hpp)
  /// Kinds that scores are counted apart for: kinds_of_technique, or 1 of an estimator without
  /// walks.
  std::size_t techniques = 1;
  std::vector<TallyGrid> tallies;                       ///< beside echoes
  std::vector<std::vector<Counting>> channels_of_line;  ///< that count a line's light
  /// Index in the axis of processes, of each light: a line that has touched something
  /// (transport::Touched), [touched][line].
  std::vector<std::int32_t> process_of_light;
  std::vector<Decay> decay_of_line;  ///< empty if all lines are emitted at once
  std::int32_t max_order = 0;        ///< 0: none; order max_order + 1 is what is cut off
  /// The next wider telescope of each, whose view holds its own; empty if no views nest.
  std::vector<std::optional<std::size_t>> wider;

  [[nodiscard]] Grid& grid(std::string_view name) {
    return *std::ranges::find(grids, name, &Grid::name);
  }
  [[nodiscard]] const Grid& grid(std::string_view name) const {
    return *std::ranges::find(grids, name, &Grid::name);
  }
  /// Environments that are waters of their own.
  [[nodiscard]] std::size_t waters() const { return environments - tangents; }
  /// Rows of gates: a channel of a telescope each.
  [[nodiscard]] std::size_t rows() const { return telescopes * channels; }
  [[nodiscard]] std::size_t cells() const { return rows() * gates; }
  [[nodiscard]] std::size_t row_of(std::size_t cell) const { return cell / gates; }
  [[nodiscard]] std::size_t cell(std::size_t telescope, std::size_t channel,
                                 std::size_t gate) const {
    return (telescope * channels + channel) * gates + gate;
  }
};

}  // namespace photic::tally
