// Suspended minerals, by their mass in the water.
#pragma once

#include <string>

namespace photic::optics {

struct SphereSections;

struct Minerals {
  double a_per_m = 0, b_per_m = 0;
  std::string source;
};

/// Absorption a_443 exp(-slope (nm - 443)) and scattering b_555 (555 / nm)^exponent, per gram.
struct MineralsPowerLaw {
  double a_443_m2_per_g = 0, a_slope_per_nm = 0;
  double b_555_m2_per_g = 0, b_exponent = 0;
  friend bool operator==(const MineralsPowerLaw&, const MineralsPowerLaw&) = default;
};

/// Waters around Europe. Absorption: Babin, Stramski et al. 2003, J. Geophys. Res. 108(C7), 3211,
/// the slope verified, the magnitude from memory. Scattering: Babin, Morel et al. 2003, Limnol.
/// Oceanogr. 48, 843, verified; its exponent from memory, near the middle of the 0.1 to 1.4 of
/// Doxaran et al. 2009, Limnol. Oceanogr. 54, 1257.
inline constexpr MineralsPowerLaw european_minerals{0.041, 0.0123, 0.5, 0.5};

/// Fournier & Forand's function for them: the index of PREMAR-2F's minerals, and the slope of sizes
/// that goes with a scattering as wavelength^-0.5 (slope - 3). It sends 2.33 % backwards;
/// Neukermans et al. 2012, Limnol. Oceanogr. 57, 124, measured 0.012 m2/g backwards, 2.4 % of 0.5
/// m2/g.
inline constexpr double minerals_ff_index = 1.15, minerals_ff_slope = 3.5;

Minerals minerals_by_power_law(const MineralsPowerLaw& law, double minerals_g_m3,
                               double wavelength_nm);

/// So many spheres of these as have that mass.
Minerals minerals_of_spheres(const SphereSections& one, double minerals_g_m3);

}  // namespace photic::optics
