// The straight way from a point in the water to one point of a telescope's lens: the local estimate
// of a single ray. Its mean over the lens is exact, where connect.hpp takes phase function and
// solid angle to be the same all over the lens (docs/theory.md, "The telescope").
#pragma once

#include "geometry/sightline.hpp"
#include "instrument/lens.hpp"
#include "transport/connect.hpp"

namespace photic::transport {

/// As connect_through_surface (not `mirrored`) or connect_in_water give it, for a lens all of which
/// is at one of its points. `near_view`: whether may_see(); nothing is seen elsewhere.
template <class T>
Connection<T> connect_ray(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                          const Index<T>& telescope_layer, const Photon<T>& at,
                          const Index<T>& line, const instrument::PlanePoint<T>& lens,
                          bool mirrored, const Mask<T>& near_view) {
  const T depth = -at.position.z;
  const Vec3<T> to = in_space(telescope, lens);
  geometry::Sightline<T> way;
  if (telescope.submerged) {
    way = geometry::sightline_in_water(sea, at.position, line, to, mirrored);
  } else {
    way = geometry::sightline_through_surface(sea, at.position, line, to, near_view);
  }
  const auto seen = sight(telescope, lens, way.arriving);
  Connection<T> connection;
  connection.direction = way.direction;
  const Mask<T> detected = way.exists & seen.on_detector;
  if (!any(detected)) return connection;
  const auto tau = telescope.submerged
                       ? geometry::depths_in_water(sea, way, line, at.layer, depth, telescope_layer,
                                                   way.length_water, mirrored)
                       : geometry::depths_through_surface(sea, way, line, at.layer, depth);
  connection.acceptance = select(
      detected, telescope.area() * seen.cos_off_axis * way.passed / way.area_per_solid_angle, T(0));
  connection.optical_depth = tau.all;
  connection.length_water = way.length_water;
  connection.path = way.length_water * gather<T>(sea.group_index, line);
  if (!telescope.submerged)
    connection.path = connection.path + longer_way(telescope, way.crossing, lens, way.length_air);
  return connection;
}

}  // namespace photic::transport
