// Directions in which light must leave a point in the water to reach a telescope: what directed
// sampling aims at, in the field of view or not, for light that first turns towards a telescope and
// then enters its view is what a plain walk finds too rarely.
#pragma once

#include "geometry/sightline.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "transport/facets_in_line.hpp"

namespace photic::transport {

template <class T>
struct Aim {
  Vec3<T> direction;   ///< a unit vector
  Mask<T> in_front{};  ///< true if that is in front of the lens; else nothing is scored
};

/// To a point of the lens by a route to where the telescope stands. The refracted direction is
/// known to a few per cent of its angle where the telescope cannot see the point: `may_be_seen`,
/// see may_see().
template <class T>
Aim<T> aim(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
           const geometry::Region<T>& region, const Vec3<T>& from, const Index<T>& line,
           const Vec3<T>& to, geometry::Route route, const Mask<T>& may_be_seen) {
  const auto way = geometry::sightline(sea, from, line, to, region, route, may_be_seen);
  return {way.direction, -dot(way.arriving, telescope.axis) > T(0)};
}

/// To a point of the lens by the point of a rough surface that the local estimate would draw by the
/// same numbers `u`.
template <class T>
Aim<T> aim_by_waves(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                    const geometry::Region<T>& region, const Vec3<T>& from, const Index<T>& line,
                    const instrument::PlanePoint<T>& lens, const SurfacePointUniforms<T>& u) {
  const auto level = near_level(sea, from, line, in_space(telescope, lens), region, Mask<T>(true));
  const T n1 = region.outside ? gather<T>(sea.index, line) : T(1);
  const auto point = !sea.surface.leads_anywhere
                         ? draw_point_in_line(sea.waves, telescope, from, lens, level, n1, u).point
                         : draw_point(sea.waves, telescope, from, lens, level, u);
  const Vec3<T> way = point.at - from;
  const auto onward = from_surface(telescope, lens, point.at);
  const Mask<T> in_front =
      point.exists & (from.z < T(0)) & (-dot(onward.direction, telescope.axis) > T(0));
  // None has a direction from where a point does not exist, and up is as good as any.
  const Vec3<T> up{T(0), T(0), T(1)};
  return {select(in_front, (T(1) / length(way)) * way, up), in_front};
}

}  // namespace photic::transport
