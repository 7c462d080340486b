// The directions in the water in which the bidirectional estimator's walks begin, whichever way
// they go by: evenly in a cone about an instrument's axis, as the flat surface refracts that. What
// a walk draws beyond its first vertex is then as likely wherever its instrument stands (theory.md,
// "Free walks").
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/elementary.hpp"
#include "core/turn.hpp"
#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Where an instrument's rays come to in the water, and by how long a way at least: a circle about
/// its axis that widens with depth.
template <class T>
struct Spot {
  T x{}, y{}, x_per_depth{}, y_per_depth{};  ///< of the axis, from the instrument's middle [m]
  T radius{}, radius_per_depth{};
  T least_path{}, least_path_per_depth{};  ///< as walks count it [m]
  T most_shorter{};                        ///< a ray's way becomes shorter by no more [m]
};

template <class T>
struct EntryCone {
  Vec3<T> axis;              ///< in the water, away from the instrument: a unit vector
  Vec3<T> outside;           ///< the instrument's axis
  T beside_x{}, beside_y{};  ///< n axis - outside, level components; 0 unless that looks away
  T one_minus_cos{};         ///< of its half angle; 0: parallel rays
  T steep{1};                ///< cosine of the axis to the vertical, > 0
  bool in_air = false;
  bool by_depth =
      false;           ///< depths of first vertices are drawn as along the axis, whatever the ray
  bool exact = false;  ///< all its rays are the instrument's own
  Spot<T> spot;

  [[nodiscard]] T solid_angle() const { return T(2 * pi) * one_minus_cos; }

  /// A ray's directions outside are drawn with 1 over this density [sr]. `n`: of its line; cosines
  /// to the vertical, either way.
  T solid_angle_outside(const T& n, const T& cos_water, const T& cos_air) const {
    using std::abs;
    if (!in_air) return solid_angle();
    return solid_angle() * (n * n) * abs(cos_water / cos_air);
  }

  /// What stands for exp(-tau') of a walk's first way where the cone draws depths: the chance to
  /// come there, per chance to collide there along the ray. `walk_tau`: of the way; `steep_ray`:
  /// cosine of the ray to the vertical, either way; `on_bed`: where nothing has to collide.
  T reach(const T& walk_tau, const T& steep_ray, const Mask<T>& on_bed) const {
    using std::abs;
    if (!by_depth) return exp_minus(walk_tau);
    const T ratio = abs(steep_ray) / steep;
    return exp_minus(walk_tau * ratio) * select(on_bed, T(1), ratio);
  }
  /// exp(-tau') over that.
  T over_reach(const T& walk_tau, const T& steep_ray, const Mask<T>& on_bed) const {
    using std::abs;
    if (!by_depth) return T(1);
    const T ratio = abs(steep_ray) / steep;
    return exp_minus(walk_tau * (T(1) - ratio)) * select(on_bed, T(1), T(1) / ratio);
  }
  /// By how much longer free paths along a ray are drawn, for that.
  T longer_free_path(const T& steep_ray) const {
    using std::abs;
    return by_depth ? steep / abs(steep_ray) : T(1);
  }
};

/// The same of rays of which those of a mask leave the instrument.
template <class T>
T reach_along(const EntryCone<T>& cone, const Mask<T>& first, const T& walk_tau, const T& steep_ray,
              const Mask<T>& on_bed) {
  const T straight = exp_minus(walk_tau);
  if (!cone.by_depth || !any(first)) return straight;
  return select(first, cone.reach(walk_tau, steep_ray, on_bed), straight);
}

/// A ray of a cone, and how it goes on outside.
template <class T>
struct EntryRay {
  Vec3<T> direction;  ///< in the water, away from the instrument: a unit vector
  Vec3<T> outside;    ///< the same of the ray outside
  Vec3<T> off_axis;   ///< that less the instrument's axis
  T solid_angle{};    ///< its directions outside are drawn with 1 over this density [sr]
  Mask<T> exists{};   ///< light of a line can come through the surface by it
};

/// Completes one whose direction in the water is `off_axis` from the cone's axis. `n`: of the
/// line; `n_axis`: of the laser's line.
template <class T>
EntryRay<T> entry_ray(const EntryCone<T>& cone, const T& n, const T& n_axis,
                      const Vec3<T>& direction, const Vec3<T>& off_axis) {
  using std::abs;
  using std::sqrt;
  EntryRay<T> ray;
  ray.direction = direction;
  ray.solid_angle = cone.solid_angle();
  ray.exists = Mask<T>(true);
  if (!cone.in_air) {
    ray.outside = direction;
    ray.off_axis = off_axis;
    return ray;
  }
  const T x = n * direction.x, y = n * direction.y;
  const T squared = T(1) - (x * x + y * y);
  ray.exists = squared > T(0);
  const T steep = sqrt(select(ray.exists, squared, T(1)));
  ray.outside = {x, y, -steep};
  const T beside_x = n * off_axis.x + ((n - n_axis) * cone.axis.x + cone.beside_x);
  const T beside_y = n * off_axis.y + ((n - n_axis) * cone.axis.y + cone.beside_y);
  // -steep - axis.z, by the difference of their squares.
  const T sum = steep - cone.outside.z;
  const T by_squares = (beside_x * (x + cone.outside.x) + beside_y * (y + cone.outside.y)) /
                       select(sum > T(0), sum, T(1));
  ray.off_axis = {beside_x, beside_y,
                  select(sum > T(0), by_squares, T(0) - (steep + cone.outside.z))};
  ray.solid_angle = cone.solid_angle_outside(n, direction.z, steep);
  return ray;
}

/// From two uniforms.
template <class T>
EntryRay<T> draw_entry(const EntryCone<T>& cone, const T& n, const T& n_axis, const T& u_polar,
                       const T& u_azimuth) {
  using std::sqrt;
  const auto [cosine, sine] = cos_sin_of_turns(u_azimuth);
  const T x = u_polar * cone.one_minus_cos;
  const Vec3<T> off_axis =
      sqrt(x * (T(2) - x)) * turned(cone.axis, T(1), cosine, sine) - x * cone.axis;
  return entry_ray(cone, n, n_axis, cone.axis + off_axis, off_axis);
}

/// Of a telescope, whose light may be of any line, and of the laser, their places told from the
/// origin. `deepest`: of the water that counts [m].
EntryCone<double> entry_cone(const scene::Telescope& telescope, const medium::Medium& medium,
                             double deepest);
EntryCone<double> entry_cone(const scene::Source& source, const medium::Medium& medium,
                             double deepest);

template <class T>
EntryCone<T> cone_cast(const EntryCone<double>& c) {
  const auto& s = c.spot;
  return {vec3_cast<T>(c.axis),
          vec3_cast<T>(c.outside),
          T(c.beside_x),
          T(c.beside_y),
          T(c.one_minus_cos),
          T(c.steep),
          c.in_air,
          c.by_depth,
          c.exact,
          {T(s.x), T(s.y), T(s.x_per_depth), T(s.y_per_depth), T(s.radius), T(s.radius_per_depth),
           T(s.least_path), T(s.least_path_per_depth), T(s.most_shorter)}};
}

}  // namespace photic::estimator
