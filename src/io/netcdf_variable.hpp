// Variables of netCDF files that a scene names: profiles of floats, tables of optical properties.
#pragma once

#include <string>

#include "scene/netcdf_files.hpp"

namespace photic::io {

/// The dimensions and variables of a file, but for those in groups. Attributes that are not what
/// they should be count as absent.
scene::NetcdfContents netcdf_contents(const std::string& path);

/// A variable of numbers, unpacked (scale_factor, add_offset, _Unsigned), with NaN where it has
/// _FillValue or missing_value or lies outside valid_min, valid_max or valid_range (CF-1.10,
/// sections 2.5.1 and 8.1).
scene::NetcdfVariable netcdf_variable(const std::string& path, const std::string& name);

/// A variable of flags or of names: numbers, single characters, or texts, which may be characters
/// with a dimension more. None where it has NaN, a text of blanks or "nan", or _FillValue or
/// missing_value, unless that is one of flag_values or, without these, from 1 to 9. Bytes of
/// flag_masks have no sign. The meanings of flags are given as the file has them (CF-1.10, section
/// 3.5).
scene::NetcdfCodes netcdf_codes(const std::string& path, const std::string& name);

/// All, for the readers of scenes. They throw EnvironmentError for a file that cannot be read and
/// InputError for one that is of no use, or so large that it is no such table.
scene::NetcdfFiles netcdf_files();

}  // namespace photic::io
