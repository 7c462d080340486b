// The point where light from the water passes the flat surface to reach a point in the air
// (docs/theory.md, "The local estimate").
#pragma once

#include <cmath>
#include <limits>

#include "core/vec3.hpp"

namespace photic::geometry {

/// A point in the water is seen from the air as if it stood on its own vertical at the apparent
/// rise h + d / sqrt(n^2 + (n^2-1) t^2) below: h the height over the flat surface, d the point's
/// depth, t the tangent of the angle in air. 1 over that rise is the root s of
///   s (h + d / sqrt(n^2 + (n^2-1) s^2 aside^2)) = 1
/// and this its series in t^2, never above the root.
template <class T>
struct CrossingStart {
  T per_rise;
  T error;  ///< relative, about what the series leaves out: its next term
};
template <class T>
CrossingStart<T> crossing_start(const T& inverse_n, const T& depth, const T& height,
                                const T& aside_squared) {
  const T seen_depth = depth * inverse_n;
  const T paraxial = T(1) / (height + seen_depth);
  const T share = seen_depth * paraxial;
  const T bend = (T(1) - inverse_n * inverse_n) * (aside_squared * paraxial * paraxial);
  const T series = T(0.5) + bend * (T(0.75) * share - T(0.375) +
                                    bend * (T(1.5) * share * (share - T(1)) + T(0.3125)));
  const T correction = select(bend < T(0.25), bend * series, T(0.15)) * share;
  const T squared = bend * bend;
  return {paraxial + paraxial * correction, T(35.0 / 128) * share * squared * squared};
}

/// The root by Newton's steps from there. The left side is concave in s: steps from above the root
/// lead below it, steps from below rise towards it and never overshoot. A step squares the error,
/// times no more than t^2, which decides the last one. Small angles need none.
template <class T>
T crossing(const T& n, const T& depth, const T& height, const T& aside_squared,
           const CrossingStart<T>& start) {
  using std::sqrt;
  const T n2 = n * n;
  T s = start.per_rise;
  // A lane that is done rests, whatever the others still need.
  Mask<T> open = start.error > T(4 * std::numeric_limits<Element<T>>::epsilon());
  for (int step = 0; step < 60 && any(open); ++step) {
    const T t2 = s * s * aside_squared;
    const T q = T(1) / (n2 + (n2 - T(1)) * t2);
    const T root = sqrt(q);
    const T excess = s * (height + depth * root) - T(1);
    s = select(open, s - excess / (height + depth * n2 * q * root), s);
    open = open & (excess * excess * t2 > T(std::numeric_limits<Element<T>>::epsilon()));
  }
  return s;
}

/// The ray to the crossing whose apparent rise is 1 / per_rise, for a way that leads aside by (dx,
/// dy).
template <class T>
struct RefractedRay {
  Vec3<T> direction;  ///< in the water, a unit vector upwards
  Vec3<T> arriving;   ///< in the air, times secant_air
  T secant_air, cos_air, secant_water, cos_water;
};
template <class T>
RefractedRay<T> refracted_ray(const T& n, const T& inverse_n, const T& dx, const T& dy,
                              const T& aside_squared, const T& per_rise) {
  using std::sqrt;
  RefractedRay<T> ray;
  const T tangent_squared = per_rise * per_rise * aside_squared;
  const T slowness = sqrt(n * n + (n * n - T(1)) * tangent_squared);  // n secant_air cos_water
  ray.secant_air = sqrt(T(1) + tangent_squared);
  const T inverse = T(1) / (ray.secant_air * slowness);
  ray.cos_air = slowness * inverse;
  ray.secant_water = n * (T(1) + tangent_squared) * inverse;
  ray.cos_water = slowness * ray.cos_air * inverse_n;
  const T sideways = per_rise * ray.cos_air * inverse_n;
  ray.direction = {dx * sideways, dy * sideways, ray.cos_water};
  ray.arriving = {dx * per_rise, dy * per_rise, T(1)};
  return ray;
}
/// The ray from a point of a medium of index n, at a depth, to a point outside at a height. Where
/// `wanted` is false it is known to a few per cent of its angle. Into a denser medium the ray is
/// found from the point there, which sees the other one as from the air.
template <class T>
struct RayThrough {
  RefractedRay<T> ray;
  T per_rise;  ///< 1 over the apparent rise of the point that is in the denser medium
};
template <class T>
RayThrough<T> ray_through(const T& n, const T& inverse_n, bool into_denser, const T& depth,
                          const T& height, const T& dx, const T& dy, const Mask<T>& wanted) {
  const T &index = into_denser ? inverse_n : n, &inverse = into_denser ? n : inverse_n;
  const T &below = into_denser ? height : depth, &above = into_denser ? depth : height;
  const T aside_squared = dx * dx + dy * dy;
  auto start = crossing_start(inverse, below, above, aside_squared);
  start.error = select(wanted, start.error, T(0));  // no steps for the others
  const T per_rise = crossing(index, below, above, aside_squared, start);
  const auto ray = refracted_ray(index, inverse, dx, dy, aside_squared, per_rise);
  if (!into_denser) [[likely]]
    return {ray, per_rise};
  return {{ray.cos_air * ray.arriving, ray.secant_water * ray.direction, ray.secant_water,
           ray.cos_water, ray.secant_air, ray.cos_air},
          per_rise};
}

/// The widening of a pencil of light by refraction, in its plane: the ratio of the cosines to the
/// vertical, water's over air's; and its inverse.
template <class T>
struct Widening {
  T ratio, inverse;
};
template <class T>
Widening<T> widening(const RefractedRay<T>& ray) {
  return {ray.cos_water * ray.secant_air, ray.secant_water * ray.cos_air};
}

/// Area across the ray at its end in medium 1 (index n, path l1) per solid angle at its end in the
/// air (path l2): both curvatures of the refracted wave front, not the paraxial one [m^2/sr]. n^2
/// times that is the area in the air per solid angle in medium 1. `inverse_n` is 1 / n.
template <class T>
T refracted_area_per_solid_angle(const T& inverse_n, const T& l1, const T& l2,
                                 const Widening<T>& widening) {
  const T seen1 = l1 * inverse_n;
  return (l2 + seen1) * (l2 * widening.ratio + seen1 * widening.inverse);
}

/// The point where it crosses the surface, after this length in the water.
template <class T>
Vec3<T> crossed_at(const Vec3<T>& from, const RefractedRay<T>& ray, const T& length_water) {
  return {from.x + length_water * ray.direction.x, from.y + length_water * ray.direction.y, T(0)};
}

}  // namespace photic::geometry
