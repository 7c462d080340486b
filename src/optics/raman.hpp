// Raman scattering by water's OH stretch band.
#pragma once

#include <string>

#include "optics/emission.hpp"
#include "optics/library.hpp"

namespace photic::optics {

/// Photons per metre. Models: "bartlett": 2.7e-4 (488/nm)^5.3 photons (Bartlett et al. 1998), as a
/// line at the mean shift of Walrafen's band, 3384 1/cm; "marshall-smith": A nu_R^4 / (nu_0^2 -
/// nu_E^2)^2 of energy, turned into photons, at 3400 1/cm. The spectrum is Walrafen's band with as
/// many photons. They are taken out of the water's absorption; they are no extra loss. There are
/// none if the laser's light has less energy than the shift.
Emission raman(const Library& library, const std::string& model, double laser_nm);

}  // namespace photic::optics
