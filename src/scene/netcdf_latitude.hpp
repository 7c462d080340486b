// The place where a profile of a netCDF file was taken.
#pragma once

#include <optional>

#include "scene/netcdf_casts.hpp"

namespace photic::scene {

/// In the mean over its levels; nothing if the file does not have it.
[[nodiscard]] std::optional<double> latitude_deg(const NetcdfColumns& file, const Layout& layout,
                                                 const Cast& cast);

}  // namespace photic::scene
