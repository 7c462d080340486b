// A telescope as a thin lens with a central obstruction and a detector disc behind it.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "instrument/overlap.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

template <class T>
struct Telescope {
  Vec3<T> position;      ///< centre of the lens [m]
  Vec3<T> axis;          ///< where it looks, a unit vector
  T lens_radius{};       ///< [m]
  T obstruction_radius{};
  T focal_length{};
  T detector_radius{};
  T detector_distance{}; ///< from the lens: focal length + shift
  bool submerged = false;

  /// Collecting area of the lens [m^2].
  [[nodiscard]] T area() const {
    return T(pi) * (lens_radius * lens_radius - obstruction_radius * obstruction_radius);
  }

  /// The share of the light entering the lens from a point at range z along the axis (z > 0) and at the off-axis
  /// angle with the given tangent that falls on the detector: 0 outside the field of view.
  /// The image is a disc of radius blur with the obstruction's shadow in it, shifted by q off the axis; the
  /// share is that of its area on the detector (docs/theory.md, "The telescope"; Harms, Appl. Opt. 18, 1559 (1979)).
  T overlap(const T& z, const T& tan_off_axis) const {
    using std::abs;
    const T defocus = abs(T(1) - detector_distance * (T(1) / focal_length - T(1) / z));
    const T blur = lens_radius * defocus;
    const T shadow = obstruction_radius * defocus;
    const T q = detector_distance * tan_off_axis;
    const T image_area = T(pi) * (blur * blur - shadow * shadow);
    const Mask<T> sharp = blur < T(1e-6) * detector_radius;
    const T lit = circles_overlap(detector_radius, blur, q) - circles_overlap(detector_radius, shadow, q);
    const T step = select(q < detector_radius, T(1), T(0));
    return select(sharp, step, lit / select(sharp, T(1), image_area));
  }
};

/// The telescope of a scene. Half field of view v: detector radius f tan v.
template <class T>
Telescope<T> make_telescope(const scene::Telescope& s) {
  Telescope<T> t;
  t.position = vec3_cast<T>(s.position_m);
  t.axis = vec3_cast<T>(normalised(s.direction));
  t.lens_radius = T(s.diameter_m / 2);
  t.obstruction_radius = T(s.obstruction_diameter_m / 2);
  t.focal_length = T(s.focal_length_m);
  t.detector_radius = T(s.effective_detector_diameter_m() / 2);
  t.detector_distance = T(s.focal_length_m + s.detector_shift_m);
  t.submerged = s.position_m.z < 0;
  return t;
}

}  // namespace photic::instrument
