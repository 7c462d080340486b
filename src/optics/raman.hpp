// Raman scattering by water's OH stretch band, here as one line at the band's centre.
#pragma once

#include <string>

#include "optics/emission.hpp"
#include "optics/library.hpp"

namespace photic::optics {

/// Models: "bartlett": 2.7e-4 (488/nm)^5.3 photons per metre (Bartlett et al. 1998), at the mean
/// shift of Walrafen's band, 3384 1/cm; "marshall-smith": A nu_R^4 / (nu_0^2 - nu_E^2)^2 of energy,
/// turned into photons, at 3400 1/cm. Photons are taken out of the water's absorption; they are no
/// extra loss. No lines where the laser's light has less energy than the shift.
Emission raman(const Library& library, const std::string& model, double laser_nm);

}  // namespace photic::optics
