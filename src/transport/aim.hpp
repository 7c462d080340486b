// Directions in which light must leave a point in the water to reach a telescope: what directed
// sampling aims at, in the field of view or not, for light that first turns towards a telescope and
// then enters its view is what a plain walk finds too rarely.
#pragma once

#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "transport/connect.hpp"
#include "transport/crossing.hpp"

namespace photic::transport {

template <class T>
struct Aim {
  Vec3<T> direction;   ///< a unit vector
  Mask<T> in_front{};  ///< whether that is in front of the lens: else nothing comes of it
};

/// Through the surface to a point of the lens of a telescope in the air; the refracted direction,
/// to a few per cent of its angle where the telescope does not see the point (may_see()).
template <class T>
Aim<T> aim_through_surface(const medium::MediumView& sea, const instrument::Telescope<T>& telescope,
                           const Vec3<T>& from, const Index<T>& line, const Vec3<T>& to,
                           const Mask<T>& near_view) {
  const T n = gather<T>(sea.index, line);
  const T inverse_n = gather<T>(sea.inverse_index, line);
  const T dx = to.x - from.x;
  const T dy = to.y - from.y;
  const T aside_squared = dx * dx + dy * dy;
  const T depth = -from.z;
  auto start = crossing_start(inverse_n, depth, to.z, aside_squared);
  start.error = select(near_view, start.error, T(0));
  const T per_rise = crossing(n, depth, to.z, aside_squared, start);
  const auto ray = refracted_ray(n, inverse_n, dx, dy, aside_squared, per_rise);
  return {ray.direction, -dot(ray.arriving, telescope.axis) > T(0)};
}

/// To a point of the lens of a telescope in the water, directly or by way of the surface seen from
/// below (`mirrored`).
template <class T>
Aim<T> aim_in_water(const instrument::Telescope<T>& telescope, const Vec3<T>& from,
                    const Vec3<T>& to, bool mirrored) {
  using std::sqrt;
  const Vec3<T> there = Vec3<T>{to.x, to.y, mirrored ? -to.z : to.z} - from;
  const T squared = dot(there, there);
  const Mask<T> apart = squared > T(0);
  Aim<T> aim;
  aim.direction = (T(1) / sqrt(select(apart, squared, T(1)))) * there;
  const Vec3<T> arriving{aim.direction.x, aim.direction.y,
                         mirrored ? -aim.direction.z : aim.direction.z};
  aim.in_front = apart & (-dot(arriving, telescope.axis) > T(0));
  return aim;
}

}  // namespace photic::transport
