// The dimensions of the variables of a profile.
#pragma once

#include <optional>
#include <string>

#include "scene/netcdf_columns.hpp"
#include "scene/netcdf_shape.hpp"

namespace photic::scene {

/// The values of a profile, with the dimensions (levels) or (profiles, levels) besides those of
/// length one.
struct Layout {
  Shape shape;
  std::size_t level_axis = 0;
  std::optional<std::size_t> profile_axis;
  Alignment depth;                  ///< of the depth of a value
  bool has_own_dimensions = false;  ///< which the depth does not share, for all that they are alike
};

/// The layout of the variables of these names. Throws InputError if they have other dimensions.
[[nodiscard]] Layout layout_of(const NetcdfColumns& file, const std::string& value,
                               const std::string& depth);

}  // namespace photic::scene
