// Absorption and scattering by phytoplankton and what goes with it, from the concentration of
// chlorophyll.
#pragma once

#include <string>

#include "optics/library.hpp"

namespace photic::optics {

struct Phytoplankton {
  double a_per_m = 0;  ///< absorption, covarying detritus included
  double a_exciting_per_m =
      0;               ///< the share of it by phytoplankton itself, which excites its fluorescence
  double b_per_m = 0;  ///< scattering
  std::string source;
};

/// Phytoplankton without chlorophyll, whatever the model and the wavelength.
inline Phytoplankton no_phytoplankton() { return {0, 0, 0, "no chlorophyll"}; }

/// Models, with C in mg/m^3: "bricaud": a = A C^E (Bricaud 1998), exciting A C^(1-B) (Bricaud 1995,
/// never more than a), b = 0.30 (550/nm) C^0.62. "prieur-sathyendranath": a = 0.06 C^0.602 A_C, all
/// of it exciting, b = 0.33 (550/nm) C^0.62 (PREMAR-2F). Beyond the data of Bricaud 1995 and A_C,
/// below 400 and above 700 nm, they go on with the spectral shape of Bricaud 1998, which is 0 from
/// 720 nm on. Throws InputError outside 300 to 800 nm unless C is 0.
Phytoplankton phytoplankton(const Library& library, const std::string& model,
                            double chlorophyll_mg_m3, double wavelength_nm);

}  // namespace photic::optics
