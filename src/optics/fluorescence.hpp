// Fluorescence of chlorophyll a, here as one line at the centre of its emission.
#pragma once

#include "optics/emission.hpp"
#include "optics/library.hpp"

namespace photic::optics {

/// yield photons per photon absorbed by phytoplankton (a_exciting_per_m at the laser's wavelength),
/// at 685 nm. Excited at 300 to 690 nm only. The part of the Gaussian (sigma 10.6 nm) at
/// wavelengths shorter than the laser's is lost. No lines where nothing is emitted.
Emission chlorophyll_fluorescence(const Library& library, double laser_nm, double a_exciting_per_m,
                                  double yield);

}  // namespace photic::optics
