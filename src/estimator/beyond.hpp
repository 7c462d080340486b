// Light that passes the surface goes on in the other medium: from the water in the air, or from
// there in the water. Each is followed in a world of its own. That of the air is upside down, so
// that light that leaves one medium sets out downwards in the other.
#pragma once

#include "estimator/event.hpp"
#include "estimator/world.hpp"

namespace photic::estimator {

/// Photons that are `on` leave a world's medium in a direction, and set out in the other one.
template <class T>
void go_beyond(const Beyond<T>& beyond, const Vec3<T>& direction, Track<T>& gone) {
  gone.colliding = Mask<T>(false);
  transport::Photon<T>& photon = gone.photon;
  photon.position.z = T(0);
  photon.direction = {direction.x, direction.y, T(0) - direction.z};
  photon.path = photon.path + beyond.path;
  photon.layer = Index<T>(0);
}

}  // namespace photic::estimator
