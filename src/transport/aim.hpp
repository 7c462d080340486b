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

/// To a point of the lens: through the surface, or in the water directly or by way of the surface
/// seen from below (`mirrored`). The refracted direction is known to a few per cent of its angle
/// where the telescope cannot see the point: `near_view`, see may_see().
template <class T>
Aim<T> aim(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
           const Vec3<T>& from, const Index<T>& line, const Vec3<T>& to, bool mirrored,
           const Mask<T>& near_view) {
  const geometry::Sightline<T> way =
      telescope.submerged ? geometry::sightline_in_water(sea, from, line, to, mirrored)
                          : geometry::sightline_through_surface(sea, from, line, to, near_view);
  return {way.direction, -dot(way.arriving, telescope.axis) > T(0)};
}

}  // namespace photic::transport
