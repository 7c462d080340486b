// The laser's light: from the disc into the water.
#pragma once

#include <cmath>

#include "core/turn.hpp"
#include "instrument/laser.hpp"
#include "medium/medium.hpp"
#include "optics/fresnel.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// A photon from two uniforms, in the plane across the laser's axis where its light starts. Its
/// path is what it is longer than the axis' own.
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
    photon.position = laser.start + (laser.radius * sqrt(u_polar)) * outward;
    return photon;
  }
  const T x = u_polar * laser.one_minus_cos_divergence;
  const T off_axis = sqrt(x * (T(2) - x));
  const T secant = T(1) / (T(1) - x);
  const T to_start = laser.vertex_distance + laser.ahead;
  photon.direction = (T(1) - x) * laser.axis + off_axis * outward;
  photon.position = laser.start + (to_start * (off_axis * secant)) * outward;
  photon.path = laser.ahead * (x * secant);
  return photon;
}

/// Takes photons from the air through the flat surface into the water: Snell's law, and the weight
/// times the Fresnel transmittance. Tells which photons get there; the others fly away and are left
/// as they are.
template <class T>
Mask<T> enter_water(const medium::MediumView& sea, Photon<T>& photon) {
  using std::sqrt;
  const Mask<T> downward = photon.direction.z < T(0);
  const T cos_air = select(downward, -photon.direction.z, T(1));
  const T distance = photon.position.z / cos_air;
  const T n = gather<T>(sea.index, photon.line);
  const auto through = optics::refract(T(1), n, cos_air);
  const Vec3<T> at_surface = photon.position + distance * photon.direction;
  const T inverse_n = gather<T>(sea.inverse_index, photon.line);
  const Vec3<T> refracted{photon.direction.x * inverse_n, photon.direction.y * inverse_n,
                          -through.cos_transmitted};
  photon.position = select(downward, Vec3<T>{at_surface.x, at_surface.y, T(0)}, photon.position);
  photon.direction = select(downward, refracted, photon.direction);
  photon.path = photon.path + select(downward, distance, T(0));
  photon.weight = photon.weight * select(downward, T(1) - through.reflectance, T(1));
  return downward;
}

}  // namespace photic::transport
