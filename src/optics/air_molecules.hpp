// The effect of molecules on light in air: they scatter it, bend it, and ozone absorbs it.
//
// Dry air with 360 ppm of carbon dioxide: water vapour scatters as much as the air it replaces
// within 1 %, and its absorption lines are left out.
#pragma once

#include "optics/library.hpp"

namespace photic::optics {

class AirLibrary;

inline constexpr double air_min_nm = 200, air_max_nm = 1100;

inline constexpr const char* air_scattering_source =
    "Bodhaine et al. 1999, J. Atmos. Ocean. Technol. 16, 1854, eq. (29) [verified]";

inline constexpr const char* air_index_source =
    "Ciddor 1996, Appl. Opt. 35, 1566, eq. (1), in proportion to the density [verified]";

/// Scattering cross-section of one molecule [m^2]. Bodhaine et al. 1999, eq. (29): fitted to 250 to
/// 850 nm, within 0.2 % of their theory (eqs. (22) and (23)) from 200 to 1100 nm. Throws InputError
/// outside.
double air_scattering_m2(double wavelength_nm);

/// The depolarisation of natural light, for optics::rayleigh: 0.045 at 200 nm, 0.0285 at 532 nm,
/// from the King factors of Bates 1984, Planet. Space Sci. 32, 785, as Bodhaine et al. 1999 have
/// them, eqs. (5), (6) and (23).
double air_depolarisation(double wavelength_nm);

/// Refractive index of dry air at 15 C and 1013.25 hPa. Ciddor 1996, Appl. Opt. 35, 1566, eq. (1).
double standard_air_index(double wavelength_nm);

/// The same at any density: n - 1 goes as the number of molecules.
double air_index(double wavelength_nm, double molecules_per_m3);

/// The group index n - L dn/dL at standard conditions less 1, over n - 1: 1.0415 at 532 nm. It is
/// the same at any density.
double air_group_over_phase(double wavelength_nm);

/// Absorption cross-section of one molecule of ozone [m^2]: Molina & Molina 1986 from 200 to 350
/// nm, with its temperature (from 226 to 298 K, else that of the nearer end); above that
/// Serdyuchenko et al. 2014 at 293 K. Throws InputError outside.
Sourced ozone_absorption_m2(const AirLibrary& library, double wavelength_nm, double temperature_k);

}  // namespace photic::optics
