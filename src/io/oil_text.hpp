// The effect of an oil on light, for the terminal and as a table for files.
#pragma once

#include <string>
#include <vector>

#include "io/spectral_table.hpp"
#include "optics/oil.hpp"

namespace photic::io {

/// Its spectra at some wavelengths, its yield and lifetime, and where all of them come from. Throws
/// InputError for wavelengths outside its data.
std::string oil_text(const optics::Oil& oil, const std::vector<double>& wavelength_nm);

/// The same for files. A CSV of it is an oil again. Throws InputError for wavelengths outside.
SpectralTable oil_table(const optics::Oil& oil, const std::vector<double>& wavelength_nm);

}  // namespace photic::io
