// A laser as a disc whose light leaves in a cone: the cone's vertex is a fictitious point behind
// the disc, directions are uniform in solid angle inside the cone (paper, section "The model"), or
// as a Gaussian has them (docs/theory.md, eq. 108).
// Other sources are as lasers: a beam has no divergence, a point no disc besides, and all light of
// a cone leaves from its vertex.
#pragma once

#include <cmath>

#include "core/vec3.hpp"
#include "geometry/axis.hpp"
#include "instrument/beam_profile.hpp"
#include "scene/scene.hpp"

namespace photic::instrument {

template <class T>
struct Laser {
  Vec3<T> start;                 ///< on the axis, way_ahead() of the disc [m]
  T ahead{};                     ///< so far [m]
  T to_sea{};                    ///< from there by the axis, of a laser above air that is upside
                                 ///< down: geometry::ahead_of_air() [m]
  Vec3<T> axis;                  ///< unit vector, where the light goes
  T radius{};                    ///< of all light on the disc [m]
  T vertex_distance{};           ///< from the fictitious vertex to the disc [m]; 0 if collimated
  T vertex_detour{};             ///< by how much that is farther from the origin than from the
                                 ///< start [m]
  T one_minus_cos_divergence{};  ///< 1 - cos of the half angle that holds all rays
  BeamProfile<T> profile;
  bool collimated = false;   ///< no divergence: parallel rays from the whole disc
  bool from_vertex = false;  ///< no disc: all rays from one place, into any cone
  bool inside = false;       ///< it stands in the medium

  /// From a uniform, 1 - cos of a ray's angle to the axis.
  [[nodiscard]] T draw_direction(const T& u) const {
    return profile.draw(u) * one_minus_cos_divergence;
  }
  /// From a uniform, the distance of a parallel ray from the axis [m].
  [[nodiscard]] T draw_on_disc(const T& u) const {
    using std::sqrt;
    return radius * sqrt(profile.draw(u));
  }
  /// Returns whether its light has such directions. `x`: 1 - cos of the angle to the axis.
  [[nodiscard]] Mask<T> emits(const T& x) const { return x < one_minus_cos_divergence; }
  /// 1 - cos of the half angle of the cone that its light would fill evenly with the density that
  /// it has there: that is 1 / (2 pi even_within(x)) per steradian.
  [[nodiscard]] T even_within(const T& x) const {
    if (profile.is_even) return one_minus_cos_divergence;
    return one_minus_cos_divergence * profile.per_density(x / one_minus_cos_divergence);
  }
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

/// Of a Gaussian, light falls to 1/e2 within the half divergence or, if it is parallel, within the
/// disc's radius.
template <class T>
BeamProfile<T> make_profile(const scene::Source& s) {
  if (s.profile == scene::SourceProfile::disc) return {};
  const auto parts = [](double angle) { return std::pow(std::sin(angle / 2), 2); };
  const double half_divergence = s.half_divergence();
  const double over = half_divergence > 0
                          ? parts(s.half_divergence_of_all()) / parts(half_divergence)
                          : std::pow(s.radius_of_all() / (s.diameter_m / 2), 2);
  return {false, T(2 * over), T(std::exp(-2 * over))};
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
  laser.radius = T(s.radius_of_all());
  laser.collimated = half_divergence == 0;
  laser.from_vertex = s.fills_cone();
  const bool has_disc = !laser.collimated && !laser.from_vertex;
  const double to_disc = has_disc ? s.diameter_m / 2 / std::tan(half_divergence) : 0.0;
  laser.vertex_distance = T(to_disc);
  laser.vertex_detour = T(length(s.position_m - to_disc * axis) - (to_disc + ahead + to_sea));
  const double half_sine = std::sin(s.half_divergence_of_all() / 2);
  laser.one_minus_cos_divergence = T(2 * half_sine * half_sine);
  laser.profile = make_profile<T>(s);
  laser.inside = geometry::stands_in_water(s.position_m);
  return laser;
}
template <class T>
Laser<T> make_laser(const scene::Source& s) {
  return make_laser<T>(s, geometry::ahead_of(s.position_m, normalised(s.direction)));
}

}  // namespace photic::instrument
