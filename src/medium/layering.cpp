#include "medium/layering.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace photic::medium {
namespace {

/// A pack has so many cells in its registers.
constexpr std::int32_t cells_at_once = static_cast<std::int32_t>(table_padding);
/// A float may round a coordinate or an edge into the cell beside its own.
constexpr double rounding = 1e-6;
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

Layering::Layering(std::span<const double> edges, std::int32_t layers, std::span<const double> ends)
    : layers_(layers), cells_((layers / cells_at_once + 1) * cells_at_once), end_(ends) {
  const auto row_length = static_cast<std::size_t>(layers) + 1;
  std::vector<double> per_unit;
  std::vector<std::int32_t> first_layer;
  for (std::size_t row = 0; row < ends.size(); ++row) {
    const auto all_inner = edges.subspan(row * row_length + 1, row_length - 2);
    const auto inner = all_inner.first(static_cast<std::size_t>(
        std::ranges::lower_bound(all_inner, infinite) - all_inner.begin()));
    const double width = (inner.empty() ? 1 : inner.back()) / (cells_ - 1);
    per_unit.push_back(1 / width);
    for (std::int32_t i = 0; i < cells_; ++i) {
      const auto above = std::ranges::lower_bound(inner, i * width * (1 - rounding));
      const auto below = std::ranges::upper_bound(inner, (i + 1) * width * (1 + rounding));
      first_layer.push_back(static_cast<std::int32_t>(above - inner.begin()));
      max_edges_ = std::max(max_edges_, static_cast<std::int32_t>(below - above));
    }
  }
  cells_per_unit_ = TwinTable(per_unit);
  first_layer_ = IndexTableOwner(first_layer);
}

LayeringView Layering::view(const ShortTable& edge) const {
  return {layers_, edge,      end_.view(), cells_per_unit_.view(), first_layer_.view(),
          cells_,  max_edges_};
}

}  // namespace photic::medium
