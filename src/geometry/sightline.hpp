// The ways from a point in the water to one point of an instrument, through all interfaces between
// them: through the flat surface, straight, or reflected by the surface from below.
#pragma once

#include <cmath>

#include "geometry/crossing.hpp"
#include "geometry/region.hpp"
#include "geometry/segment.hpp"
#include "medium/medium.hpp"
#include "surface/flat.hpp"

namespace photic::geometry {

template <class T>
struct Sightline {
  Mask<T> exists{};
  Vec3<T> direction;   ///< in which light leaves the point in the water, a unit vector
  Vec3<T> arriving;    ///< in which it reaches the instrument, a unit vector
  T length_water{};    ///< [m]
  T length_air{};      ///< [m]
  Vec3<T> crossing{};  ///< its point on the surface
  T secant_water{};    ///< 1 over the cosine to the vertical; only of ways through the surface
  T area_per_solid_angle{};  ///< across the ray at the instrument, in the water [m^2/sr]
  T index_squared{1};        ///< of the water against the instrument's medium
  T throughput{1};           ///< share of light that the surface lets pass, or reflects
  Region<T> to{};            ///< the instrument's
  T stretch{1};              ///< of its column
  Route route = Route::direct;
};

/// The sightline through the surface to a point above it. Where `wanted` is false only the
/// directions are promised, to a few per cent of their angle.
template <class T>
Sightline<T> sightline_through_surface(const medium::MediumView& sea, const Vec3<T>& from,
                                       const Index<T>& line, const Vec3<T>& to,
                                       const Mask<T>& wanted) {
  const auto surface = surface::flat_surface<T>(sea, line);
  const T &n = surface.n, &inverse_n = surface.inverse_n;
  const T depth = -from.z;
  const RefractedRay<T> ray = ray_through(n, inverse_n, sea.surface.denser_outside, depth, to.z,
                                          T(to.x - from.x), T(to.y - from.y), wanted)
                                  .ray;

  Sightline<T> way;
  way.exists = wanted;
  way.direction = ray.direction;
  way.arriving = ray.cos_air * ray.arriving;
  way.secant_water = ray.secant_water;
  way.length_water = depth * ray.secant_water;
  way.length_air = to.z * ray.secant_air;
  way.crossing = crossed_at(from, ray, way.length_water);
  way.area_per_solid_angle =
      (n * n) *
      refracted_area_per_solid_angle(inverse_n, way.length_water, way.length_air, widening(ray));
  way.index_squared = n * n;
  way.throughput = surface.transmittance(ray.cos_water, ray.cos_air);
  return way;
}

/// Within the water.
template <class T>
Sightline<T> sightline_in_water(const medium::MediumView& sea, const Vec3<T>& from,
                                const Index<T>& line, const Vec3<T>& to, Route route) {
  using std::abs;
  using std::sqrt;
  const bool mirrored = route == Route::mirrored;
  const Vec3<T> there = Vec3<T>{to.x, to.y, mirrored ? -to.z : to.z} - from;
  const T squared = dot(there, there);
  Sightline<T> way;
  way.exists = squared > T(0);
  const T safe = select(way.exists, squared, T(1));
  way.length_water = sqrt(safe);
  way.direction = (T(1) / way.length_water) * there;
  way.arriving = {way.direction.x, way.direction.y, mirrored ? -way.direction.z : way.direction.z};
  way.area_per_solid_angle = safe;
  if (mirrored)
    way.throughput = surface::flat_surface<T>(sea, line).reflectance(T(abs(way.direction.z)));
  way.route = route;
  return way;
}

/// By one of the routes to a region. `wanted`: of those through the surface.
template <class T>
Sightline<T> sightline(const medium::MediumView& sea, const Vec3<T>& from, const Index<T>& line,
                       const Vec3<T>& to, const Region<T>& region, Route route,
                       const Mask<T>& wanted) {
  auto way = region.outside ? sightline_through_surface(sea, from, line, to, wanted)
                            : sightline_in_water(sea, from, line, to, route);
  if (region.column.exists()) [[unlikely]] {
    way.stretch = region.stretch(to.z);
    way.throughput = way.throughput * region.through_column(line, way.arriving.z, way.stretch);
  }
  way.to = region;
  return way;
}

/// The first `length` in the water of a way from a level there. `start`: its place; where the sea
/// is a row of columns.
template <class T>
Segment<T> along(const medium::MediumView& sea, const Sightline<T>& way, const Index<T>& line,
                 const medium::Level<T>& from, const T& length, const Vec3<T>& start = {}) {
  using std::abs;
  const Ray<T> ray{start, way.direction};
  if (way.to.outside)
    return to_surface(line, from, length, Slant<T>::of_secant(way.secant_water), ray);
  const T risen = length * way.direction.z;
  if (way.route == Route::direct)
    return {line, from, sea.level(way.to.layer, T(from.depth - risen)), length, ray};
  const T steep = abs(way.direction.z);
  return by_surface(line, from, sea.level(way.to.layer, T(length * steep - from.depth)), length,
                    Slant<T>::of_secant(T(T(1) / steep)), ray);
}

}  // namespace photic::geometry
