// Coloured dissolved organic matter. It absorbs and does not scatter.
#pragma once

#include <cmath>

namespace photic::optics {

inline constexpr const char* cdom_source =
    "Bricaud, Morel & Prieur 1981, Limnol. Oceanogr. 26, 43 [verified]";

/// Absorption [1/m] from that at 440 nm: Bricaud, Morel & Prieur 1981, Limnol. Oceanogr. 26, 43.
inline double cdom_absorption_per_m(double a440_per_m, double slope_per_nm, double wavelength_nm) {
  return a440_per_m * std::exp(-slope_per_nm * (wavelength_nm - 440.0));
}

}  // namespace photic::optics
