// Points of the mean surface by which light may go on from a point in the water to one of a
// telescope's lens: how they are drawn, and with what density.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "geometry/sightline.hpp"
#include "instrument/lens.hpp"
#include "surface/waves.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// Three uniforms.
template <class T>
struct SurfacePointUniforms {
  T choice{}, radius{}, azimuth{};
};

/// Slopes that lead by a point near the one by which a level surface leads light on: they grow
/// evenly with the distance from it.
template <class T>
struct NearLevel {
  Vec3<T> at;          ///< by which a level surface leads
  T xx{}, xy{}, yy{};  ///< slope per metre: a symmetric matrix

  [[nodiscard]] T determinant() const { return xx * yy - xy * xy; }
  /// The offset to which a slope leads.
  [[nodiscard]] Vec3<T> off(const T& slope_x, const T& slope_y) const {
    const T per = T(1) / determinant();
    return {per * (yy * slope_x - xy * slope_y), per * (xx * slope_y - xy * slope_x), T(0)};
  }
};
/// `k1`, `k2`: directions before and behind the point, `l1`, `l2` the lengths; `n1`, `n2`: indices.
template <class T>
NearLevel<T> near_level(const Vec3<T>& at, const T& n1, const Vec3<T>& k1, const T& l1, const T& n2,
                        const Vec3<T>& k2, const T& l2) {
  const T a = n1 / l1, b = n2 / l2;
  const T per_z = T(1) / (n2 * k2.z - n1 * k1.z);
  return {at, per_z * (a * (T(1) - k1.x * k1.x) + b * (T(1) - k2.x * k2.x)),
          per_z * (T(0) - a * k1.x * k1.y - b * k2.x * k2.y),
          per_z * (a * (T(1) - k1.y * k1.y) + b * (T(1) - k2.y * k2.y))};
}
/// For a way from a point in the water to one in a region.
template <class T>
NearLevel<T> near_level(const medium::MediumView& sea, const Vec3<T>& from, const Index<T>& line,
                        const Vec3<T>& to, const geometry::Region<T>& region,
                        const Mask<T>& wanted) {
  const auto route = region.outside ? geometry::Route::direct : geometry::Route::mirrored;
  const auto way = geometry::sightline(sea, from, line, to, region, route, wanted);
  const T to_surface = -from.z / way.direction.z;
  const Vec3<T> at = from + to_surface * way.direction;
  return near_level(at, region.outside ? gather<T>(sea.index, line) : T(1), way.direction,
                    to_surface, T(1), way.arriving,
                    region.outside ? way.length_air : T(way.length_water - to_surface));
}

/// A slope in space.
template <class T>
Vec3<T> in_space(const surface::WavesView& waves, const surface::Slope<T>& slope) {
  const T x = T(waves.upwind_x), y = T(waves.upwind_y);
  return {slope.upwind * x - slope.crosswind * y, slope.upwind * y + slope.crosswind * x, T(0)};
}
/// Points by slopes so many times as steep as the waves'.
inline constexpr double wider_slopes = 1.4;
template <class T>
Vec3<T> point_by_slopes(const NearLevel<T>& g, const surface::WavesView& waves, const T& u1,
                        const T& u2) {
  const Vec3<T> slope = T(wider_slopes) * in_space(waves, surface::sample_slope(waves, u1, u2));
  return g.at + g.off(slope.x, slope.y);
}
/// The density of such points, per level area [1/m^2].
template <class T>
T density_by_slopes(const NearLevel<T>& g, const surface::WavesView& waves, const Vec3<T>& at) {
  using std::abs;
  const T dx = at.x - g.at.x, dy = at.y - g.at.y;
  const T narrow = T(1 / wider_slopes);
  const auto slope = surface::by_wind(waves, T(narrow * (g.xx * dx + g.xy * dy)),
                                      T(narrow * (g.xy * dx + g.yy * dy)));
  return gaussian(waves, slope) * abs(g.determinant()) * (narrow * narrow);
}

/// The straight way from a point of the surface to one of the lens.
template <class T>
struct FromSurface {
  Vec3<T> at;  ///< the point of the surface
  Vec3<T> direction;
  T length{};
  instrument::Sight<T> sight;
  Mask<T> seen{};  ///< by the detector

