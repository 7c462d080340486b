// A telescope as a thin lens with a central obstruction and a detector disc behind it.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "instrument/overlap.hpp"
#include "instrument/way_ahead.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

template <class T>
struct Telescope {
  Vec3<T> position;  ///< centre of the lens [m]
  T distance{};      ///< of that from the origin [m]
  Vec3<T> start;     ///< on the axis, way_ahead() of it [m]
  T ahead{};         ///< so far [m]
  Vec3<T> axis;      ///< where it looks, a unit vector
  Vec3<T> across;    ///< with `up` the directions of the lens' plane: unit vectors, at right angles
  Vec3<T> up;
  T lens_radius{};  ///< [m]
  T obstruction_radius{};
  T per_sharp_range{};  ///< 1 over the range that is seen sharp: 1 / f - 1 / x_d [1/m]
  T detector_radius{};
  T detector_distance{};   ///< from the lens: focal length + shift
  T least_defocus{};       ///< a sharp image counts as a disc of 1e-5 of the detector's radius
  T cos_squared_widest{};  ///< see cos_squared_of_widest_view()
  bool submerged = false;
  bool upright = false;  ///< its axis is vertical

  /// Whether light that rises from below may fall on the detector of a telescope in the air, if it
  /// moves aside in the direction of (x, y) at an angle to the vertical whose tangent is at least
  /// the length of that vector over `rise` > 0.
  Mask<T> may_see_beyond(const T& x, const T& y, const T& rise) const {
    // With t = (x, y) / rise: -cos(off axis) sqrt(1 + t^2) = axis.t + axis.z; beyond the angle the
    // cosine has its best value at the angle or at its extremum.
    const T aside = x * axis.x + y * axis.y;
    const T squared = x * x + y * y;
    const Mask<T> before_extremum = aside * rise < squared * axis.z;
    const T forward = -(aside + rise * axis.z);
    const Mask<T> inside =
        (forward > T(0)) & (forward * forward >= cos_squared_widest * (rise * rise + squared));
    return before_extremum | inside;
  }

  /// Collecting area of the lens [m^2].
  [[nodiscard]] T area() const {
    return T(pi) * (lens_radius * lens_radius - obstruction_radius * obstruction_radius);
  }

  /// The share of the light entering the lens from a point at 1 / per_range along the axis (> 0)
  /// and at the off-axis angle with the given tangent that falls on the detector: 0 outside the
  /// field of view. The image is a disc of radius blur with the obstruction's shadow in it, shifted
  /// by q off the axis; the share is that of its area on the detector (docs/theory.md, "The
  /// telescope"; Harms, Appl. Opt. 18, 1559 (1979)).
  T overlap(const T& per_range, const T& tan_off_axis) const {
    using std::abs;
    const T defocus = abs(detector_distance * (per_range - per_sharp_range));
    const T spread = select(defocus > least_defocus, defocus, least_defocus);
    const T blur = lens_radius * spread;
    const T q = detector_distance * tan_off_axis;
    if (all(q >= detector_radius + blur)) return T(0);
    const T shadow = obstruction_radius * spread;
    const T image_area = T(pi) * (blur * blur - shadow * shadow);
    T lit = circles_overlap(detector_radius, blur, q);
    if (any(shadow > T(0))) lit = lit - circles_overlap(detector_radius, shadow, q);
    return lit / image_area;
  }
};

/// Squared cosine of an off-axis angle beyond which a telescope in the air sees nothing that is in
/// the water; 0 for one in the water, or with so wide a view that nothing can be said.
inline double cos_squared_of_widest_view(const scene::Telescope& s) {
  if (s.position_m.z < 0) return 0.0;
  const double f = s.focal_length_m;
  const double x = f + s.detector_shift_m;
  // The blur is widest at one end of the ranges along the axis: infinity, or the height times the
  // off-axis cosine. That begins with 1/2; each round narrows the view and lifts the near end.
  double cosine = 0.5;
  for (int round = 0; round < 5; ++round) {
    const double blur_far = std::abs(1 - x / f);
    const double blur_near = std::abs(1 - x * (1 / f - 1 / (cosine * s.position_m.z)));
    const double reach =
        s.effective_detector_diameter_m() / 2 + s.diameter_m / 2 * std::max(blur_far, blur_near);
    const double widest = std::cos(std::atan(reach / x)) * (1 - 1e-6);
    if (widest < cosine) break;
    cosine = widest;
  }
  return cosine > 0.5 ? cosine * cosine : 0.0;
}

/// The telescope of a scene. Half field of view v: detector radius f tan v.
template <class T>
Telescope<T> make_telescope(const scene::Telescope& s) {
  Telescope<T> t;
  t.position = vec3_cast<T>(s.position_m);
  t.distance = T(length(s.position_m));
  const Vec3<double> axis = normalised(s.direction);
  const double ahead = way_ahead(s.position_m, axis);
  t.start = vec3_cast<T>(s.position_m + ahead * axis);
  t.ahead = T(ahead);
  t.axis = vec3_cast<T>(axis);
  t.across = vec3_cast<T>(turned(axis, 1.0, 1.0, 0.0));
  t.up = vec3_cast<T>(turned(axis, 1.0, 0.0, 1.0));
  t.lens_radius = T(s.diameter_m / 2);
  t.obstruction_radius = T(s.obstruction_diameter_m / 2);
  t.per_sharp_range = T(1 / s.focal_length_m - 1 / (s.focal_length_m + s.detector_shift_m));
  t.detector_radius = T(s.effective_detector_diameter_m() / 2);
  t.detector_distance = T(s.focal_length_m + s.detector_shift_m);
  t.least_defocus = T(1e-5) * t.detector_radius / t.lens_radius;
  t.submerged = s.position_m.z < 0;
  t.upright = std::abs(axis.z) == 1;
  t.cos_squared_widest = T(cos_squared_of_widest_view(s));
  return t;
}

}  // namespace photic::instrument
