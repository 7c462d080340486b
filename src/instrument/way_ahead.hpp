// Where the light of an instrument far above the sea is taken to start, or to have come from.
#pragma once

#include <algorithm>

#include "core/vec3.hpp"

namespace photic::instrument {

/// How far ahead of an instrument its light is told of [m]: where its axis, a unit vector, meets
/// the sea, or for grazing light on the way there. So lengths far longer than what they lead to are
/// left out of places and paths, and floats tell these as well from space. In the water, and where
/// the axis leads away from it: at the instrument.
inline double way_ahead(const Vec3<double>& position, const Vec3<double>& axis) {
  if (position.z <= 0 || axis.z >= 0) return 0;
  constexpr double most_heights = 10;
  return position.z * std::min(most_heights, -1 / axis.z);
}

}  // namespace photic::instrument
