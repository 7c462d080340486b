// The refractive index of sea water after Quan & Fry 1995, Appl. Opt. 34, 3477, eq. (3) [verified].
//
// Relative to air (against vacuum it is 0.03 % more). Fitted to 400-700 nm, 0-30 C, 0-35 PSU; taken
// as good from 200 to 1100 nm after Zhang, Hu & He 2009, Opt. Express 17, 5698. Outside that
// InputError is thrown.
#pragma once

namespace photic::optics {

inline constexpr const char* refractive_index_source =
    "Quan & Fry 1995, Appl. Opt. 34, 3477, eq. (3) [verified]";

inline constexpr double refractive_index_min_nm = 200, refractive_index_max_nm = 1100;

double refractive_index(double wavelength_nm, double salinity_psu, double temperature_c);

/// n - wavelength dn/dwavelength: what the speed of a pulse is divided by.
double group_index(double wavelength_nm, double salinity_psu, double temperature_c);

/// dn/dS [1/PSU].
double refractive_index_per_psu(double wavelength_nm, double temperature_c);

}  // namespace photic::optics
