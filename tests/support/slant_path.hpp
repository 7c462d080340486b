// The way along the axes of a laser and a telescope, by angles.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec3.hpp"

namespace photic::test {

/// Group path along the axis of an instrument that looks down, between it and a depth; the depth
/// may lie in the air (negative), the instrument in the water.
template <class Instrument>
double leg_to_depth(const Instrument& instrument, double depth_m, double refractive_index,
                    double group_index) {
  const double z = instrument.position_m.z;
  const double angle = std::acos(-normalised(instrument.direction).z);
  if (z < 0) return (depth_m + z) * group_index / std::cos(angle);
  const double in_water = std::asin(std::sin(angle) / refractive_index);
  return (z + std::min(0.0, depth_m)) / std::cos(angle) +
         std::max(0.0, depth_m) * group_index / std::cos(in_water);
}

/// c0 t = H_L/cos a_L + H_T/cos a_T + z (n_L/cos w_L + n_T/cos w_T), sin w = sin a / n.
template <class Source, class Telescope, class Line>
double slant_path(const Source& source, const Telescope& telescope, const Line& out,
                  const Line& back, double depth_m) {
  return leg_to_depth(source, depth_m, out.refractive_index, out.group_index) +
         leg_to_depth(telescope, depth_m, back.refractive_index, back.group_index);
}

}  // namespace photic::test
