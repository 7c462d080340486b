// What sampling takes for a telescope's view in the water.
#pragma once

#include "core/vec3.hpp"

namespace photic::estimator {

/// A telescope's view in the water as sampling takes it: a cone about its (refracted) axis from
/// where that enters the lens or the surface, whose light is attenuated with `rate` on its way to
/// the entry.
template <class T>
struct ViewCone {
  Vec3<T> entry;
  Vec3<T> axis;  ///< unit vector into the water
  T rate{};      ///< [1/m]
  T radius{};    ///< at the entry [m]
  T widening{};  ///< of the radius, per metre
};

}  // namespace photic::estimator
