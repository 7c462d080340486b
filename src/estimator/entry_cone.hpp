// The directions in which the bidirectional estimator's walks begin. Walks that may be free begin
// evenly in a cone in the water about an instrument's axis, as the flat surface refracts that: such
// a walk's draws beyond its first vertex are as likely wherever its instrument stands (theory.md,
// "Free walks"). The others begin with the instrument's own rays, evenly in its cone outside.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/constants.hpp"
#include "core/elementary.hpp"
#include "core/turn.hpp"
#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// The spot of an instrument's rays in the water, and their least path there: a circle about its
/// axis that widens with depth.
template <class T>
struct Spot {
  T x{}, y{}, x_per_depth{}, y_per_depth{};  ///< of the axis, from the instrument's middle [m]
  T radius{}, radius_per_depth{};
  T min_path{}, min_path_per_depth{};  ///< as walks count it [m]
  T max_shorter{};                     ///< a ray's way becomes shorter by no more [m]
};

/// A part of a cone, from that within it on, in which directions are drawn evenly.
template <class T>
struct EntryRing {
  T one_minus_cos{};  ///< of its outer half angle; 0: parallel rays
  T up_to{};          ///< share of directions within that
  T solid_angle{};    ///< density of directions in the ring is 1 over that [sr]
};

template <class T>
struct EntryCone {
  static constexpr std::size_t max_rings = 8;

  Vec3<T> axis;              ///< in the water, away from the instrument: a unit vector
  Vec3<T> outside;           ///< the instrument's axis
  T beside_x{}, beside_y{};  ///< n axis - outside, level components; 0 unless that looks away
  std::array<EntryRing<T>, max_rings> ring;  ///< from the axis outwards
  std::size_t rings = 1;
  T steep{1};  ///< cosine of the axis to the vertical, > 0
  bool begins_outside = false;
  bool even_outside = false;  ///< rays lie evenly about `outside`, else in the water about `axis`
  bool by_depth =
      false;           ///< depths of first vertices are drawn as along the axis, whatever the ray
  bool exact = false;  ///< all its rays are the instrument's own
  // Under waves:
  T free_within{4};  ///< 1 - cos of the part that free walks begin in
  T free_share{1};   ///< of walks that begin there
  T by_facets{};     ///< of those that draw their facets instead: several, or any of waves of one
                     ///< direction; of an instrument in the water all that send its rays back
  bool enters_by_slopes = false;  ///< entries are also drawn by slopes
  bool about_rays = false;  ///< directions in the water are drawn about each ray of the instrument,
                            ///< as the flat surface refracts it, not about the axis
  Spot<T> spot;

  /// The share of the others: they come by one facet, or straight from an instrument in the water.
  [[nodiscard]] T others() const { return T(1) - by_facets; }
  /// Returns whether free walks begin in a direction in the water.
  [[nodiscard]] Mask<T> frees(const Vec3<T>& direction) const {
    return photic::one_minus_cos(direction, axis) < free_within;
  }

  /// 1 - cos of its half angle; 0: parallel rays.
  [[nodiscard]] const T& one_minus_cos() const { return ring[rings - 1].one_minus_cos; }

  /// Directions so far off the axis are drawn with 1 over this density [sr]. `x`: 1 - cos.
  [[nodiscard]] T solid_angle_at(const T& x) const {
    T here = ring[rings - 1].solid_angle;
    for (std::size_t k = rings - 1; k-- > 0;)
      here = select(x < ring[k].one_minus_cos, ring[k].solid_angle, here);
    return here;
  }
  /// From a uniform, 1 - cos of the angle to the axis.
  [[nodiscard]] T draw(const T& u) const {
    T x = u * (ring[0].solid_angle * T(0.5 / pi));
    for (std::size_t k = 1; k < rings; ++k) {
      const auto& within = ring[k - 1];
      x = select(u < within.up_to, x,
                 within.one_minus_cos + (u - within.up_to) * (ring[k].solid_angle * T(0.5 / pi)));
    }
    return x;
  }

