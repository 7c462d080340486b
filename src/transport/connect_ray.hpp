// The straight way from a point in the water to one point of a telescope's lens: the local estimate
// of a single ray. Its mean over the lens is exact, where connect.hpp takes phase function and
// solid angle to be the same all over the lens (docs/theory.md, "The telescope").
#pragma once

#include "geometry/sightline.hpp"
#include "instrument/lens.hpp"
#include "transport/connect.hpp"

namespace photic::transport {

/// The excess of a way's part in the air over that from the lens' centre to the origin [m].
template <class T>
T longer_in_air(const instrument::Telescope<T>& telescope, const geometry::Sightline<T>& way,
                const Index<T>& line, const instrument::PlanePoint<T>& lens) {
  if (!way.to.outside) return T(0);
  return longer_way(telescope, way.crossing, lens, way.length_air) +
         way.to.delay(line, way.arriving.z, way.stretch);
}

/// The path of its part in the water, by a segment from a place there.
template <class T>
T path_in_water(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                const geometry::Sightline<T>& way, const Vec3<T>& from,
                const geometry::Segment<T>& in_water, const instrument::PlanePoint<T>& lens) {
  if (way.to.outside) return geometry::group_path(sea, in_water);
  return path_within(sea, telescope, from, in_water, lens);
}

/// A connection to one point of the lens.
template <class T>
struct RayConnection : Connection<T> {
  instrument::Sight<T> sight;
};

/// The connection as by connect(), for a lens all of which is at one of its points. `may_be_seen`:
/// the result of may_see(); nothing is seen elsewhere.
template <class T>
RayConnection<T> connect_ray(const geometry::Slabs& sea, const instrument::Telescope<T>& telescope,
                             const geometry::Region<T>& region, const Photon<T>& at,
                             const Index<T>& line, const instrument::PlanePoint<T>& lens,
                             geometry::Route route, const Mask<T>& may_be_seen) {
  const auto way = geometry::sightline(sea, at.position, line, in_space(telescope, lens), region,
                                       route, may_be_seen);
  RayConnection<T> connection;
  const auto& seen = connection.sight = sight(telescope, lens, way.arriving);
  connection.direction = way.direction;
  const Mask<T> detected = way.exists & seen.on_detector;
  if (!any(detected)) return connection;
  const auto in_water =
      geometry::along(sea, way, line, geometry::level_of(sea, at), way.length_water, at.position);
  connection.acceptance = select(
      detected, telescope.area() * seen.cos_off_axis * way.throughput / way.area_per_solid_angle,
      T(0));
  connection.optical_depth = geometry::optical_depths(sea, in_water).all;
  connection.in_water = in_water;
  connection.path = path_in_water(sea, telescope, way, at.position, in_water, lens) +
                    longer_in_air(telescope, way, line, lens);
  return connection;
}

}  // namespace photic::transport
