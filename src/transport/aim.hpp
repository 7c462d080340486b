// Directions in which light must leave a point in the water to reach a telescope: what directed
// sampling aims at, in the field of view or not, for light that first turns towards a telescope and
// then enters its view is what a plain walk finds too rarely.
#pragma once

#include "geometry/sightline.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"

namespace photic::transport {

template <class T>
struct Aim {
  Vec3<T> direction;   ///< a unit vector
  Mask<T> in_front{};  ///< whether that is in front of the lens: else nothing comes of it
};

/// To a point of the lens by a route to where the telescope stands. The refracted direction is
/// known to a few per cent of its angle where the telescope cannot see the point: `near_view`, see
/// may_see().
template <class T>
Aim<T> aim(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
           const geometry::Region<T>& region, const Vec3<T>& from, const Index<T>& line,
           const Vec3<T>& to, geometry::Route route, const Mask<T>& near_view) {
  const auto way = geometry::sightline(sea, from, line, to, region, route, near_view);
  return {way.direction, -dot(way.arriving, telescope.axis) > T(0)};
}

}  // namespace photic::transport
