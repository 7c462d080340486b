// The beginnings of the bidirectional estimator's walks: the laser's light, and the way back of the
// light that falls on a telescope's detector.
#pragma once

#include "estimator/bidirectional/vertex.hpp"
#include "estimator/entry_cone.hpp"
#include "geometry/region.hpp"
#include "instrument/laser.hpp"
#include "instrument/lens.hpp"
#include "surface/flat.hpp"
#include "transport/emit.hpp"

namespace photic::estimator {

/// The point where an instrument's ray comes through waves. For a telescope in the water only the
/// uniforms.
template <class T>
struct SurfaceEntry {
  Mask<T> exists{true};                  ///< not kept
  Vec3<T> at;                            ///< point of the surface
  Vec3<T> outside;                       ///< direction of the ray, away from the instrument
  T weight{1};                           ///< of a walk there, in the air
  T path{};                              ///< [m]
  T u_choice{}, u_slope{}, u_azimuth{};  ///< uniforms, for points that are drawn by slopes

  template <class F>
  constexpr void each_member(F f) {
    f(at.x), f(at.y), f(outside.x), f(outside.y), f(outside.z), f(weight), f(path);
    f(u_choice), f(u_slope), f(u_azimuth);
  }
};

/// A walk that stands in the water, and how its light has spread on the way there.
template <class T>
struct Birth {
  Mask<T> exists{};  ///< its ray comes through the surface
  Mask<T> own{};     ///< its ray is one of the instrument's own; else it has to be moved
  transport::Photon<T> photon;
  Spread<T> spread;
  Index<T> facets{};           ///< of BirthRecord
  instrument::Sight<T> sight;  ///< a telescope's view by it
  SurfaceEntry<T> entry;       ///< if it comes through waves
};

/// A ray of an entry cone that leaves its instrument, or a plane across its axis `ahead` of it, at
/// `start`; `before`: length from the point that light spreads from to there.
template <class T>
Birth<T> birth_in_water(const medium::MediumView& sea, const geometry::Region<T>& region,
                        const EntryRay<T>& ray, const Vec3<T>& start, const T& before,
                        const Index<T>& line) {
  Birth<T> birth;
  birth.exists = ray.exists;
  birth.photon.position = start;
  birth.photon.direction = ray.direction;
  birth.photon.line = line;
  birth.photon.layer = region.layer;
  birth.spread.solid_angle = ray.solid_angle;
  birth.spread.before = before;
  if (!region.outside) return birth;
  const T cos_air = T(0) - ray.outside.z;
  const T distance = start.z / cos_air;
  birth.photon.position = {start.x + distance * ray.outside.x, start.y + distance * ray.outside.y,
                           T(0)};
  birth.photon.path = distance;
  birth.photon.weight =
      surface::flat_surface<T>(sea, line).transmittance(-ray.direction.z, cos_air);
  if (region.column.exists()) [[unlikely]] {
    birth.photon.weight = birth.photon.weight * region.through_column(line, cos_air);
    birth.photon.path = distance + region.delay(line, cos_air);
  }
  birth.spread.through_surface = true;
  birth.spread.before = before + distance;
  birth.spread.cos_air = cos_air;
  return birth;
}

/// The distance aside of an instrument's ray per length along the axis; 0 if that leads back.
template <class T>
T along_axis(const EntryCone<T>& cone, const EntryRay<T>& ray) {
  const T cosine = T(1) + dot(ray.off_axis, cone.outside);
  return select(cosine > T(0), cosine, T(0));
}

/// The laser's walk. Its weight is what the laser emits in such directions over what is drawn.
template <class T>
Birth<T> birth_at_laser(const medium::MediumView& sea, const instrument::Laser<T>& laser,
                        const geometry::Region<T>& region, const EntryCone<T>& cone,
                        const EntryRay<T>& ray) {
  const T cosine = along_axis(cone, ray);
  const Mask<T> ahead = cosine > T(0);
  const T secant = T(1) / select(ahead, cosine, T(1));
  const T to_start = laser.vertex_distance + laser.ahead;
  const Vec3<T> aside = secant * (ray.off_axis - dot(ray.off_axis, cone.outside) * cone.outside);
  auto birth = birth_in_water(sea, region, ray, laser.start + to_start * aside, to_start * secant,
                              Index<T>(0));
  const T x = T(0.5) * dot(ray.off_axis, ray.off_axis);
  const Mask<T> emitted = cone.exact ? Mask<T>(true) : laser.emits(x);
  birth.own = birth.exists & ahead & emitted;
  birth.photon.path = birth.photon.path + (laser.ahead * (x * secant) - laser.to_sea);
  birth.photon.weight = birth.photon.weight * ray.solid_angle / (T(2 * pi) * laser.even_within(x));
  if (!can_be_met(laser)) birth.spread.solid_angle = T(0);
  return birth;
}
/// The same of parallel rays, from two uniforms.
template <class T>
Birth<T> birth_at_collimated_laser(const medium::MediumView& sea, const instrument::Laser<T>& laser,
                                   const geometry::Region<T>& region, const EntryCone<T>& cone,
                                   const T& n, const T& u_radius, const T& u_azimuth) {
  const auto photon = transport::emit(laser, region.layer, u_radius, u_azimuth);
  const auto ray = entry_ray_outside(cone, n, laser.axis, {T(0), T(0), T(0)});
  auto birth = birth_in_water(sea, region, ray, photon.position, T(0), Index<T>(0));
  birth.photon.weight = birth.photon.weight / cone.others();
  birth.photon.path = birth.photon.path - laser.to_sea;
  return birth;
}

/// A telescope's walk from a point of its lens. It carries étendue: the weight begins with that of
/// all rays of the cone, and takes T (n_i / n_t)^2 at the surface. In the air its path is what it
/// is longer than from the lens' centre to the origin.
template <class T>
Birth<T> birth_at_telescope(const medium::MediumView& sea,
                            const instrument::Telescope<T>& telescope,
                            const geometry::Region<T>& region, const EntryCone<T>& cone,
                            const EntryRay<T>& ray, const Index<T>& line,
                            const instrument::PlanePoint<T>& lens) {
  const T cosine = along_axis(cone, ray);
  const Mask<T> ahead = cosine > T(0);
  const T cos_off_axis = select(ahead, cosine, T(1));
  const auto slope = (T(1) / cos_off_axis) * parts_in_plane(telescope, ray.off_axis);
  auto birth = birth_in_water(sea, region, ray,
                              telescope.start + in_plane(telescope, lens + telescope.ahead * slope),
                              telescope.ahead / cos_off_axis, line);
  birth.sight = sight_along(telescope, lens, slope);
  const Mask<T> seen = cone.exact ? Mask<T>(true) : birth.sight.on_detector;
  birth.own = birth.exists & ahead & seen;
  birth.photon.weight = birth.photon.weight * (telescope.area() * cos_off_axis * ray.solid_angle);
  if (telescope.above_air)
    birth.photon.path = longer_way(telescope, birth.photon.position, lens, birth.spread.before);
  if (!region.outside) return birth;
  const T inverse_n = gather<T>(sea.inverse_index, line);
  birth.photon.weight = birth.photon.weight * (inverse_n * inverse_n);
  birth.photon.path = longer_way(telescope, birth.photon.position, lens, birth.spread.before) +
                      region.delay(line, birth.spread.cos_air);
  return birth;
}

}  // namespace photic::estimator
