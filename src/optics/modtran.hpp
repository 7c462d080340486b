// What LOWTRAN 7 and MODTRAN print about the air: the profiles in a tape6, the transmittances in a
// tape7. Columns are found by their names, since versions add some.
//
// Whatever is wrong is an InputError with file, line and column.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "optics/atmosphere.hpp"

namespace photic::optics {

/// The profile of a tape6: its blocks "ATMOSPHERIC PROFILES" with the columns MOL SCAT and O3 (UV)
/// and with AEROSOL 1 to 4 and RH. One run in a file.
AirProfile modtran_profile(const std::string& text, const std::string& name);

/// An optical depth, and how far off it may be because the file has so few digits.
struct RoundedDepth {
  double value = 0, rounding = 0;
};

/// A tape7 of transmittances (IEMSCT = 0). One run in a file.
class ModtranTransmittances {
 public:
  ModtranTransmittances(const std::string& text, const std::string& name);

  /// The two lines of names as one: "COMBIN TRANS", "O3 TRANS", "MOLEC SCAT", "AER+CLD TRANS", …
  [[nodiscard]] std::vector<std::string> columns() const;

  /// Linear between wavenumbers. Where there is a column "-LOG COMBIN" beside "COMBIN TRANS", the
  /// one that rounds less. Throws InputError for a column or wavelength that is not there, or a
  /// transmittance that is printed as 0.
  [[nodiscard]] RoundedDepth optical_depth(const std::string& column, double wavelength_nm) const;

 private:
  struct Cell {
    double value = 0, rounding = 0;  ///< half a unit of the last digit printed
  };
  [[nodiscard]] RoundedDepth at_row(const std::string& column, std::size_t row) const;

  std::string name_;
  int names_line_ = 0;
  std::vector<double> wavenumber_per_cm_;  ///< strictly ascending
  std::vector<int> line_;                  ///< of each row
  std::map<std::string, std::vector<Cell>> cells_;
};

}  // namespace photic::optics
