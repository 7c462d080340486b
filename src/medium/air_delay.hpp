// By how much the air makes group paths longer than in a vacuum.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace photic::medium {

/// The delay of a line, from the sea straight up to the edges of the air's layers [m]; no edges
/// where the air is clear.
struct AirDelay {
  std::vector<double> height_m, delay_m;  ///< the first is 0

  [[nodiscard]] bool exists() const { return !height_m.empty(); }
  /// Group index less 1, at a height: of the layer above an edge; 0 above them all.
  [[nodiscard]] double per_metre(double height) const {
    const std::size_t above = first_above(height);
    if (above == 0 || above == height_m.size()) return 0;
    return (delay_m[above] - delay_m[above - 1]) / (height_m[above] - height_m[above - 1]);
  }
  /// From the sea straight up to a height, 0 or more.
  [[nodiscard]] double to(double height) const {
    if (!exists()) return 0;
    const std::size_t below = first_above(height) - 1;
    return delay_m[below] + per_metre(height) * (height - height_m[below]);
  }

 private:
  /// The first edge above a height.
  [[nodiscard]] std::size_t first_above(double height) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(height_m, height) - height_m.begin());
  }
};

}  // namespace photic::medium
