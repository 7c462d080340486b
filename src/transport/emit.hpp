// The light of a source as it leaves it.
#pragma once

#include <cmath>

#include "core/turn.hpp"
#include "instrument/laser.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// A photon from two uniforms, in the plane across the laser's axis where its light starts. Its
/// path is what it is longer than the axis' own. `layer`: of a laser in the water.
template <class T>
Photon<T> emit(const instrument::Laser<T>& laser, const Index<T>& layer, const T& u_polar,
               const T& u_azimuth) {
  using std::sqrt;
  const auto [cosine, sine] = cos_sin_of_turns(u_azimuth);
  Photon<T> photon;
  photon.layer = layer;
  const Vec3<T> outward = turned(laser.axis, T(1), cosine, sine);
  if (laser.collimated) {
    photon.direction = laser.axis;
    photon.position = laser.start + laser.draw_on_disc(u_polar) * outward;
    photon.path = T(0) - laser.to_sea;
    return photon;
  }
  const T x = laser.draw_direction(u_polar);
  const T off_axis = sqrt(x * (T(2) - x));
  if (laser.from_vertex) {
    photon.direction = (T(1) - x) * laser.axis + off_axis * outward;
    photon.position = laser.start;
    return photon;
  }
  const T secant = T(1) / (T(1) - x);
  const T to_start = laser.vertex_distance + laser.ahead;
  photon.direction = (T(1) - x) * laser.axis + off_axis * outward;
  photon.position = laser.start + (to_start * (off_axis * secant)) * outward;
  photon.path = laser.ahead * (x * secant) - laser.to_sea;
  return photon;
}

}  // namespace photic::transport
