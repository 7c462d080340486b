// Molecular scattering by sea water.
#pragma once

#include <string>

#include "optics/library.hpp"

namespace photic::optics {

/// Models: "zhang": Zhang, Hu & He 2009, at any salinity and temperature, 200 to 1100 nm;
/// "morel": Morel 1974, at any salinity, 200 to 800 nm; "smith-baker": sea water, 200 to 800 nm,
/// whatever the salinity and temperature. The depolarisation chosen for the phase function does not
/// enter: Zhang's is tied to 0.039. Throws InputError for a wavelength outside.
Sourced water_scattering_per_m(const Library& library, const std::string& model,
                               double wavelength_nm, double salinity_psu, double temperature_c);

}  // namespace photic::optics
