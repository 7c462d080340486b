// Depth from the pressure that instruments in the sea measure.
#pragma once

#include <cmath>

#include "core/constants.hpp"

namespace photic::optics {

/// Depth [m] of a pressure above that of the air [dbar] at a latitude [deg], in a sea of 35 PSU and
/// 0 C: Fofonoff & Millard 1983, UNESCO Tech. Pap. Mar. Sci. 44, p. 25 [verified]. Real water
/// columns differ from it by about 2 m in 1000 m.
inline double depth_of_pressure_m(double pressure_dbar, double latitude_deg) {
  const double p = pressure_dbar;
  const double sine = std::sin(latitude_deg * radian_per_degree);
  const double x = sine * sine;
  const double gravity = 9.780318 * (1 + (5.2788e-3 + 2.36e-5 * x) * x) + 1.092e-6 * p;
  return (((-1.82e-15 * p + 2.279e-10) * p - 2.2512e-5) * p + 9.72659) * p / gravity;
}

}  // namespace photic::optics
