// Phase functions averaged over the directions in the water in which an instrument's walks begin
// (theory.md, "Free walks"): with them free walks draw how their first vertex is left.
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/lanes.hpp"
#include "core/twin_table.hpp"
#include "estimator/entry_cone.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// Means as walks look them up: against x = 1 - cos of the angle to the cone's axis, straight lines
/// in equal cells of each octave of x, and of 2 - x behind 90 degrees.
struct AveragedPhases {
  static constexpr int cell_bits = 6;
  /// The first cells reach from the poles to there: 5 microradians, and 0.3 degrees.
  static constexpr int forward_octaves = 36, back_octaves = 16;
  static constexpr int forward_cells = 1 + (forward_octaves << cell_bits);
  static constexpr int back_cells = 1 + (back_octaves << cell_bits);
  static constexpr int cells = forward_cells + back_cells;
  static constexpr int line_fields = 2;  ///< value at the pole [1/sr], slope

  Table line;               ///< [instrument][table of the medium][cell][field]
  std::int32_t tables = 0;  ///< of the medium

  /// The mean over the cone of an instrument [1/sr].
  template <class T>
  T value(std::int32_t instrument, const T& x, const Index<T>& table) const {
    const Mask<T> ahead = x < T(1);
    const T near = select(ahead, x, T(2) - x);
    const T least = select(ahead, T(lowest(forward_octaves)), T(lowest(back_octaves)));
    // The octave's first cell is that of the pole where it lies below the least.
    const Index<T> cell = octave_cell(select(near > least, near, least), cell_bits).cell;
    const Index<T> inside =
        cell + select(ahead, Index<T>(1 + (forward_octaves << cell_bits)),
                      Index<T>(forward_cells + 1 + (back_octaves << cell_bits)));
    // At 90 degrees itself rounding may lead one cell too far.
    const Index<T> last = select(ahead, Index<T>(forward_cells - 1), Index<T>(cells - 1));
    const Index<T> i = select(inside < last, inside, last);
    const Index<T> row = (Index<T>(instrument * tables) + table) * Index<T>(cells) + i;
    const auto here = gather_row<line_fields, T>(line, row * Index<T>(line_fields));
    return here[0] + here[1] * near;
  }
  /// Edges of a cell, as distances from its pole.
  static std::array<double, 2> edges(int cell) {
    const bool forward = cell < forward_cells;
    const int octaves = forward ? forward_octaves : back_octaves;
    const int i = (forward ? cell : cell - forward_cells) - 1 - (octaves << cell_bits);
    const double to = octave_edge<double>(i + 1, cell_bits);
    return {i < -(octaves << cell_bits) ? 0 : octave_edge<double>(i, cell_bits), to};
  }

 private:
  /// A little below the first octave: in the cell of the pole.
  static constexpr double lowest(int octaves) {
    double x = 1 - 1e-3;
    for (int i = 0; i < octaves; ++i) x /= 2;
    return x;
  }
};

/// Owns them. With none, there are no free walks.
class AveragedPhaseTables {
 public:
  AveragedPhaseTables() = default;
  /// The means of the tables by which a medium scatters light elastically, for instruments in their
  /// order. Nothing looks up the others, which are 0.
  AveragedPhaseTables(const medium::Medium& medium, const std::vector<EntryCone<double>>& cones,
                      const std::stop_token& stop);

  [[nodiscard]] AveragedPhases view() const;

 private:
  TwinTable line_;
  std::int32_t tables_ = 0;
};

/// The means of a scene.
AveragedPhaseTables averaged_phases(const scene::Scene& scene, const medium::Medium& medium,
                                    const std::stop_token& stop);

}  // namespace photic::estimator
