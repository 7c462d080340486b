// Variables of netCDF files that a scene names: profiles of floats, tables of optical properties.
#pragma once

#include <string>
#include <vector>

#include "scene/netcdf_files.hpp"

namespace photic::io {

/// The names of the variables in a file.
std::vector<std::string> netcdf_names(const std::string& path);

/// A variable of numbers, unpacked (scale_factor, add_offset, _Unsigned), with NaN where it has
/// _FillValue or missing_value or lies outside valid_min, valid_max or valid_range (CF-1.10,
/// sections 2.5.1 and 8.1).
scene::NetcdfVariable netcdf_variable(const std::string& path, const std::string& name);

/// A variable of flags of so many dimensions: of numbers, or of the digits 0 to 9, each a character
/// as floats write them or a text, which may be characters with a dimension more; NaN for any other
/// character; and what they mean, where flag_values and flag_meanings tell (CF-1.10, section 3.5).
/// Flags of single bits (flag_masks) are refused.
scene::NetcdfVariable netcdf_flags(const std::string& path, const std::string& name,
                                   std::size_t rank);

/// All, for those who read scenes. They throw EnvironmentError for a file that cannot be read and
/// InputError for one that is of no use, or so large that it is no such table.
scene::NetcdfFiles netcdf_files();

}  // namespace photic::io
