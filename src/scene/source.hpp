// The source of light of a scene.
#pragma once

#include <optional>

#include "core/vec3.hpp"
#include "scene/choices.hpp"

namespace photic::scene {

/// A source of light. A laser is a disc whose light leaves in a cone (paper, section "The model").
struct Source {
  SourceKind kind = SourceKind::laser;
  double wavelength_nm{};
  /// Of a disc the centre, else the place; z up, sea level 0. Of a beam as wide as the world a
  /// place above all that scatters, which means nothing.
  Vec3<double> position_m{};
  bool is_everywhere = false;        ///< a beam without a place: as wide as the world
  Vec3<double> direction{};          ///< of the light, or the axis of a cone; any length but 0
  std::optional<double> zenith_deg;  ///< a beam's, where it comes from, in place of a direction
  double azimuth_deg = 0.0;          ///< the same, from +x to +y
  double diameter_m{};               ///< laser, beam with a place; 0: a pencil
  double half_divergence_mrad{};     ///< laser
  SourceProfile profile = SourceProfile::disc;  ///< laser; else a disc's
  double half_angle_deg{};                      ///< cone
  // The strength: at most one, that of its kind.
  std::optional<double> energy_j, photons_per_pulse;  ///< laser
  std::optional<double> power_w;                      ///< cone, point, beam with a place
  std::optional<double> irradiance_w_m2;  ///< beam as wide as the world: across the beam

  /// Returns whether telescopes may be there: light leaves at a time.
  [[nodiscard]] bool is_pulsed() const { return kind == SourceKind::laser; }
  /// Returns whether light leaves one place, in directions that fill a cone, however wide.
  [[nodiscard]] bool fills_cone() const { return kind == SourceKind::cone; }
  /// The half angle of the cone that its light leaves in; of a Gaussian that of 1/e2 [rad].
  [[nodiscard]] double half_divergence() const;
  /// The half angle that holds all of its light [rad].
  [[nodiscard]] double half_divergence_of_all() const;
  /// The radius of all of its light on the disc [m].
  [[nodiscard]] double radius_of_all() const;
  friend bool operator==(const Source&, const Source&) = default;
};

}  // namespace photic::scene
