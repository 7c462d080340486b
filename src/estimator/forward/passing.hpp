// The part of the light passing the surface that histories follow into the other medium.
#pragma once

#include <cstdint>
#include <functional>

#include "estimator/beyond.hpp"
#include "estimator/forward/forward_tracks.hpp"
#include "estimator/random_blocks.hpp"

namespace photic::estimator {

/// Takes photons that leave a world's medium, and what their new random numbers are drawn by. A
/// reference to a function: rare enough not to be compiled anew for each caller.
template <class T>
using Leave = std::function<void(ForwardTracks<T>& gone, std::int32_t copy)>;

/// Calls `leave` for the photons of a mask whose light goes on in the other medium, in a direction
/// and with a weight. Photons not scattered yet go on from a laser in the water alone: laser light
/// straight through the air sets out in the water by itself. `meeting`: of the event.
template <class T>
void pass_surface(const World<T>& world, const ForwardTracks<T>& t, const Mask<T>& mask,
                  const Vec3<T>& direction, const T& weight, std::uint32_t meeting,
                  const Leave<T>& leave) {
  if (!world.part.beyond.exists) return;
  Mask<T> passes = mask;
  if (!world.part.beyond.fresh) [[likely]]
    passes = passes & (t.photon.order > Index<T>(0));
  if (!any(passes)) return;
  passes = passes & (uniforms(t.place, passing_blocks[meeting])[0] < world.part.beyond.chance);
  if (!any(passes)) return;
  ForwardTracks<T> gone = t;
  gone.on = passes;
  gone.photon.weight = weight / world.part.beyond.chance;
  gone.photon.analog_weight = T(1);
  gone.touched = transport::touched_beyond<T>(world.slabs, gone.photon.order, gone.touched);
  go_beyond(world.part.beyond, direction, gone);
  leave(gone, static_cast<std::int32_t>(passing_blocks[meeting]));
}

}  // namespace photic::estimator
