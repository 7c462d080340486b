#include "optics/water_scattering.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "optics/air_molecules.hpp"
#include "optics/refractive_index.hpp"

namespace photic::optics {
namespace {

// The equations of Zhang, Hu & He 2009, Opt. Express 17, 5698, with the sources they take their
// terms from. S in PSU, T in C.
constexpr const char* scattering = "water scattering";
constexpr const char* zhang_source = "Zhang, Hu & He 2009, Opt. Express 17, 5698 [verified]";
constexpr double depolarisation = 0.039;  // Farinato & Rowell 1976, J. Chem. Phys. 65, 593
constexpr double molar_mass_kg = 0.018;   // of water

/// [1/Pa], at one atmosphere. Millero et al. 1980, Deep-Sea Res. 27A, 255.
double isothermal_compressibility(double s, double t) {
  const double t2 = t * t, t3 = t2 * t, t4 = t3 * t;
  const double water =
      19652.21 + 148.4206 * t - 2.327105 * t2 + 1.360477e-2 * t3 - 5.155288e-5 * t4;
  const double a = 54.6746 - 0.603459 * t + 1.09987e-2 * t2 - 6.167e-5 * t3;
  const double b = 7.944e-2 + 1.6483e-2 * t - 5.3009e-4 * t2;
  return 1e-5 / (water + a * s + b * s * std::sqrt(s));
}

/// [kg/m^3], at one atmosphere. UNESCO 1981, Tech. Pap. Mar. Sci. 36.
double density(double s, double t) {
  const double t2 = t * t, t3 = t2 * t, t4 = t3 * t, t5 = t4 * t;
  const double water = 999.842594 + 6.793952e-2 * t - 9.09529e-3 * t2 + 1.001685e-4 * t3 -
                       1.120083e-6 * t4 + 6.536332e-9 * t5;
  const double a = 8.24493e-1 - 4.0899e-3 * t + 7.6438e-5 * t2 - 8.2467e-7 * t3 + 5.3875e-9 * t4;
  const double b = -5.72466e-3 + 1.0227e-4 * t - 1.6546e-6 * t2;
  return water + a * s + b * s * std::sqrt(s) + 4.8314e-4 * s * s;
}

/// Derivative of the logarithm of water's activity by salinity. Millero & Leung 1976, Am. J. Sci.
/// 276, 1035.
double activity_per_psu(double s, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (-5.58651e-4 + 2.40452e-7 * t - 3.12165e-9 * t2 + 2.40808e-11 * t3) +
         1.5 * (1.79613e-5 - 9.9422e-8 * t + 2.08919e-9 * t2 - 1.39872e-11 * t3) * std::sqrt(s) +
         2 * (-2.31065e-6 - 1.37674e-9 * t - 1.93316e-11 * t2) * s;
}

/// rho d(n^2)/d(rho) by the model of Proutiere, Megnassan & Hucteau 1992, J. Phys. Chem. 96, 3485.
double density_derivative(double n) {
  const double n2 = n * n;
  const double f = n / 3 - 1 / (3 * n);
  return (n2 - 1) * (1 + 2.0 / 3 * (n2 + 2) * f * f);
}

double zhang(double nm, double s, double t) {
  if (!(nm >= refractive_index_min_nm && nm <= refractive_index_max_nm))
    no_data(scattering, nm, zhang_source, refractive_index_min_nm, refractive_index_max_nm);
  const double air = standard_air_index(nm);
  const double n = refractive_index(nm, s, t) * air;
  const double dn_ds = refractive_index_per_psu(nm, t) * air;
  const double lambda4 = std::pow(nm * 1e-9, 4);
  const double derivative = density_derivative(n);
  const double from_density = pi * pi / 2 / lambda4 * boltzmann_j_k * (t + 273.15) *
                              isothermal_compressibility(s, t) * derivative * derivative;
  const double from_salt = 2 * pi * pi / lambda4 * n * n * s * molar_mass_kg * dn_ds * dn_ds /
                           (-density(s, t) * activity_per_psu(s, t) * avogadro_per_mol);
  const double cabannes = (6 + 6 * depolarisation) / (6 - 7 * depolarisation);
  const double at_90_degrees = cabannes * (from_density + from_salt);
  return 8 * pi / 3 * at_90_degrees * (2 + depolarisation) / (1 + depolarisation);
}

// Morel 1974, in Optical Aspects of Oceanography, Academic Press: pure water scatters
// 0.00222 (500 / nm)^4.32, the sea 1.30 times as much at 37 PSU, and in proportion between (as
// Twardowski et al. 2007, Biogeosciences 4, 1041, take it). Measured at 350-600 nm; taken to
// 200-800 by Smith & Baker 1981, Appl. Opt. 20, 177, whose table it reproduces.
constexpr const char* morel_source =
    "Morel 1974, in Optical Aspects of Oceanography, Academic Press [verified]";
constexpr double morel_min_nm = 200, morel_max_nm = 800;

double morel(double nm, double s) {
  if (!(nm >= morel_min_nm && nm <= morel_max_nm))
    no_data(scattering, nm, morel_source, morel_min_nm, morel_max_nm);
  return 0.00222 * std::pow(500 / nm, 4.32) * (1 + 0.30 * s / 37);
}

}  // namespace

Sourced water_scattering_per_m(const Library& library, const std::string& model,
                               double wavelength_nm, double salinity_psu, double temperature_c) {
  if (model == "zhang") return {zhang(wavelength_nm, salinity_psu, temperature_c), zhang_source};
  if (model == "morel") return {morel(wavelength_nm, salinity_psu), morel_source};
  if (model == "smith-baker") {
    return {library.smith_baker_b.at(wavelength_nm, scattering), library.smith_baker_b.source};
  }
  no_model(scattering, model, "zhang, morel, smith-baker");
}

}  // namespace photic::optics
