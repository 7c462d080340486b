// The memory that the tallies of a scene take.
#pragma once

#include "scene/scene.hpp"

namespace photic::scene {

/// No run takes more for its tallies [bytes].
inline constexpr double max_tally_memory = 2147483648.0;

/// In bytes, where light reaches every gate; where it does not they take less. All copies are
/// counted: sums, sums before an incomplete last batch, the result, what is being written. By what
/// they grow with.
struct TallyMemory {
  double depths, orders, other_waters, rest;
  double groups;   ///< of batches
  double tallies;  ///< beside echoes
  double batch;    ///< of each batch under way beyond the two that are counted above
  [[nodiscard]] double bytes() const {
    return depths + orders + other_waters + rest + groups + tallies;
  }
};

TallyMemory tally_memory(const Scene& scene);

/// Echoes by groups of batches take no more in a file, before it is compressed [bytes].
inline constexpr double max_group_echoes = 64e6;
/// The most that they would take [bytes].
double group_echoes(const Scene& scene);
/// Returns whether a scene asks for them and they fit.
bool keeps_groups(const Scene& scene);

/// The cells of all tallies beside echoes, at most.
double cells_of_tallies(const Scene& scene);

}  // namespace photic::scene
