// The ways from a point in the water into a telescope: through the flat surface, straight, or
// reflected by the surface from below (docs/theory.md, "The local estimate").
#pragma once

#include <cmath>

#include "geometry/crossing.hpp"
#include "geometry/region.hpp"
#include "geometry/segment.hpp"
#include "instrument/disc.hpp"
#include "instrument/lens.hpp"
#include "medium/medium.hpp"
#include "surface/flat.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// One way from a point to a telescope. Where the detector sees no lane only the first member is
/// filled in.
template <class T>
struct Connection {
  Vec3<T> direction;  ///< in which light must leave the point
  T acceptance{};  ///< solid angle about it that ends on the detector, surface losses included [sr]
  T optical_depth{};                ///< of the way
  geometry::Segment<T> in_water{};  ///< its part there; of waves up to the surface
  T secant_air{};  ///< of a way through the surface, 1 over the cosine to the vertical
  T path{};        ///< length times group index; in the air, what its way there is longer than
                   ///< from the lens' centre to the origin [m]
};

/// The rise to a telescope that a point seems to have from straight above it.
template <class T>
T paraxial_rise(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                const Vec3<T>& position, const Index<T>& line) {
  return telescope.position.z - position.z * gather<T>(sea.inverse_index, line);
}

/// Returns whether a telescope's detector may see a point; cheap, for most lie far outside its
/// field of view.
template <class T>
Mask<T> may_see(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                const Vec3<T>& position, const Index<T>& line) {
  if (telescope.inside || sea.surface.denser_outside) return Mask<T>(true);
  // The true angle is never below the paraxial one.
  return telescope.may_see_beyond(telescope.position.x - position.x,
                                  telescope.position.y - position.y,
                                  paraxial_rise(sea, telescope, position, line));
}

/// The same of the way to one point of the lens.
template <class T>
Mask<T> may_see(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                const Vec3<T>& position, const Index<T>& line,
                const instrument::PlanePoint<T>& lens) {
  if (telescope.inside || sea.surface.denser_outside) return Mask<T>(true);
  return may_see_by_ray(telescope, lens, telescope.position.x - position.x,
                        telescope.position.y - position.y,
                        paraxial_rise(sea, telescope, position, line));
}

/// From a photon's position through the surface to a telescope in the air, at the given line.
/// `may_be_seen`: whether may_see(); nothing is seen elsewhere.
template <class T>
Connection<T> connect_through_surface(const geometry::Slabs& sea,
                                      const instrument::Telescope<T>& telescope,
                                      const Photon<T>& at, const Index<T>& line,
                                      const Mask<T>& may_be_seen) {
  using std::sqrt;
  Connection<T> way;
  const auto surface = surface::flat_surface<T>(sea, line);
  const T &n = surface.n, &inverse_n = surface.inverse_n;
  const T depth = geometry::depth_of(at.position);
  const T height = telescope.position.z;
  const auto [ray, per_rise] =
      geometry::ray_through(n, inverse_n, sea.surface.denser_outside, depth, height,
                            T(telescope.position.x - at.position.x),
                            T(telescope.position.y - at.position.y), may_be_seen);
  const auto& [direction, arriving, secant_air, cos_air, secant_water, cos_water] = ray;
  way.direction = direction;
  const T towards = -dot(arriving, telescope.axis);
  const Mask<T> in_front = towards > T(0);
  const T safe_towards = select(in_front, towards, T(1));
  const T tan_off_axis = length(cross(arriving, telescope.axis)) / safe_towards;
  const T overlap = telescope.overlap(per_rise / safe_towards, tan_off_axis);
  const Mask<T> seen = may_be_seen & in_front & (overlap > T(0));
  if (!any(seen)) return way;
  const T in_water = depth * secant_water;
  const T in_air = height * secant_air;
  const T transmitted = surface.transmittance(cos_water, cos_air);
  const T area_per_solid_angle =
      (n * n) * geometry::refracted_area_per_solid_angle(inverse_n, in_water, in_air,
                                                         geometry::widening(ray));
  way.acceptance = select(
      seen,
      telescope.area() * (safe_towards * cos_air) * overlap * transmitted / area_per_solid_angle,
      T(0));
  const auto up = geometry::to_surface(line, geometry::level_of(sea, at), in_water,
                                       geometry::Slant<T>::of_secant(secant_water),
                                       geometry::Ray<T>{at.position, direction});
  way.optical_depth = geometry::optical_depths(sea, up).all;
  way.in_water = up;
  way.secant_air = secant_air;
  way.path = longer_way(telescope, geometry::crossed_at(at.position, ray, in_water), {}, in_air) +
             geometry::group_path(sea, up);
  return way;
}

