// Whitecaps: how much of the sea they cover by the wind, and how much light they reflect.
#pragma once

#include <string>

#include "optics/library.hpp"

namespace photic::optics {

/// The share of the sea's surface that whitecaps cover at a wind speed [m/s]: Monahan &
/// O'Muircheartaigh 1980, J. Phys. Oceanogr. 10, 2094: 2.95e-6 U^3.52.
Sourced whitecap_fraction_monahan(double wind_speed_m_s);
/// Stramska & Petelski 2003, J. Geophys. Res. 108(C3), 3086, undeveloped seas: 8.75e-5 (U -
/// 6.33)^3 above 6.33 m/s.
Sourced whitecap_fraction_stramska(double wind_speed_m_s);

/// The reflectance of a whitecap, in the mean over its life, for light that comes from above:
/// Koepke 1984, Appl. Opt. 23, 1816.
Sourced whitecap_reflectance_koepke(const Library& library, double wavelength_nm);
/// Koepke's at short wavelengths, which falls to longer ones as Frouin et al. 1996 found.
Sourced whitecap_reflectance_frouin(const Library& library, double wavelength_nm);

}  // namespace photic::optics
