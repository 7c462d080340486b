// A telescope as a thin lens with a central obstruction and a detector disc behind it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "geometry/axis.hpp"
#include "instrument/overlap.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

/// The greatest distance off its axis at which a telescope in the air may see a point at an
/// apparent rise below it, as if through a flat surface without refraction (geometry/crossing.hpp):
///   rise tangent + radius (|middle - rise per_sharp_range| + spread) [m],
/// the detector's half view and the blur of a point there (see Telescope::overlap). `rise` is the
/// paraxial one; that of a point seen is smaller by a known factor at most, which `middle` and
/// `spread` allow for, as for ranges along a tilted axis. Infinite if nothing can be said.
template <class T>
struct ViewReach {
  T tangent{}, radius{}, middle{}, spread{};
  T tangent_of_ray{};  ///< of the way to one point of an upright lens: see may_see_by_ray()
};

template <class T>
struct Telescope {
  Vec3<T> position;  ///< centre of the lens [m]
  T distance{};      ///< of that from the origin [m]
  Vec3<T> start;     ///< on the axis, way_ahead() of it [m]
  T ahead{};         ///< so far [m]
  Vec3<T> axis;      ///< its view, a unit vector
  Vec3<T> across;    ///< with `up` the directions of the lens' plane: unit vectors, at right angles
  Vec3<T> up;
  T lens_radius{};  ///< [m]
  T lens_rise{};    ///< by which its rim lies above and below its centre [m]
  T obstruction_radius{};
  T per_sharp_range{};  ///< 1 over the range that is seen sharp: 1 / f - 1 / x_d [1/m]
  T detector_radius{};
  T detector_distance{};  ///< from the lens: focal length + shift
  T min_defocus{};        ///< a sharp image counts as a disc of 1e-5 of the detector's radius
  ViewReach<T> reach;
  bool inside = false;     ///< it stands in the medium
  bool above_air = false;  ///< which is upside down: paths count as in clear air
  bool upright = false;    ///< its axis is vertical

  /// Returns whether light that rises from below may fall on the detector of a telescope in the
  /// air, if it moves aside in the direction of (x, y) at an angle to the vertical whose tangent is
  /// at least the length of that vector over `rise` > 0.
  Mask<T> may_see_beyond(const T& x, const T& y, const T& rise) const {
    using std::abs;
    const T farthest = rise * reach.tangent +
                       reach.radius * (abs(reach.middle - rise * per_sharp_range) + reach.spread);
    const T squared = x * x + y * y;
    if (upright) return squared <= farthest * farthest;
    // With t = (x, y) / rise: -cos(off axis) sqrt(1 + t^2) = axis.t + axis.z; beyond the angle the
    // cosine has its best value at the angle or at its extremum.
    const Vec3<T> arriving{x, y, rise};
    const Mask<T> before_extremum = (x * axis.x + y * axis.y) * rise < squared * axis.z;
    const T forward = T(0) - dot(arriving, axis);
    const Vec3<T> off_axis = rise * cross(arriving, axis);
    const T widest = farthest * forward;
    return before_extremum | ((forward > T(0)) & (dot(off_axis, off_axis) <= widest * widest));
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
    const T spread = select(defocus > min_defocus, defocus, min_defocus);
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

/// 1 over the range that a telescope sees sharp [1/m].
inline double per_sharp_range(const scene::Telescope& s) {
  return 1 / s.focal_length_m - 1 / s.detector_distance_m();
}

/// An off-axis angle beyond which a telescope in the air sees nothing that is in the water; half a
/// turn of one with so wide a view that nothing can be said [rad].
inline double widest_view(const scene::Telescope& s) {
  const double f = s.focal_length_m;
  const double x = s.detector_distance_m();
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
  return cosine > 0.5 ? std::acos(cosine) : pi;
}

/// By how much the rim of its lens lies above and below the centre [m].
inline double lens_rise(const scene::Telescope& s) {
  const Vec3<double> axis = normalised(s.direction);
  return s.diameter_m / 2 * std::hypot(axis.x, axis.y);
}

/// See ViewReach. At an angle v to the vertical the rise is at least cos v times the paraxial one,
/// since 1 / sqrt(n^2 + (n^2 - 1) tan^2 v) >= cos v / n; the range along the axis is the rise times
/// cos w / cos v, w being the angle to the axis.
inline ViewReach<double> reach_of_view(const scene::Telescope& s) {
  // A sharp image counts as a disc of 1e-5 of the detector's radius; the rest is for rounding, of
  // floats and of a tilted axis far from the sea.
  constexpr double ample = 1 + 2e-5, rounding = 1e-6;
  const double widest = widest_view(s);
  const double tilt = std::acos(std::min(1.0, std::abs(normalised(s.direction).z)));
  const double steepest = std::max(0.0, tilt - widest), flattest = tilt + widest;
  const bool upright = tilt == 0, is_known = s.position_m.z > 0 && flattest < pi / 2;
  const double lens_radius = s.diameter_m / 2;
  const double half_view = s.effective_detector_diameter_m() / 2 / s.detector_distance_m();
  // 1 over the most and the least of the range along the axis, in paraxial rises.
  const double least = upright ? 1 : std::cos(flattest);
  const double most =
      upright ? 1 / std::cos(widest) : std::cos(steepest) / (std::cos(widest) * std::cos(flattest));
  ViewReach<double> reach;
  reach.tangent = ample * half_view + (upright ? 0 : rounding);
  reach.radius = ample * lens_radius;
  reach.middle = is_known ? (most + least) / 2 : 1;
  reach.spread = is_known ? (most - least) / 2 + rounding : std::numeric_limits<double>::infinity();
  reach.tangent_of_ray = ample * half_view + lens_radius * std::abs(per_sharp_range(s)) *
                                                 (is_known ? 1 - std::cos(widest) : 1);
  return reach;
}

/// The telescope of a scene. Half field of view v: detector radius f tan v.
template <class T>
Telescope<T> make_telescope(const scene::Telescope& s, const geometry::Ahead& way) {
  Telescope<T> t;
  t.position = vec3_cast<T>(s.position_m);
  t.distance = T(length(s.position_m));
  const Vec3<double> axis = normalised(s.direction);
  const double ahead = way.length;
  t.above_air = way.to_sea > 0;
  t.start = vec3_cast<T>(s.position_m + ahead * axis);
  t.ahead = T(ahead);
  t.axis = vec3_cast<T>(axis);
  t.across = vec3_cast<T>(turned(axis, 1.0, 1.0, 0.0));
  t.up = vec3_cast<T>(turned(axis, 1.0, 0.0, 1.0));
  t.lens_radius = T(s.diameter_m / 2);
  t.lens_rise = T(lens_rise(s));
  t.obstruction_radius = T(s.obstruction_diameter_m / 2);
  t.per_sharp_range = T(per_sharp_range(s));
  t.detector_radius = T(s.effective_detector_diameter_m() / 2);
  t.detector_distance = T(s.detector_distance_m());
  t.min_defocus = T(1e-5) * t.detector_radius / t.lens_radius;
  t.inside = geometry::stands_in_water(s.position_m);
  t.upright = std::abs(axis.z) == 1;
  const ViewReach<double> reach = reach_of_view(s);
  t.reach = {T(reach.tangent), T(reach.radius), T(reach.middle), T(reach.spread),
             T(reach.tangent_of_ray)};
  return t;
}
template <class T>
Telescope<T> make_telescope(const scene::Telescope& s) {
  return make_telescope<T>(s, geometry::ahead_of(s.position_m, normalised(s.direction)));
}

}  // namespace photic::instrument
