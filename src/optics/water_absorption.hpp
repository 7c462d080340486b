// Absorption of pure sea water.
#pragma once

#include <string>

#include "optics/library.hpp"

namespace photic::optics {

/// Models: "mason-ioccg": Mason et al. 2016 and the WOPP from 300 to 1100 nm, changed with salinity
/// and temperature by the table's psi; below 300 nm, from 200, IOCCG 2018 as it is. The two sets
/// differ by a factor of 3 at 300 nm; nothing smooths that step. Tables whatever the salinity and
/// temperature: "ioccg", 200 to 1000 nm; "pope-fry", 380 to 727.5 nm; "smith-baker", 200 to 800 nm.
/// Throws InputError for a wavelength outside.
Sourced water_absorption_per_m(const Library& library, const std::string& model,
                               double wavelength_nm, double salinity_psu, double temperature_c);

}  // namespace photic::optics
