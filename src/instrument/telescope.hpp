// A telescope as a thin lens with a central obstruction and a detector disc behind it.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "instrument/overlap.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

template <class T>
struct Telescope {
  Vec3<T> position;  ///< centre of the lens [m]
  Vec3<T> axis;      ///< where it looks, a unit vector
  T lens_radius{};   ///< [m]
  T obstruction_radius{};
  T power{};  ///< 1 / focal length [1/m]
  T detector_radius{};
  T detector_distance{};   ///< from the lens: focal length + shift
  T cos_squared_widest{};  ///< see cos_squared_of_widest_view()
  bool submerged = false;

  /// Whether light that rises from below may fall on the detector of a telescope in the air, if it
  /// moves aside in the direction of (tx, ty) at an angle to the vertical whose tangent is at least
  /// the length of that vector.
  Mask<T> may_see_beyond(const T& tx, const T& ty) const {
    // With t the vector: -cos(off axis) sqrt(1 + t^2) = axis.t + axis.z; beyond the angle the
    // cosine has its best value at the angle or at its extremum.
    const T aside = tx * axis.x + ty * axis.y;
    const T tangent_squared = tx * tx + ty * ty;
    const Mask<T> before_extremum = aside < tangent_squared * axis.z;
    const T forward = -(aside + axis.z);
    const Mask<T> inside =
        (forward > T(0)) & (forward * forward >= cos_squared_widest * (T(1) + tangent_squared));
    return before_extremum | inside;
  }

  /// Collecting area of the lens [m^2].
  [[nodiscard]] T area() const {
    return T(pi) * (lens_radius * lens_radius - obstruction_radius * obstruction_radius);
  }

  /// The share of the light entering the lens from a point at range z along the axis (z > 0) and at
  /// the off-axis angle with the given tangent that falls on the detector: 0 outside the field of
  /// view. The image is a disc of radius blur with the obstruction's shadow in it, shifted by q off
  /// the axis; the share is that of its area on the detector (docs/theory.md, "The telescope";
  /// Harms, Appl. Opt. 18, 1559 (1979)).
  T overlap(const T& z, const T& tan_off_axis) const {
    using std::abs;
    const T defocus = abs(T(1) - detector_distance * (power - T(1) / z));
    const T blur = lens_radius * defocus;
    const T q = detector_distance * tan_off_axis;
    const Mask<T> whole = q + blur <= detector_radius;
    const Mask<T> partial = !(whole | (q >= detector_radius + blur));
    if (!any(partial)) return select(whole, T(1), T(0));
    const T shadow = obstruction_radius * defocus;
    const T image_area = T(pi) * (blur * blur - shadow * shadow);
    const Mask<T> sharp = blur < T(1e-6) * detector_radius;
    const T lit =
        circles_overlap(detector_radius, blur, q) - circles_overlap(detector_radius, shadow, q);
    const T step = select(q < detector_radius, T(1), T(0));
    const T share = select(sharp, step, lit / select(sharp, T(1), image_area));
    return select(partial, share, select(whole, T(1), T(0)));
  }
};

/// Squared cosine of an off-axis angle beyond which a telescope in the air sees nothing that is in
/// the water; 0 for one in the water, or with so wide a view that nothing can be said.
inline double cos_squared_of_widest_view(const scene::Telescope& s) {
  if (s.position_m.z < 0) return 0.0;
  const double f = s.focal_length_m;
  const double x = f + s.detector_shift_m;
  // The blur is widest at one end of the ranges along the axis: infinity, or for off-axis cosines
  // above 1/2 no less than half the height.
  const double blur_far = std::abs(1 - x / f);
  const double blur_near = std::abs(1 - x * (1 / f - 2 / s.position_m.z));
  const double reach =
      s.effective_detector_diameter_m() / 2 + s.diameter_m / 2 * std::max(blur_far, blur_near);
  const double cosine = std::cos(std::atan(reach / x)) * (1 - 1e-6);
  return cosine > 0.5 ? cosine * cosine : 0.0;
}

/// The telescope of a scene. Half field of view v: detector radius f tan v.
template <class T>
Telescope<T> make_telescope(const scene::Telescope& s) {
  Telescope<T> t;
  t.position = vec3_cast<T>(s.position_m);
  t.axis = vec3_cast<T>(normalised(s.direction));
  t.lens_radius = T(s.diameter_m / 2);
  t.obstruction_radius = T(s.obstruction_diameter_m / 2);
  t.power = T(1 / s.focal_length_m);
  t.detector_radius = T(s.effective_detector_diameter_m() / 2);
  t.detector_distance = T(s.focal_length_m + s.detector_shift_m);
  t.submerged = s.position_m.z < 0;
  t.cos_squared_widest = T(cos_squared_of_widest_view(s));
  return t;
}

}  // namespace photic::instrument
