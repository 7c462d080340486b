// A laser as a disc whose light leaves in a cone: the cone's vertex is a fictitious point behind
// the disc, directions are uniform in solid angle inside the cone (paper, section "The model").
#pragma once

#include <cmath>

#include "core/vec3.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

template <class T>
struct Laser {
  Vec3<T> centre;                ///< of the disc [m]
  Vec3<T> axis;                  ///< unit vector, where the light goes
  T radius{};                    ///< of the disc [m]
  T vertex_distance{};           ///< from the fictitious vertex to the disc [m]; 0 if collimated
  T one_minus_cos_divergence{};  ///< 1 - cos(half divergence)
  bool collimated = false;       ///< no divergence: parallel rays from the whole disc
  bool submerged = false;
};

template <class T>
Laser<T> make_laser(const scene::Source& s) {
  const double half_divergence = s.half_divergence_mrad * 1e-3;
  Laser<T> laser;
  laser.centre = vec3_cast<T>(s.position_m);
  laser.axis = vec3_cast<T>(normalised(s.direction));
  laser.radius = T(s.diameter_m / 2);
  laser.collimated = half_divergence == 0;
  laser.vertex_distance = T(laser.collimated ? 0.0 : s.diameter_m / 2 / std::tan(half_divergence));
  const double half_sine = std::sin(half_divergence / 2);
  laser.one_minus_cos_divergence = T(2 * half_sine * half_sine);
  laser.submerged = s.position_m.z < 0;
  return laser;
}

}  // namespace photic::instrument
