// Quantities that depend on the wavelength alone, as files: the spectra of an oil, transmittances
// of the air.
#pragma once

#include <string>
#include <vector>

#include "io/optics_file.hpp"

namespace photic::io {

struct SpectralTable {
  struct Column {
    std::string name;     ///< in files: letters, digits, underscores
    std::string heading;  ///< on the terminal
    std::string long_name, units;
    std::vector<double> values;  ///< at each wavelength
  };
  struct Number {
    std::string name, long_name, units;
    double value = 0;
  };
  std::string what;  ///< "optical properties of an oil"
  std::vector<double> wavelength_nm = {};
  std::vector<Column> columns = {};
  std::vector<Number> numbers = {};
  std::vector<std::string> sources = {};
};

/// A row for each wavelength after a head of lines that start with '#', with the numbers as
/// "# name: value"; so that a table of oils is an oil again.
std::string spectral_csv(const SpectralTable& table, const OpticsOrigin& origin);

/// Ends with a newline.
std::string spectral_json(const SpectralTable& table);

/// Columns side by side.
std::string spectral_text(const SpectralTable& table);

/// Writes spectral_csv, or a netCDF-4 file after CF-1.10 where the name ends in ".nc": whole or not
/// at all. Throws EnvironmentError.
void write_spectral(const SpectralTable& table, const OpticsOrigin& origin,
                    const std::string& path);

}  // namespace photic::io
