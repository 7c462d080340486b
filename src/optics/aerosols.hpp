// Aerosols of the air: their extinction, absorption and direction of scattering by wavelength and
// relative humidity. The amount of aerosol is in an AirProfile.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "optics/data_table.hpp"
#include "optics/phase_table.hpp"

namespace photic::optics {

class AirLibrary;

/// Phase functions are wanted or not: Mie theory takes seconds for them.
enum class Phases { wanted, left_out };

struct AerosolOptics {
  double extinction = 0, absorption = 0;  ///< over the extinction at 550 nm
  double g = 0;                           ///< mean cosine of what is scattered
  PhaseShape phase;                       ///< none where it is left out
  std::string source;

  [[nodiscard]] double scattering() const { return extinction - absorption; }
  [[nodiscard]] double albedo() const { return scattering() / extinction; }
};

/// A model in a table: the coefficients over the extinction at 550 nm at wavelengths and, if they
/// depend on it, relative humidities.
class AerosolModel {
 public:
  explicit AerosolModel(const DataTable& table);

  /// Linear in the logarithms of wavelength and coefficient (a straight line where one is 0), and
  /// in ln(100 - humidity) and the logarithm of coefficients, with humidities clamped at 99
  /// (Kneizys et al. 1988). The phase function is Henyey's and Greenstein's. Throws InputError for
  /// a wavelength outside the table.
  [[nodiscard]] AerosolOptics at(double wavelength_nm, double relative_humidity_percent) const;

 private:
  /// At one humidity.
  struct Columns {
    std::vector<double> extinction, absorption, g;
  };
  static Columns columns(const DataTable& table, const std::string& suffix);

  std::vector<double> wavelength_nm_;
  std::vector<double> humidity_percent_;  ///< ascending
  std::vector<Columns> at_humidity_;
  std::string source_;
};

/// By name: Shettle & Fenn's "rural", "maritime", "urban", "tropospheric", LOWTRAN 7's
/// "fog-advection", "fog-radiation", "stratospheric", "meteoric", or a component of OPAC at a
/// relative humidity of its own, as in "opac-waso-80". Throws InputError.
AerosolOptics aerosol_optics(const AirLibrary& library, const std::string& model,
                             double wavelength_nm, double relative_humidity_percent,
                             Phases phases = Phases::wanted, const std::stop_token& stop = {});

}  // namespace photic::optics
