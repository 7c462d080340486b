// Grids: what of an echo is tallied apart, by order, process or depth. One description serves the
// batches, their sums, the result and its files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace photic::tally {

/// The properties of a score by which the cells of a grid differ.
enum class Quantity : std::uint8_t { order, process, depth };

/// An axis of a grid. Its cells are counted from 0, the last one with all above; or they have
/// names; or they lie between edges. Axes of one quantity are the same in all grids.
struct Axis {
  std::string name{}, units = "1", long_name{};
  Quantity quantity = Quantity::order;
  std::size_t count = 0;                                          ///< of cells that are counted
  std::vector<std::string> labels{};                              ///< of cells with names
  std::vector<double> edges{};                                    ///< cells + 1, evenly spaced
  std::vector<std::pair<std::string, std::string>> attributes{};  ///< more of them for files

  [[nodiscard]] std::size_t size() const {
    if (!labels.empty()) return labels.size();
    return edges.empty() ? count : edges.size() - 1;
  }
};

/// The one profile has one axis, by depth. The first grid of parts is by order and the second one
/// by process; further ones may be by both.
struct Grid {
  std::string name;        ///< "echo_by_order"
  std::string long_name;   ///< "by order of scattering"
  std::string part{};      ///< the contents of one of its cells: "echo of an order"
  std::vector<Axis> axes;  ///< the last one fastest
  /// Profiles are long and mostly empty: they have no flags, and files hold them in single
  /// precision behind the gate. Other grids are before the gate, with flags of their own.
  bool profile = false;
  std::vector<bool> beside_walks{};  ///< [cell] whose light no walk carries; no further one is

  /// Cells for each gate.
  [[nodiscard]] std::size_t size() const {
    return std::transform_reduce(axes.begin(), axes.end(), std::size_t{1}, std::multiplies(),
                                 [](const Axis& axis) { return axis.size(); });
  }
};

/// The grids that echoes are tallied on; a new one is described here. Orders count from 0, light
/// that has been neither scattered nor converted, and the last one has all above. `depths`: edges
/// [m]; none: no grid by depth.
std::vector<Grid> echo_grids(std::size_t orders, std::vector<std::string> processes,
                             std::vector<double> depths);

}  // namespace photic::tally
