// Sums by groups of batches. Their scatter is that of anything made of several cells, whose scores
// stem from the same photons (docs/theory.md, eq. 112).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/zeroed.hpp"

namespace photic::tally {

/// So many full groups become half as many: two neighbours become one.
inline constexpr std::uint64_t full_groups = 128;

/// The batches of each group, of a run of so many: a power of two. The last group may have fewer.
inline std::uint64_t batches_of_group(std::uint64_t batches) {
  return std::max(std::uint64_t{1}, std::bit_floor(batches) / (full_groups / 2));
}

/// From 64 to 128, or as many as batches.
inline std::size_t groups_of(std::uint64_t batches) {
  const std::uint64_t of_each = batches_of_group(batches);
  return static_cast<std::size_t>((batches + of_each - 1) / of_each);
}

/// The sums of some cells in each group.
template <class Number>
struct GroupSums {
  ZeroedVector<Number> sums;  ///< [group][cell]

  /// Makes room for a group of so many cells, unless there is.
  void open(std::size_t group, std::size_t cells) {
    if (sums.size() < (group + 1) * cells) sums.resize((group + 1) * cells);
  }
  /// Adds neighbours up, of an even number of groups.
  void pair_up(std::size_t cells) {
    const std::size_t pairs = cells == 0 ? 0 : sums.size() / cells / 2;
    for (std::size_t pair = 0; pair < pairs; ++pair)
      for (std::size_t k = 0; k < cells; ++k)
        sums[pair * cells + k] = sums[2 * pair * cells + k] + sums[(2 * pair + 1) * cells + k];
    sums.resize(pairs * cells);
  }
  friend bool operator==(const GroupSums&, const GroupSums&) = default;
};

/// All that is kept by groups; empty where a scene keeps none.
struct BatchGroups {
  GroupSums<std::uint64_t> photons;  ///< [group][row]: that the row was scored in
  GroupSums<double> echo;            ///< [group][cell]
  GroupSums<double> environment;     ///< [group][cell][environment that is a water]

  /// Calls f(sums, size of a group) for each.
  template <class F>
  void each(std::size_t rows, std::size_t cells, std::size_t waters, F f) {
    f(photons, rows);
    f(echo, cells);
    f(environment, cells * waters);
  }
  friend bool operator==(const BatchGroups&, const BatchGroups&) = default;
};

}  // namespace photic::tally
