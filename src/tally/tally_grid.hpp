// The quantities of radiative transfer that are tallied beside echoes, each on a grid of its own.
// One description serves the batches, their sums, the result and its files.
#pragma once

#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/choices.hpp"

namespace photic::tally {

/// A coordinate of a dimension: points, cells between edges, or names.
struct Coordinate {
  std::string name, units = "1", long_name{};
  std::vector<double> values{};                                   ///< of points
  std::vector<double> edges{};                                    ///< of cells, one more than these
  std::vector<std::string> labels{};                              ///< names
  std::vector<std::pair<std::string, std::string>> attributes{};  ///< more of them for files
};

/// A dimension that grids of several quantities may share, by its name.
struct Dimension {
  std::string name;
  std::size_t size = 0;
  std::vector<Coordinate> coordinates{};
};

/// A quantity by the source's strength: so many of its units for each of the grid's.
struct ByStrength {
  double scale = 1;
  std::string units;  ///< "W m-2"
};

/// A quantity on its grid. Its cells, the last dimension fastest, hold a mean over the photons.
struct TallyGrid {
  std::string name;       ///< "irradiance_down"
  std::string long_name;  ///< "downward plane irradiance"
  scene::TallyKind kind{};
  std::string units;
  std::string normalisation;  ///< "per photon emitted", "per unit irradiance across the beam", …
  std::optional<ByStrength> by_strength{};  ///< where the scene gives a strength
  std::vector<Dimension> dimensions{};
  std::vector<double> factor{};  ///< of scores, [cell]; empty: 1
  bool in_balance = false;       ///< a part of where all light ends
  bool is_balance = false;       ///< the sum of all these: nothing is scored in it

  [[nodiscard]] std::size_t size() const {
    return std::transform_reduce(dimensions.begin(), dimensions.end(), std::size_t{1},
                                 std::multiplies(), [](const Dimension& d) { return d.size; });
  }
};

/// The cells of all grids, one grid after the other.
inline std::size_t cells_of(const std::vector<TallyGrid>& grids) {
  return std::transform_reduce(grids.begin(), grids.end(), std::size_t{0}, std::plus(),
                               [](const TallyGrid& grid) { return grid.size(); });
}

}  // namespace photic::tally
