// Columns of water side by side along x, each with layers of its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/twin_table.hpp"
#include "medium/layering.hpp"

namespace photic::medium {

/// A row of columns. The layers of a Medium are those of one column after the other.
struct Row {
  static constexpr double endless = std::numeric_limits<double>::infinity();

  std::vector<std::int32_t> first_layer{0};  ///< of each column
  /// x of the faces of columns, [columns + 1], ascending; the first and the last may be infinite.
  std::vector<double> face_m{-endless, endless};
  double y_min_m = -endless, y_max_m = endless;
  double origin_x_m = 0, origin_y_m = 0;  ///< places in views are relative to

  [[nodiscard]] std::int32_t columns() const {
    return static_cast<std::int32_t>(first_layer.size());
  }
  /// Returns whether it ends somewhere, in x or y.
  [[nodiscard]] bool ends() const {
    return std::isfinite(face_m.front()) || std::isfinite(face_m.back()) ||
           std::isfinite(y_min_m) || std::isfinite(y_max_m);
  }
  /// Returns whether straight light may come to a face.
  [[nodiscard]] bool has_faces() const { return columns() > 1 || ends(); }
  /// The column of a place, which has both faces' sides if it stands on one: the one behind it.
  [[nodiscard]] std::size_t column_at(double x_m) const {
    const auto beyond = std::upper_bound(face_m.begin() + 1, face_m.end() - 1, x_m);
    return static_cast<std::size_t>(beyond - face_m.begin()) - 1;
  }
};

/// A Row as walks see it. Places are relative to the world's origin [m].
struct RowView {
  static constexpr double never = 0x1p100;  ///< farther than all faces [m]

  std::int32_t columns = 1;
  bool has_faces = false;
  ShortTable face;         ///< [columns + 1]
  ShortTable side;         ///< y of the two sides
  IndexTable first_layer;  ///< [columns + 1]
  IndexTable column_of;    ///< [place]

  template <class T>
  [[nodiscard]] Index<T> column(const Index<T>& place) const {
    return columns == 1 ? Index<T>(0) : gather_index<T>(column_of, place);
  }
  /// The uppermost layer of the column that a place is in.
  template <class T>
  [[nodiscard]] Index<T> surface_layer(const Index<T>& place) const {
    if (columns == 1) [[likely]]
      return Index<T>(0);
    return gather_index<T>(first_layer, column<T>(place));
  }
  /// The column of a place at the surface.
  template <class T>
  [[nodiscard]] Index<T> column_at(const T& x) const {
    Index<T> out(0);
    for (std::int32_t k = 1; k < columns; ++k)
      out = out + select(x >= gather<T>(face, Index<T>(k)), Index<T>(1), Index<T>(0));
    return out;
  }
  /// The uppermost layer at such a place.
  template <class T>
  [[nodiscard]] Index<T> surface_layer_at(const T& x) const {
    if (columns == 1) [[likely]]
      return Index<T>(0);
    return gather_index<T>(first_layer, column_at(x));
  }
  /// Returns whether a place lies on top of the row.
  template <class T>
  [[nodiscard]] Mask<T> covers(const T& x, const T& y) const {
    return (x >= gather<T>(face, Index<T>(0))) & (x <= gather<T>(face, Index<T>(columns))) &
           (y >= gather<T>(side, Index<T>(0))) & (y <= gather<T>(side, Index<T>(1)));
  }
  /// The number of a row of a LayeringView that has one for each line and column.
  template <class T>
  [[nodiscard]] Index<T> layering_row(const Index<T>& line, const Index<T>& place) const {
    return columns == 1 ? line : line * Index<T>(columns) + column<T>(place);
  }
  /// LayeringView::layer_of() in the column of `from`.
  template <class T>
  [[nodiscard]] Index<T> layer_of(const LayeringView& layering, const Index<T>& line,
                                  const Index<T>& from, const T& coordinate) const {
    if (columns == 1) [[likely]]
      return layering.layer_of(line, from, coordinate);
    const Index<T> first = surface_layer<T>(from);
    return first + layering.layer_of(layering_row<T>(line, from), from - first, coordinate);
  }
};

/// Owns what a RowView points to.
class RowTables {
 public:
  RowTables() = default;
  /// `beds`: there is a place on the bed of each column, behind all layers.
  RowTables(const Row& row, std::int32_t layers, bool beds);

  [[nodiscard]] RowView view() const;

 private:
  bool has_faces_ = false;
  std::int32_t columns_ = 1;
  TwinTable face_, side_;
  IndexTableOwner first_layer_, column_of_;
};

}  // namespace photic::medium
