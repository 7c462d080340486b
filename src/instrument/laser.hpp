// A laser as a disc whose light leaves in a cone: the cone's vertex is a fictitious point behind
// the disc, directions are uniform in solid angle inside the cone (paper, section "The model").
// Other sources are as lasers: a beam has no divergence, a point no disc besides, and all light of
// a cone leaves from its vertex.
#pragma once

#include <cmath>

#include "core/vec3.hpp"
#include "geometry/axis.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

template <class T>
struct Laser {
  Vec3<T> start;                 ///< on the axis, way_ahead() of the disc [m]
  T ahead{};                     ///< so far [m]
  T to_sea{};                    ///< from there by the axis, of a laser above air that is upside
                                 ///< down: geometry::ahead_of_air() [m]
  Vec3<T> axis;                  ///< unit vector, where the light goes
  T radius{};                    ///< of the disc [m]
  T vertex_distance{};           ///< from the fictitious vertex to the disc [m]; 0 if collimated
  T vertex_detour{};             ///< by how much that is farther from the origin than from the
                                 ///< start [m]
  T one_minus_cos_divergence{};  ///< 1 - cos(half divergence)
  bool collimated = false;       ///< no divergence: parallel rays from the whole disc
  bool from_vertex = false;      ///< no disc: all rays from one place, into any cone
  bool inside = false;           ///< it stands in the medium
};

/// The fictitious vertex that a laser's rays come from.
template <class T>
Vec3<T> fictitious_vertex(const Laser<T>& laser) {
  return laser.start - (laser.vertex_distance + laser.ahead) * laser.axis;
}

/// Returns whether other rays can be led to its rays' fictitious vertex.
template <class T>
bool can_be_met(const Laser<T>& laser) {
  return !laser.collimated && (laser.inside || any(fictitious_vertex(laser).z > T(0)));
}

/// The excess of the way in the air from a laser's disc to a place, along the ray from the
/// fictitious vertex, over the axis from the disc to the origin [m]. `distance`: from that vertex;
/// `x`: 1 - cos of the ray's angle to the axis.
template <class T>
T longer_from_disc(const Laser<T>& laser, const Vec3<T>& place, const T& distance, const T& x) {
  const Vec3<T> vertex = fictitious_vertex(laser);
  return longer_by(vertex, -place, length(vertex) + distance) + laser.vertex_detour -
         x * (laser.vertex_distance / (T(1) - x));
}

template <class T>
Laser<T> make_laser(const scene::Source& s, const geometry::Ahead& way) {
  const double half_divergence = s.half_divergence();
  Laser<T> laser;
  const Vec3<double> axis = normalised(s.direction);
  const auto [ahead, to_sea] = way;
  laser.start = vec3_cast<T>(s.position_m + ahead * axis);
  laser.ahead = T(ahead);
  laser.to_sea = T(to_sea);
  laser.axis = vec3_cast<T>(axis);
  laser.radius = T(s.diameter_m / 2);
  laser.collimated = half_divergence == 0;
  laser.from_vertex = s.fills_cone();
  const bool has_disc = !laser.collimated && !laser.from_vertex;
  const double to_disc = has_disc ? s.diameter_m / 2 / std::tan(half_divergence) : 0.0;
  laser.vertex_distance = T(to_disc);
  laser.vertex_detour = T(length(s.position_m - to_disc * axis) - (to_disc + ahead + to_sea));
  const double half_sine = std::sin(half_divergence / 2);
  laser.one_minus_cos_divergence = T(2 * half_sine * half_sine);
  laser.inside = geometry::stands_in_water(s.position_m);
  return laser;
}
template <class T>
Laser<T> make_laser(const scene::Source& s) {
  return make_laser<T>(s, geometry::ahead_of(s.position_m, normalised(s.direction)));
}

}  // namespace photic::instrument
