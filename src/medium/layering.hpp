// Layers by their edges, in any coordinate that grows with depth, and how lanes find the one that
// they are in without looking through all of them.
#pragma once

#include <cstdint>
#include <span>

#include "core/lanes.hpp"
#include "core/twin_table.hpp"

namespace photic::medium {

/// Edges of layers, for each of some rows. Down to the last of the inner ones a row is cut into
/// cells of one length, but for the last cell, which has no end; of each it is known in which layer
/// it begins.
struct LayeringView {
  std::int32_t layers = 0;
  ShortTable edge;            ///< upper ones, and the last one's lower, [row][layers + 1]
  ShortTable end;             ///< the last one's lower edge again, [row]
  ShortTable cells_per_unit;  ///< of the coordinate, [row]
  IndexTable first_layer;     ///< [row][cells]
  std::int32_t cells = 0;
  std::int32_t max_edges = 0;  ///< inner ones, in any cell

  /// The layer in which a coordinate lies (the first or the last if in none); on an edge it is
  /// `from`, if that is one of the two, else the upper one. The edges in its cell are tried by
  /// quarters, for among many lanes one always has far to go; the three of a step do not wait for
  /// each other.
  template <class T>
  [[nodiscard]] Index<T> layer_of(const Index<T>& row, const Index<T>& from,
                                  const T& coordinate) const {
    if (layers == 1) return from;
    Index<T> layer = gather_index<T>(first_layer, row * Index<T>(cells) + cell(row, coordinate));
    const Index<T> first_edge = row * Index<T>(layers + 1);
    const Index<T> last(layers - 1);
    std::int32_t step = 1;
    while (4 * step <= max_edges) step *= 4;
    for (; step > 0; step /= 4) {
      const Index<T> first = layer;
      for (std::int32_t k = 1; k < 4 && k * step <= max_edges; ++k) {
        const Index<T> next = first + Index<T>(k * step);
        const Mask<T> exists = next <= last;
        const T upper_edge = gather<T>(edge, first_edge + select(exists, next, last));
        const Mask<T> within =
            (coordinate > upper_edge) | ((coordinate == upper_edge) & (next == from));
        layer = select(exists & within, next, layer);
      }
    }
    return layer;
  }

 private:
  /// The cell that holds a coordinate; the first, if it is not a number.
  template <class T>
  [[nodiscard]] Index<T> cell(const Index<T>& row, const T& coordinate) const {
    const T place = coordinate * gather<T>(cells_per_unit, row);
    const T last = T(static_cast<double>(cells - 1));
    return floor_index(select(place > T(0), select(place < last, place, last), T(0)));
  }
};

/// Owns what a LayeringView points to, but for the edges.
class Layering {
 public:
  Layering() = default;
  /// Takes some layers' edges, which ascend in each row, and where each row ends. Of a row with
  /// fewer layers all edges from its end on are infinite: [row][layers + 1].
  Layering(std::span<const double> edges, std::int32_t layers, std::span<const double> ends);

  [[nodiscard]] LayeringView view(const ShortTable& edge) const;

 private:
  std::int32_t layers_ = 0, cells_ = 0, max_edges_ = 0;
  TwinTable end_, cells_per_unit_;
  IndexTableOwner first_layer_;
};

}  // namespace photic::medium