  /// A ray's directions outside are drawn with 1 over this density [sr]. `n`: of its line; `water`,
  /// `outside`: the ray, away from the instrument.
  T solid_angle_outside(const T& n, const Vec3<T>& water, const Vec3<T>& outside) const {
    using std::abs;
    const bool about_outside = !begins_outside || even_outside;
    T here = ring[0].solid_angle;
    if (rings > 1)
      here = solid_angle_at(about_outside ? photic::one_minus_cos(outside, this->outside)
                                          : photic::one_minus_cos(water, axis));
    if (about_outside) return here;
    return here * (n * n) * abs(water.z / outside.z);
  }

  /// The chance that a walk comes so far by a ray: exp(-tau'), and for a `first` one, where the
  /// cone draws depths, that to come there per chance to collide there along the ray. `walk_tau`:
  /// of the way; `steep_ray`: cosine of the ray to the vertical, either way; `on_bed`: where
  /// nothing has to collide.
  T reach(const Mask<T>& first, const T& walk_tau, const T& steep_ray,
          const Mask<T>& on_bed) const {
    using std::abs;
    if (!by_depth || !any(first)) return exp_minus(walk_tau);
    const T ratio = select(first, T(abs(steep_ray) / steep), T(1));
    return exp_minus(walk_tau * ratio) * select(on_bed, T(1), ratio);
  }
  /// exp(-tau') over that, of a first ray.
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

/// A ray of a cone, and how it goes on outside.
template <class T>
struct EntryRay {
  Vec3<T> direction;  ///< in the water, away from the instrument: a unit vector
  Vec3<T> outside;    ///< the same of the ray outside
  Vec3<T> off_axis;   ///< that less the instrument's axis
  T solid_angle{};    ///< its directions outside are drawn with 1 over this density [sr]
  Mask<T> exists{};   ///< light of a line can come through the surface by it
};

/// A ray that comes down through the flat surface, in the water.
template <class T>
Vec3<T> refracted_down(const Vec3<T>& outside, const T& n) {
  using std::sqrt;
  const T x = outside.x / n, y = outside.y / n;
  return {x, y, T(0) - sqrt(T(1) - (x * x + y * y))};
}

/// Completes a ray whose direction outside is `off_axis` from the instrument's axis. `n`: of the
/// line.
template <class T>
EntryRay<T> entry_ray_outside(const EntryCone<T>& cone, const T& n, const Vec3<T>& outside,
                              const Vec3<T>& off_axis) {
  EntryRay<T> ray{outside, outside, off_axis, cone.solid_angle_outside(n, outside, outside),
                  Mask<T>(true)};
  if (!cone.begins_outside) return ray;
  ray.exists = outside.z < T(0);
  ray.direction = refracted_down(outside, n);
  return ray;
}
/// Completes a ray whose direction in the water is `off_axis` from the cone's axis. `n_axis`: of
/// the laser's line.
template <class T>
EntryRay<T> entry_ray(const EntryCone<T>& cone, const T& n, const T& n_axis,
                      const Vec3<T>& direction, const Vec3<T>& off_axis) {
  using std::sqrt;
  if (!cone.begins_outside) return entry_ray_outside(cone, n, direction, off_axis);
  EntryRay<T> ray;
  ray.direction = direction;
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
  ray.solid_angle = cone.solid_angle_outside(n, direction, ray.outside);
  return ray;
}

/// Directions in the water that are drawn evenly about an axis, from two uniforms.
template <class T>
Vec3<T> direction_about(const Vec3<T>& axis, const EntryCone<T>& cone, const T& u_polar,
                        const T& u_azimuth) {
  const auto [cosine, sine] = cos_sin_of_turns(u_azimuth);
  return turned(axis, cone.draw(u_polar), cosine, sine);
}

/// From two uniforms.
template <class T>
EntryRay<T> draw_entry(const EntryCone<T>& cone, const T& n, const T& n_axis, const T& u_polar,
                       const T& u_azimuth) {
  using std::sqrt;
  const auto [cosine, sine] = cos_sin_of_turns(u_azimuth);
  const Vec3<T>& axis = cone.even_outside ? cone.outside : cone.axis;
  const T x = cone.draw(cone.others() * u_polar);
  const Vec3<T> off_axis = sqrt(x * (T(2) - x)) * turned(axis, T(1), cosine, sine) - x * axis;
  if (cone.even_outside) return entry_ray_outside(cone, n, axis + off_axis, off_axis);
  return entry_ray(cone, n, n_axis, axis + off_axis, off_axis);
}

/// With its digits, of small angles too [rad].
inline double one_minus_cos_of(double angle) { return 2 * std::pow(std::sin(angle / 2), 2); }

/// A narrower cone about the same axis outside, in which a share of the walks begins.
struct InnerCone {
  double half_angle = 0;  ///< [rad]
  double share = 0;
};

/// By how much the rays that a telescope sees are off its axis at most [rad].
double half_view(const scene::Telescope& telescope);

/// The cone of a telescope, whose light may be of any line, and of the laser, their places relative
/// to the origin; for free walks. `deepest`: of the water that counts [m].
EntryCone<double> entry_cone(const scene::Telescope& telescope, const medium::Medium& medium,
                             double deepest, const std::vector<InnerCone>& inner = {});
EntryCone<double> entry_cone(const scene::Source& source, const medium::Medium& medium,
                             double deepest);
/// Returns whether, under waves, an instrument's entries are also drawn by slopes: only then walks
/// are free.
bool enters_by_slopes(const scene::Telescope& telescope, const medium::Medium& medium);
bool enters_by_slopes(const scene::Source& source, const medium::Medium& medium);
/// The same under waves. `frees`: for free walks.
EntryCone<double> cone_under_waves(const scene::Telescope& telescope, const medium::Medium& medium,
                                   double deepest, bool frees);
EntryCone<double> cone_under_waves(const scene::Source& source, const medium::Medium& medium,
                                   double deepest, bool frees);
/// Has a share of the walks begin at the facets that send rays back, if any rays go up: for an
/// instrument in the water under waves, whose rays are off its axis by no more [rad].
void begin_some_at_facets(double half_angle, EntryCone<double>& cone);
/// The same of walks that are not free: of the instrument's own rays.
EntryCone<double> cone_of_own_rays(const scene::Telescope& telescope, const medium::Medium& medium,
                                   const std::vector<InnerCone>& inner = {});
EntryCone<double> cone_of_own_rays(const scene::Source& source, const medium::Medium& medium);

template <class T>
EntryCone<T> cone_cast(const EntryCone<double>& c) {
  const auto& s = c.spot;
  EntryCone<T> out;
  out.axis = vec3_cast<T>(c.axis);
  out.outside = vec3_cast<T>(c.outside);
  out.beside_x = T(c.beside_x);
  out.beside_y = T(c.beside_y);
  for (std::size_t k = 0; k < c.rings; ++k)
    out.ring[k] = {T(c.ring[k].one_minus_cos), T(c.ring[k].up_to), T(c.ring[k].solid_angle)};
  out.rings = c.rings;
  out.steep = T(c.steep);
  out.begins_outside = c.begins_outside;
  out.even_outside = c.even_outside;
  out.by_depth = c.by_depth;
  out.exact = c.exact;
  out.free_within = T(c.free_within);
  out.free_share = T(c.free_share);
  out.by_facets = T(c.by_facets);
  out.enters_by_slopes = c.enters_by_slopes;
  out.about_rays = c.about_rays;
  out.spot = {T(s.x),           T(s.y),
              T(s.x_per_depth), T(s.y_per_depth),
              T(s.radius),      T(s.radius_per_depth),
              T(s.min_path),    T(s.min_path_per_depth),
              T(s.max_shorter)};
  return out;
}

}  // namespace photic::estimator
