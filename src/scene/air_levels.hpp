// The air that a user gives in files.
#pragma once

#include <string>

#include "optics/data_table.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

/// Reads them from a file: a tape6 of LOWTRAN 7 or MODTRAN, which becomes the columns that a
/// table would have, or else, and always if its name ends in .csv, a table. Throws InputError.
optics::DataTable read_air_levels(const std::string& path);

/// Light that MODTRAN prints as 0, with four digits, counts as this deep.
inline constexpr double opaque_depth = 99;

/// The absorption of gases besides ozone, as optical depths by wavelength: a table as above, or a
/// tape7 of LOWTRAN 7 or MODTRAN, of which molecules' scattering, ozone and aerosols are taken out.
/// Wavelengths are those that Photic has air for. Throws InputError.
optics::DataTable read_gas_depths(const std::string& path);

/// Returns whether the levels of a profile have columns of aerosols.
bool has_own_aerosols(const Atmosphere& air);

}  // namespace photic::scene
