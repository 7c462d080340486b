// Walks that are rotated about a vertical so that two rays meet (docs/theory.md, "The bidirectional
// estimator").
#pragma once

#include "core/lanes.hpp"
#include "core/vec3.hpp"

namespace photic::estimator {

/// A vertical about which a walk may be turned: that through its pivot, where it converts, or of
/// light of the laser's line the vertex next to the telescope.
template <class T>
struct RotationAxis {
  Mask<T> exists{};
  T x{}, y{};  ///< [m]

  friend RotationAxis select(const Mask<T>& mask, const RotationAxis& yes, const RotationAxis& no) {
    return {select(mask, yes.exists, no.exists), select(mask, yes.x, no.x),
            select(mask, yes.y, no.y)};
  }
};

/// Whether a telescope's walk that comes to a vertex along `home`, scatters there and goes on along
/// `on` may be turned about the vertical through it: where it comes along the vertical and leaves
/// aside, the turn hardly changes the angle between. Both directions' own angles to the vertical
/// tell, which no turn changes.
template <class T>
Mask<T> leads_aside(const Vec3<T>& arriving, const Vec3<T>& leaving) {
  constexpr double as_far = 3;  // decision 33
  return leaving.x * leaving.x + leaving.y * leaving.y >
         T(as_far * as_far) * (arriving.x * arriving.x + arriving.y * arriving.y);
}

/// |e_z x (x - axis) . (w x w')|, S: the volume that two rays of directions w and w' sweep about
/// where they meet, per solid angle of both and turn about the axis. A walk turned about the axis
/// keeps it.
template <class T>
struct RotationJacobian {
  T x{}, y{};              ///< where they meet [m]
  T cross_x{}, cross_y{};  ///< w x w', its horizontal part

  T about(const RotationAxis<T>& axis) const {
    using std::abs;
    return select(axis.exists, T(abs((x - axis.x) * cross_y - (y - axis.y) * cross_x)), T(0));
  }
};
template <class T>
RotationJacobian<T> rotation_jacobian(const Vec3<T>& place, const Vec3<T>& a, const Vec3<T>& b) {
  return {place.x, place.y, a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z};
}

/// n h / g of turning a walk so that rays meet at a vertex.
template <class T>
struct RotatedMeeting {
  T density{};  ///< over the sweep [1/m]
  RotationJacobian<T> jacobian{};

  T about(const RotationAxis<T>& axis) const { return density * jacobian.about(axis); }

  template <class F>
  constexpr void each_member(F& f) {
    f(density), f(jacobian.x), f(jacobian.y), f(jacobian.cross_x), f(jacobian.cross_y);
  }
};

}  // namespace photic::estimator
