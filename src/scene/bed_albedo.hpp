// The albedo of the sea bed, which reflects light alike in all directions (Lambert): how much.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace photic::scene {

/// The share, 0 to 1, that the bed reflects of light of a wavelength in nm, of what comes in at a
/// zenith angle in the water in degrees: 0 straight down, 90 along the bed. Straight lines between
/// the rows of a table. Throws InputError, without a place, where a table does not reach the
/// wavelength. The bed is that of a scene that has been read; the angle is from 0 to 90.
[[nodiscard]] double albedo_of(const Bottom& bottom, double wavelength_nm, double zenith_deg);

/// Returns whether it depends on that angle.
[[nodiscard]] bool depends_on_angle(const Bottom& bottom);

/// A zenith angle at which a bed reflects light of a wavelength and another one none of it, if
/// there is any; no bed is a black one. Throws as albedo_of.
[[nodiscard]] std::optional<double> angle_lit_by_one_alone(const std::optional<Bottom>& one,
                                                           const std::optional<Bottom>& other,
                                                           double wavelength_nm);

/// The same of the beds of an environment and a scene, column by column.
[[nodiscard]] std::optional<double> angle_lit_there_alone(const Environment& there,
                                                          const Scene& here, double wavelength_nm);

/// The albedo, or from where to where it goes, and where that comes from: "0.1, given",
/// "0.07 to 0.24, given in /…/sand.csv".
[[nodiscard]] std::string reported_albedo(const Bottom& bottom);

}  // namespace photic::scene
