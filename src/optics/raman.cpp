#include "optics/raman.hpp"

#include <cmath>
#include <optional>

namespace photic::optics {
namespace {

constexpr double nm_per_cm = 1e7;  // wavenumber [1/cm] = 1e7 / wavelength [nm]

/// What a Raman photon has left of the laser's energy [1/cm]; none if the shift takes all.
std::optional<double> left_after(double shift_per_cm, double laser_nm) {
  const double wavenumber = nm_per_cm / laser_nm - shift_per_cm;
  return wavenumber > 0 ? std::optional(wavenumber) : std::nullopt;
}

Emission bartlett(const Library& library, double laser_nm) {
  const Sourced& b488 = library.raman.at("bartlett_b_488_nm");
  Emission out{{}, b488.source + "; band " + library.raman_band.source};
  const double b =
      b488.value * std::pow(488.0 / laser_nm, library.raman.at("bartlett_exponent").value);
  if (const auto nu_raman = left_after(library.raman_band.mean_per_cm(), laser_nm))
    out.lines.push_back({nm_per_cm / *nu_raman, b});
  return out;
}

Emission marshall_smith(const Library& library, double laser_nm) {
  const Sourced& a = library.raman.at("marshall_smith_a");
  const double resonance = library.raman.at("marshall_smith_resonance").value;
  Emission out{{}, a.source};
  const auto left = left_after(library.raman.at("marshall_smith_shift").value, laser_nm);
  if (!left) return out;
  const double raman_nm = nm_per_cm / *left;
  const double nu_laser = nm_per_cm / laser_nm;
  const double nu_raman = nm_per_cm / raman_nm;
  const double b =
      a.value * std::pow(nu_raman, 4) / std::pow(resonance * resonance - nu_laser * nu_laser, 2);
  // The coefficient is of energy; a Raman photon has less of it than the laser's.
  out.lines.push_back({raman_nm, b * raman_nm / laser_nm});
  return out;
}

}  // namespace

Emission raman(const Library& library, const std::string& model, double laser_nm) {
  if (model == "bartlett") return bartlett(library, laser_nm);
  if (model == "marshall-smith") return marshall_smith(library, laser_nm);
  no_model("Raman", model, "bartlett, marshall-smith");
}

}  // namespace photic::optics
