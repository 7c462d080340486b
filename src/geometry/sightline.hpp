// The straight ways from a point in the water to one point of an instrument: through the flat
// surface, directly, or mirrored in the surface from below. What the telescope's field of view is
// to connect.hpp, the single ray is here.
#pragma once

#include <cmath>

#include "geometry/crossing.hpp"
#include "geometry/depths.hpp"
#include "medium/medium.hpp"
#include "optics/fresnel.hpp"

namespace photic::geometry {

template <class T>
struct Sightline {
  Mask<T> exists{};
  Vec3<T> direction;   ///< in which light leaves the point in the water, a unit vector
  Vec3<T> arriving;    ///< in which it reaches the instrument, a unit vector
  T length_water{};    ///< [m]
  T length_air{};      ///< [m]
  Vec3<T> crossing{};  ///< where it passes the surface
  T secant_water{};    ///< 1 over the cosine to the vertical; only of ways through the surface
  T area_per_solid_angle{};  ///< across the ray at the instrument, in the water [m^2/sr]
  T index_squared{1};        ///< of the water against the instrument's medium
  T passed{1};               ///< share that passes the surface, or is reflected by it
};

/// Through the surface to a point above it. Where `wanted` is false only the directions are
/// promised, to a few per cent of their angle.
template <class T>
Sightline<T> sightline_through_surface(const medium::MediumView& sea, const Vec3<T>& from,
                                       const Index<T>& line, const Vec3<T>& to,
                                       const Mask<T>& wanted) {
  const T n = gather<T>(sea.index, line);
  const T inverse_n = gather<T>(sea.inverse_index, line);
  const T depth = -from.z;
  const T dx = to.x - from.x;
  const T dy = to.y - from.y;
  const T aside_squared = dx * dx + dy * dy;
  auto start = crossing_start(inverse_n, depth, to.z, aside_squared);
  start.error = select(wanted, start.error, T(0));  // no steps for the others
  const T per_rise = crossing(n, depth, to.z, aside_squared, start);
  const RefractedRay<T> ray = refracted_ray(n, inverse_n, dx, dy, aside_squared, per_rise);

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
  way.passed = T(1) - optics::fresnel_reflectance(n, T(1), ray.cos_water, ray.cos_air);
  return way;
}

/// Within the water, directly or by way of the surface seen from below.
template <class T>
Sightline<T> sightline_in_water(const medium::MediumView& sea, const Vec3<T>& from,
                                const Index<T>& line, const Vec3<T>& to, bool mirrored) {
  using std::abs;
  using std::sqrt;
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
    way.passed =
        optics::refract(gather<T>(sea.index, line), T(1), abs(way.direction.z)).reflectance;
  return way;
}

/// Optical depths of a way's first `length` in the water, which ends in a layer.
template <class T>
OpticalDepths<T> depths_through_surface(const medium::MediumView& sea, const Sightline<T>& way,
                                        const Index<T>& line, const Index<T>& layer,
                                        const T& depth) {
  const auto at = sea.level(layer, depth);
  return {sea.optical_depth(line, at) * way.secant_water,
          sea.walk_optical_depth(line, at) * way.secant_water};
}
/// By way of the surface, from one depth to another.
template <class T>
OpticalDepths<T> depths_by_surface(const medium::MediumView& sea, const Index<T>& line,
                                   const Index<T>& layer1, const T& depth1, const Index<T>& layer2,
                                   const T& depth2, const T& secant) {
  const auto from = sea.level(layer1, depth1);
  const auto to = sea.level(layer2, depth2);
  return {(sea.optical_depth(line, from) + sea.optical_depth(line, to)) * secant,
          (sea.walk_optical_depth(line, from) + sea.walk_optical_depth(line, to)) * secant};
}
template <class T>
OpticalDepths<T> depths_in_water(const medium::MediumView& sea, const Sightline<T>& way,
                                 const Index<T>& line, const Index<T>& layer, const T& depth,
                                 const Index<T>& end_layer, const T& length, bool mirrored) {
  using std::abs;
  if (mirrored) {
    const T steep = abs(way.direction.z);
    return depths_by_surface(sea, line, layer, depth, end_layer, T(length * steep - depth),
                             T(T(1) / steep));
  }
  return depths_between(sea, line, sea.level(layer, depth),
                        sea.level(end_layer, T(depth - length * way.direction.z)), length);
}

}  // namespace photic::geometry