/// Solid angle of a telescope's open lens from a point in the same medium, `distance` away under
/// the off-axis cosine `cos_off_axis` > 0: near the lens the exact one of disc less obstruction, so
/// that it stays below 2 pi.
template <class T>
T lens_solid_angle(const instrument::Telescope<T>& telescope, const T& distance,
                   const T& cos_off_axis) {
  using std::sqrt;
  const Mask<T> far = distance > T(instrument::far_radii) * telescope.lens_radius;
  const T from_afar = telescope.area() * cos_off_axis / (distance * distance);
  if (all(far)) return from_afar;
  const T height = distance * cos_off_axis;
  const T sine_squared = select(cos_off_axis < T(1), T(1) - cos_off_axis * cos_off_axis, T(0));
  const T aside = distance * sqrt(sine_squared);
  const T exact = instrument::disc_solid_angle(telescope.lens_radius, height, aside) -
                  instrument::disc_solid_angle(telescope.obstruction_radius, height, aside);
  return select(far, from_afar, exact);
}

template <class T>
Vec3<T> seen_by_route(const Vec3<T>& from, geometry::Route route) {
  return route == geometry::Route::mirrored ? geometry::mirror_image(from) : from;
}
/// The path of a way from a place, by a segment to a point of the lens, that stays in the medium of
/// the telescope.
template <class T>
T path_within(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
              const Vec3<T>& from, const geometry::Segment<T>& way,
              const instrument::PlanePoint<T>& lens) {
  if (!telescope.above_air) return geometry::group_path(sea, way);
  const auto route = way.course == geometry::Course::by_surface ? geometry::Route::mirrored
                                                                : geometry::Route::direct;
  return geometry::group_path(sea, way,
                              longer_way(telescope, seen_by_route(from, route), lens, way.length));
}

/// From a photon's position to a telescope in a layer of the water, at the given line.
template <class T>
Connection<T> connect_in_water(const geometry::Slabs& sea,
                               const instrument::Telescope<T>& telescope,
                               const Index<T>& telescope_layer, const Photon<T>& at,
                               const Index<T>& line, geometry::Route route) {
  using std::abs;
  using std::sqrt;
  const bool mirrored = route == geometry::Route::mirrored;
  const T telescope_depth = geometry::depth_of(telescope.position);
  const Vec3<T> target{telescope.position.x, telescope.position.y,
                       mirrored ? telescope_depth : telescope.position.z};
  const Vec3<T> way_there = target - at.position;
  const T squared = dot(way_there, way_there);
  const Mask<T> apart = squared > T(0);
  const T distance = sqrt(select(apart, squared, T(1)));

  Connection<T> way;
  way.direction = (T(1) / distance) * way_there;
  const Vec3<T> arriving{way.direction.x, way.direction.y,
                         mirrored ? -way.direction.z : way.direction.z};
  const T cos_off_axis = -dot(arriving, telescope.axis);
  const Mask<T> in_front = apart & (cos_off_axis > T(0));
  const T safe_cos = select(in_front, cos_off_axis, T(1));
  const T tan_off_axis = length(cross(arriving, telescope.axis)) / safe_cos;
  const T overlap = telescope.overlap(T(1) / (distance * safe_cos), tan_off_axis);
  const Mask<T> seen = in_front & (overlap > T(0));
  if (!any(seen)) return way;

  const T steep = abs(way.direction.z);
  const auto from = geometry::level_of(sea, at);
  const auto to = sea.level(telescope_layer, telescope_depth);
  const geometry::Ray<T> ray{at.position, way.direction};
  const auto there = mirrored ? geometry::by_surface(line, from, to, distance,
                                                     geometry::Slant<T>::of_cosine(steep), ray)
                              : geometry::Segment<T>{line, from, to, distance, ray};
  way.optical_depth = geometry::optical_depths(sea, there).all;
  way.in_water = there;
  way.path = path_within(sea, telescope, at.position, there, {});
  const T reflected = mirrored ? surface::flat_surface<T>(sea, line).reflectance(steep) : T(1);
  way.acceptance =
      select(seen, lens_solid_angle(telescope, distance, safe_cos) * overlap * reflected, T(0));
  return way;
}

/// By one of the routes to the region where the telescope stands. `may_be_seen`: whether may_see().
template <class T>
Connection<T> connect(const geometry::Slabs& sea, const instrument::Telescope<T>& telescope,
                      const geometry::Region<T>& region, const Photon<T>& at, const Index<T>& line,
                      geometry::Route route, const Mask<T>& may_be_seen) {
  if (!region.outside) return connect_in_water(sea, telescope, region.layer, at, line, route);
  auto way = connect_through_surface(sea, telescope, at, line, may_be_seen);
  if (region.column.exists()) [[unlikely]] {
    const auto& column = region.column;
    way.optical_depth = way.optical_depth + gather<T>(column.optical_depth, line) * way.secant_air;
    way.path = way.path + gather<T>(column.delay, line) * way.secant_air;
  }
  return way;
}

}  // namespace photic::transport
