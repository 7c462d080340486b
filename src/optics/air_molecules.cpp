#include "optics/air_molecules.hpp"

#include <algorithm>

#include "core/constants.hpp"
#include "optics/air_library.hpp"

namespace photic::optics {
namespace {

constexpr double m2_per_cm2 = 1e-4;

/// King factor of air: Bodhaine et al. 1999, eq. (23), of the shares of its gases by volume in per
/// cent and the factors of Bates 1984 for nitrogen and oxygen.
double king_factor(double nm) {
  const double k2 = 1e6 / (nm * nm);  // 1/um^2
  constexpr double nitrogen = 78.084, oxygen = 20.946, argon = 0.934, carbon_dioxide = 0.036;
  const double of_nitrogen = 1.034 + 3.17e-4 * k2;
  const double of_oxygen = 1.096 + 1.385e-3 * k2 + 1.448e-4 * k2 * k2;
  constexpr double of_argon = 1.00, of_carbon_dioxide = 1.15;
  return (nitrogen * of_nitrogen + oxygen * of_oxygen + argon * of_argon +
          carbon_dioxide * of_carbon_dioxide) /
         (nitrogen + oxygen + argon + carbon_dioxide);
}

}  // namespace

double air_scattering_m2(double nm) {
  if (!(nm >= air_min_nm && nm <= air_max_nm))
    no_data("air scattering", nm, air_scattering_source, air_min_nm, air_max_nm,
            "choose another wavelength");
  const double l2 = nm * nm * 1e-6;  // um^2
  return 1e-28 * m2_per_cm2 * (1.0455996 - 341.29061 / l2 - 0.90230850 * l2) /
         (1 + 0.0027059889 / l2 - 85.968563 * l2);
}

double air_depolarisation(double nm) {
  const double f = king_factor(nm);  // (6 + 3 rho) / (6 - 7 rho)
  return 6 * (f - 1) / (3 + 7 * f);
}

double standard_air_index(double nm) {
  const double k2 = 1e6 / (nm * nm);  // 1/um^2
  return 1 + (5792105 / (238.0185 - k2) + 167917 / (57.362 - k2)) * 1e-8;
}

double air_group_over_phase(double nm) {
  const double k2 = 1e6 / (nm * nm);
  // -L d/dL is 2 k2 d/dk2.
  const double a = 238.0185 - k2, b = 57.362 - k2;
  const double slope = 2 * k2 * (5792105 / (a * a) + 167917 / (b * b)) * 1e-8;
  return 1 + slope / (standard_air_index(nm) - 1);
}

double air_index(double nm, double molecules_per_m3) {
  constexpr double standard_per_m3 = 101325 / (boltzmann_j_k * 288.15);
  return 1 + (standard_air_index(nm) - 1) * molecules_per_m3 / standard_per_m3;
}

Sourced ozone_absorption_m2(const AirLibrary& library, double nm, double temperature_k) {
  const Spectrum& c0 = library.ozone_c0;
  if (nm < c0.values.min()) {
    no_data("ozone absorption", nm, c0.source, c0.values.min(), c0.values.max(),
            "choose another wavelength");
  }
  if (nm > c0.values.max()) {
    const Spectrum& warm = library.ozone_293k;
    if (!warm.values.covers(nm)) {
      no_data("ozone absorption", nm, warm.source, warm.values.min(), warm.values.max(),
              "choose another wavelength");
    }
    return {m2_per_cm2 * warm.values(nm), warm.source};
  }
  constexpr double coldest_k = 226, warmest_k = 298;  // that were measured
  const double t = std::clamp(temperature_k, coldest_k, warmest_k) - 273.13;
  const double e20_cm2 =
      c0.values(nm) + library.ozone_c1.values(nm) * t + library.ozone_c2.values(nm) * t * t;
  return {1e-20 * m2_per_cm2 * std::max(0.0, e20_cm2), c0.source};
}

}  // namespace photic::optics
