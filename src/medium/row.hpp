// Columns of water side by side along x, each with layers of its own.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace photic::medium {

/// A row of columns. The layers of a Medium are those of one column after the other.
struct Row {
  std::vector<std::int32_t> first_layer{0};  ///< of each column
  /// x of the faces of columns, [columns + 1], ascending; the first and the last may be infinite.
  std::vector<double> face_m{-std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};
  double y_min_m = -std::numeric_limits<double>::infinity();
  double y_max_m = std::numeric_limits<double>::infinity();

  [[nodiscard]] std::int32_t columns() const {
    return static_cast<std::int32_t>(first_layer.size());
  }
};

}  // namespace photic::medium
