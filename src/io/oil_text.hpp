// What an oil does to light, for the terminal.
#pragma once

#include <string>
#include <vector>

#include "optics/oil.hpp"

namespace photic::io {

/// Its spectra at some wavelengths, its yield and lifetime, and where all of them come from. Throws
/// InputError for wavelengths outside its data.
std::string oil_text(const optics::Oil& oil, const std::vector<double>& wavelength_nm);

}  // namespace photic::io
