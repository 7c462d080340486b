#include "optics/raman.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace photic::optics {
namespace {

constexpr double nm_per_cm = 1e7;  // wavenumber [1/cm] = 1e7 / wavelength [nm]

/// The part of the laser's energy that a Raman photon has left [1/cm]; none if the shift takes all.
std::optional<double> left_after(double shift_per_cm, double laser_nm) {
  const double wavenumber = nm_per_cm / laser_nm - shift_per_cm;
  return wavenumber > 0 ? std::optional(wavenumber) : std::nullopt;
}

/// Walrafen's band with so many photons per metre: per nm, a shift's density times 1e7 / nm^2.
EmissionSpectrum walrafen(const Library& library, double laser_nm, double photons_per_m) {
  constexpr double first = 2850, last = 3900, step = 5;  // [1/cm]; 1e-5 of the band lies outside
  std::vector<double> nm, per_nm;
  for (double shift = first; shift <= last; shift += step) {
    const auto left = left_after(shift, laser_nm);
    if (!left) break;
    nm.push_back(nm_per_cm / *left);
    per_nm.push_back(photons_per_m * library.raman_band.density_cm(shift) * *left * *left /
                     nm_per_cm);
  }
  return {nm, per_nm};
}

/// With as many photons per metre at the shift as given.
Emission emission_at(const Library& library, double shift_per_cm, double laser_nm,
                     double photons_per_m, const std::string& source) {
  const auto left = left_after(shift_per_cm, laser_nm);
  if (!left) return {{}, {}, source};
  return {EmissionLine{nm_per_cm / *left, photons_per_m},
          walrafen(library, laser_nm, photons_per_m),
          source + "; band " + library.raman_band.source};
}

Emission bartlett(const Library& library, double laser_nm) {
  const Sourced& b488 = library.raman.at("bartlett_b_488_nm");
  const double b =
      b488.value * std::pow(488.0 / laser_nm, library.raman.at("bartlett_exponent").value);
  return emission_at(library, library.raman_band.mean_per_cm(), laser_nm, b, b488.source);
}

Emission marshall_smith(const Library& library, double laser_nm) {
  const Sourced& a = library.raman.at("marshall_smith_a");
  const double resonance = library.raman.at("marshall_smith_resonance").value;
  const double shift = library.raman.at("marshall_smith_shift").value;
  const double nu_laser = nm_per_cm / laser_nm;
  const double nu_raman = nu_laser - shift;
  const double b =
      a.value * std::pow(nu_raman, 4) / std::pow(resonance * resonance - nu_laser * nu_laser, 2);
  // The coefficient is of energy; a Raman photon has less of it than the laser's.
  return emission_at(library, shift, laser_nm, b * nu_laser / nu_raman, a.source);
}

}  // namespace

Emission raman(const Library& library, const std::string& model, double laser_nm) {
  if (model == "bartlett") return bartlett(library, laser_nm);
  if (model == "marshall-smith") return marshall_smith(library, laser_nm);
  no_model("Raman", model, "bartlett, marshall-smith");
}

}  // namespace photic::optics