  /// The point of the lens.
  [[nodiscard]] Vec3<T> lens() const { return at + length * direction; }
  /// The depth of the point of the lens, if it is in the water.
  [[nodiscard]] T depth() const { return T(0) - direction.z * length; }
  /// The distance from the surface of one that stands outside.
  [[nodiscard]] T height() const { return direction.z * length; }
  /// To the vertical, of a way up; of others 1.
  [[nodiscard]] T rising_cosine() const { return select(direction.z > T(0), direction.z, T(1)); }
};
template <class T>
FromSurface<T> from_surface(const instrument::Telescope<T>& telescope,
                            const instrument::PlanePoint<T>& lens, const Vec3<T>& at) {
  const Vec3<T> way = in_space(telescope, lens) - at;
  FromSurface<T> out;
  out.at = at;
  out.length = length(way);
  out.direction = (T(1) / out.length) * way;
  out.sight = sight(telescope, lens, out.direction);
  const Mask<T> leads = telescope.inside ? out.direction.z < T(0) : out.direction.z > T(0);
  out.seen = leads & out.sight.on_detector;
  return out;
}

/// Points on the rays that a detector sees through a point of the lens, alike for all points of the
/// detector.
template <class T>
struct SurfacePoint {
  Mask<T> exists{};  ///< the ray leads to the surface
  Vec3<T> at;
};
template <class T>
SurfacePoint<T> point_seen(const instrument::Telescope<T>& telescope,
                           const instrument::PlanePoint<T>& lens, const T& u1, const T& u2) {
  using namespace instrument;
  const auto image = ring_point(T(0), telescope.detector_radius, u1, u2);
  const auto slope =
      (T(1) / telescope.detector_distance) * image + (T(0) - telescope.per_sharp_range) * lens;
  const Vec3<T> out = outward(telescope, slope);
  const Vec3<T> start = telescope.start + in_plane(telescope, lens + telescope.ahead * slope);
  const Mask<T> leads = telescope.inside ? out.z > T(0) : out.z < T(0);
  const T distance = (T(0) - start.z) / select(leads, out.z, T(1));
  return {leads, {start.x + distance * out.x, start.y + distance * out.y, T(0)}};
}
/// The density of such points from which a way leads to the detector [1/m^2].
template <class T>
T density_seen(const instrument::Telescope<T>& telescope, const FromSurface<T>& way) {
  using std::abs;
  const T per_radius = telescope.detector_distance / telescope.detector_radius;
  const T& cosine = way.sight.cos_off_axis;
  return T(1 / pi) * per_radius * per_radius * abs(way.direction.z) /
         (cosine * cosine * cosine * way.length * way.length);
}

/// Points that light comes to which leaves a point in the water evenly upwards.
template <class T>
Vec3<T> point_above(const Vec3<T>& from, const T& u1, const T& u2) {
  const auto [cosine, sine] = cos_sin_of_turns(u2);
  const Vec3<T> direction = turned(Vec3<T>{T(0), T(0), T(1)}, T(T(1) - u1), cosine, sine);
  const T distance = -from.z / direction.z;
  return {from.x + distance * direction.x, from.y + distance * direction.y, T(0)};
}
/// `k1`, `l1`: direction to such a point, and how far it is.
template <class T>
T density_above(const Vec3<T>& k1, const T& l1) {
  return T(0.5 / pi) * k1.z / (l1 * l1);
}

/// Shares of these three kinds of points: whitecaps send light on by points that are neither.
struct PointShares {
  double seen, by_slopes, above;
};
inline PointShares point_shares(const surface::WavesView& waves) {
  if (waves.whitecap_fraction == 0) return {0.5, 0.5, 0};
  return {0.45, 0.45, 0.1};
}
/// One of them, by waves in two dimensions.
template <class T>
SurfacePoint<T> draw_point(const surface::WavesView& waves,
                           const instrument::Telescope<T>& telescope, const Vec3<T>& from,
                           const instrument::PlanePoint<T>& lens, const NearLevel<T>& level,
                           const SurfacePointUniforms<T>& u) {
  const auto [share_seen, share_slopes, share_above] = point_shares(waves);
  const Mask<T> by_detector = u.choice < T(share_seen);
  const auto seen = point_seen(telescope, lens, u.radius, u.azimuth);
  Vec3<T> at = select(by_detector, seen.at, point_by_slopes(level, waves, u.radius, u.azimuth));
  if (share_above > 0)
    at = select(u.choice >= T(share_seen + share_slopes), point_above(from, u.radius, u.azimuth),
                at);
  const Mask<T> exists = seen.exists | (!by_detector);
  return {exists, at};
}

}  // namespace photic::transport
