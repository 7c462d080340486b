// Suggestions where a profile of a netCDF file lacks two levels with a depth and a value.
#pragma once

#include <string>

#include "scene/netcdf_casts.hpp"

namespace photic::scene {

[[nodiscard]] std::string instead_of(const NetcdfColumns& file, const Casts& casts,
                                     const Cast& cast, const ProfileVariable& value,
                                     const ProfileVariable& depth);

}  // namespace photic::scene
