// The output of LOWTRAN 7 and MODTRAN about the air: the profiles in a tape6, the transmittances in
// a tape7. Columns are found by their names, since versions add some. Those of a tape7 have fixed
// widths, and names of seven letters fill theirs: they touch.
//
// A problem is an InputError with file, line and column.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "optics/atmosphere.hpp"

namespace photic::optics {

/// The profile of a tape6: its blocks "ATMOSPHERIC PROFILES" with the columns MOL SCAT and O3 (UV)
/// and with AEROSOL 1 to 4 and RH. One run in a file.
AirProfile modtran_profile(const std::string& text, const std::string& name);

/// Returns whether a text looks like a tape6: it has the head of one or a title of profiles.
bool is_tape6(const std::string& text);

/// Returns whether a text looks like a tape7: a line of it begins with FREQ, and it is no tape6,
/// whose tables of spectra begin so too.
bool is_tape7(const std::string& text);

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

  /// Linear between wavenumbers. Of the columns "-LOG COMBIN" and "COMBIN TRANS", it takes the one
  /// that rounds less. Throws InputError for a column or wavelength that is not there, or a
  /// transmittance that is printed as 0.
  [[nodiscard]] RoundedDepth optical_depth(const std::string& column, double wavelength_nm) const;

  /// Through the same depth; 0 beside a transmittance that is printed as 0. Throws as above, but
  /// not for those.
  [[nodiscard]] double transmittance(const std::string& column, double wavelength_nm) const;

  /// The wavelengths of the rows, ascending.
  [[nodiscard]] std::vector<double> wavelengths_nm() const;

 private:
  struct Cell {
    double value = 0, rounding = 0;  ///< half a unit of the last digit printed
  };
  /// Between the rows `above` - 1 and `above`, from 0 to 1.
  struct Between {
    std::size_t above = 1;
    double t = 0;
  };
  [[nodiscard]] Between between_rows(const std::string& column, double wavelength_nm) const;
  /// Infinite where the transmittance is printed as 0.
  [[nodiscard]] RoundedDepth at_row(const std::string& column, std::size_t row) const;
  [[noreturn]] void fail_opaque(const std::string& column, std::size_t row) const;

  std::string name_;
  int names_line_ = 0;
  std::vector<double> wavenumber_per_cm_;  ///< strictly ascending
  std::vector<int> line_;                  ///< of each row
  std::map<std::string, std::vector<Cell>> cells_;
};

}  // namespace photic::optics
