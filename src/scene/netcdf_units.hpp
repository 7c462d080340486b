// Units of a netCDF variable, for the keys of a scene that its values stand for.
#pragma once

#include <string>
#include <vector>

#include "scene/netcdf_columns.hpp"
#include "scene/units.hpp"

namespace photic::scene {

/// From the variable's units to those that the name of a key ends in. Throws InputError for units
/// that are missing or not understood.
[[nodiscard]] Conversion conversion_of(const NetcdfColumns& file, const std::string& name,
                                       const NetcdfVariable& variable, const std::string& key);

/// A text on what is wrong with a variable's units.
[[nodiscard]] std::string units_text(const NetcdfVariable& variable);

/// Returns whether its values, in m or another unit, are heights and no depths (CF-1.10, section
/// 4.3). Throws InputError if its attribute does not show it.
[[nodiscard]] bool points_up(const NetcdfColumns& file, const std::string& name,
                             const NetcdfVariable& variable);

}  // namespace photic::scene
