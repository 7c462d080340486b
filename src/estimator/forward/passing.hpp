// Light that passes the surface goes on in the other medium: from the water in the air, or from
// there in the water. Each is followed in a world of its own. That of the air is upside down, so
// that light which leaves one medium sets out downwards in the other.
#pragma once

#include <cstdint>

#include "estimator/forward/travellers.hpp"

namespace photic::estimator {

/// Blocks of an event's random numbers, from here on one for each time that a photon meets the
/// surface: whether what passes is followed.
inline constexpr std::uint32_t passing_blocks = std::uint32_t{1} << 23;

/// Calls leave(photons, copy) for those of a mask whose light goes on in the other medium, in a
/// direction and with a weight. Who has not been scattered yet is left out: what of the laser's
/// light comes straight through the air sets out in the water by itself. `meeting`: of the event;
/// `copy`: what their new random numbers are drawn by.
template <class T, class Leave>
void pass_surface(const World<T>& world, const Travellers<T>& t, const Mask<T>& mask,
                  const Vec3<T>& direction, const T& weight, std::uint32_t meeting, Leave leave) {
  if (!world.beyond.exists) return;
  Mask<T> passes = mask & (t.photon.order > Index<T>(0));
  if (!any(passes)) return;
  passes = passes & (uniforms(t.place, passing_blocks + meeting)[0] < world.beyond.chance);
  if (!any(passes)) return;
  Travellers<T> gone = t;
  gone.on = passes;
  gone.colliding = Mask<T>(false);
  transport::Photon<T>& photon = gone.photon;
  photon.position.z = T(0);
  photon.direction = {direction.x, direction.y, T(0) - direction.z};
  photon.weight = weight / world.beyond.chance;
  photon.analog_weight = T(1);
  photon.path = photon.path + world.beyond.path;
  photon.layer = Index<T>(0);
  const Index<T> air(static_cast<std::int32_t>(transport::Touched::air));
  gone.touched = select(t.touched == air, Index<T>(0), t.touched);
  leave(gone, static_cast<std::int32_t>(passing_blocks + meeting));
}

}  // namespace photic::estimator
