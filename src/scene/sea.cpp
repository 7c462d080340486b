#include "scene/sea.hpp"

#include <fmt/format.h>

namespace photic::scene {

bool Surface::is_rough() const {
  switch (model) {
    case SurfaceModel::flat:
      return false;
    case SurfaceModel::gaussian:
      return upwind_slope_variance > 0 || crosswind_slope_variance > 0;
    case SurfaceModel::cox_munk:
    case SurfaceModel::paper:
      return wind_speed_m_s > 0;
  }
  return false;
}

bool Surface::is_one_dimensional() const {
  if (!is_rough()) return false;
  return model == SurfaceModel::paper ||
         (model == SurfaceModel::gaussian &&
          (upwind_slope_variance == 0 || crosswind_slope_variance == 0));
}

bool Surface::has_whitecaps() const {
  if (!is_rough()) return false;
  if (whitecaps) return *whitecaps;
  return whitecap_fraction || (model == SurfaceModel::cox_munk && !slick);
}

bool Sea::ends() const {
  return !column.empty() && (column.front().x_min_m || column.back().x_max_m || y_min_m || y_max_m);
}

std::vector<Stack> stacks_of(const Sea& sea) {
  if (sea.column.empty()) return {{sea.layer, "sea.layer", "sea.layer", ""}};
  std::vector<Stack> out;
  for (const Column& column : sea.column)
    out.push_back({column.layer, fmt::format("sea.column.{}.layer", out.size()), "sea.column.layer",
                   column.name});
  return out;
}

std::vector<PlacedBed> beds_of(const Sea& sea, const std::optional<Bottom>& of_all) {
  if (sea.column.empty()) return {{of_all, "bottom"}};
  std::vector<PlacedBed> out;
  for (const Column& column : sea.column) {
    const std::string own = fmt::format("sea.column.{}.bottom", out.size());
    out.push_back(column.bottom ? PlacedBed{column.bottom, own} : PlacedBed{of_all, "bottom"});
  }
  return out;
}

std::vector<PlacedLayer> layers_of(const Sea& sea) {
  std::vector<PlacedLayer> out;
  for (const Stack& stack : stacks_of(sea)) {
    double top_m = 0;
    for (std::size_t i = 0; i < stack.layer.size(); ++i) {
      const Layer& layer = stack.layer[i];
      out.push_back({layer, fmt::format("{}.{}", stack.path, i),
                     (stack.name.empty() ? "" : stack.name + '/') + layer.name, top_m});
      top_m = layer.bottom_depth_m.value_or(top_m);
    }
  }
  return out;
}

std::string name_in(const Sea& sea, const Layer& layer) {
  for (const PlacedLayer& at : layers_of(sea))
    if (&at.layer == &layer) return at.name;
  return layer.name;
}

}  // namespace photic::scene
