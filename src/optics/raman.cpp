#include "optics/raman.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace photic::optics {
namespace {

constexpr double nm_per_cm = 1e7;  // wavenumber [1/cm] = 1e7 / wavelength [nm]

Emission bartlett(const Library& library, double laser_nm) {
  const Sourced& b488 = library.raman.at("bartlett_b_488_nm");
  const double b =
      b488.value * std::pow(488.0 / laser_nm, library.raman.at("bartlett_exponent").value);
  return {{{shifted_wavelength_nm(laser_nm, library.raman_band.mean_per_cm()), b}},
          b488.source + "; band " + library.raman_band.source};
}

Emission marshall_smith(const Library& library, double laser_nm) {
  const Sourced& a = library.raman.at("marshall_smith_a");
  const double resonance = library.raman.at("marshall_smith_resonance").value;
  const double raman_nm =
      shifted_wavelength_nm(laser_nm, library.raman.at("marshall_smith_shift").value);
  const double nu_laser = nm_per_cm / laser_nm;
  const double nu_raman = nm_per_cm / raman_nm;
  const double b =
      a.value * std::pow(nu_raman, 4) / std::pow(resonance * resonance - nu_laser * nu_laser, 2);
  // The coefficient is of energy; a Raman photon has less of it than the laser's.
  return {{{raman_nm, b * raman_nm / laser_nm}}, a.source};
}

}  // namespace

double shifted_wavelength_nm(double laser_nm, double shift_per_cm) {
  const double wavenumber = nm_per_cm / laser_nm - shift_per_cm;
  if (!(wavenumber > 0)) {
    throw InputError({{"", 0, 0,
                       fmt::format("no Raman light from {:.6g} nm: water's shift is {:.6g} 1/cm",
                                   laser_nm, shift_per_cm),
                       "choose a shorter wavelength"}});
  }
  return nm_per_cm / wavenumber;
}

Emission raman(const Library& library, const std::string& model, double laser_nm) {
  if (model == "bartlett") return bartlett(library, laser_nm);
  if (model == "marshall-smith") return marshall_smith(library, laser_nm);
  no_model("Raman", model, "bartlett, marshall-smith");
}

}  // namespace photic::optics
