// What the air does to light, for the terminal.
#pragma once

#include <string>
#include <vector>

#include "optics/air.hpp"

namespace photic::io {

/// Vertical optical depths of all layers, by what is in them, and where they come from. Throws
/// InputError for wavelengths without data.
std::string air_text(const optics::AirLibrary& library, const optics::AirProfile& profile,
                     const optics::AerosolChoice& aerosols,
                     const std::vector<double>& wavelength_nm);

}  // namespace photic::io
