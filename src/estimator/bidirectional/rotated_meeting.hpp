// Telescopes' walks that are rotated about a vertical axis so that two rays meet (eq. 41).
#pragma once

#include "core/lanes.hpp"
#include "core/vec3.hpp"

namespace photic::estimator {

/// The vertical about which a telescope's walk may be rotated. It goes through the pivot: where the
/// walk converts, or, of light of the laser's line, the vertex next to the telescope.
template <class T>
struct RotationAxis {
  Mask<T> exists{};
  T x{}, y{};  ///< [m]

  friend RotationAxis select(const Mask<T>& mask, const RotationAxis& yes, const RotationAxis& no) {
    return {select(mask, yes.exists, no.exists), select(mask, yes.x, no.x),
            select(mask, yes.y, no.y)};
  }
};

/// Returns whether a telescope's walk that arrives at a vertex and leaves it in directions may be
/// rotated about the vertical through it. Where it arrives along the vertical and leaves aside, the
/// rotation hardly changes the scattering angle. Both directions' angles to the vertical decide. No
/// rotation changes these.
template <class T>
Mask<T> leads_aside(const Vec3<T>& arriving, const Vec3<T>& leaving) {
  constexpr double as_far = 3;  // decision 33
  return leaving.x * leaving.x + leaving.y * leaving.y >
         T(as_far * as_far) * (arriving.x * arriving.x + arriving.y * arriving.y);
}

/// S = |e_z x (x - axis) . (w x w')|: the Jacobian of the directions w and w' of two rays with
/// respect to the place x where they meet and to the angle of a rotation of one of them, times the
/// squares of both lengths. It stays when both rays are rotated about the axis.
template <class T>
struct RotationJacobian {
  T x{}, y{};              ///< of their meeting [m]
  T cross_x{}, cross_y{};  ///< w x w', horizontal components

  template <class F>
  constexpr void each_member(F f) {
    f(x), f(y), f(cross_x), f(cross_y);
  }
  T about(const RotationAxis<T>& axis) const {
    using std::abs;
    return select(axis.exists, T(abs((x - axis.x) * cross_y - (y - axis.y) * cross_x)), T(0));
  }
};
template <class T>
RotationJacobian<T> rotation_jacobian(const Vec3<T>& place, const Vec3<T>& a, const Vec3<T>& b) {
  return {place.x, place.y, a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z};
}

/// Density of rotating a walk so that two rays meet at a vertex.
template <class T>
struct RotatedMeeting {
  T density{};  ///< over the Jacobian [m]
  RotationJacobian<T> jacobian{};

  T about(const RotationAxis<T>& axis) const { return density * jacobian.about(axis); }

  template <class F>
  constexpr void each_member(F f) {
    f(density), f(jacobian.x), f(jacobian.y), f(jacobian.cross_x), f(jacobian.cross_y);
  }
};

}  // namespace photic::estimator
