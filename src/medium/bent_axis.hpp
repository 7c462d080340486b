// Air that bends light: how the axis of an instrument comes down to the sea.
#pragma once

#include "medium/air.hpp"

namespace photic::medium {

/// The axis of an instrument in the air that looks down, bent at the edges of the air's layers by
/// Snell's law (n sin(theta) is the same in all of them), and how the instrument is seen from where
/// the axis meets the sea. Beams and views near the axis come there as if they had gone straight
/// from an instrument that stands farther away in air as it is at the sea.
struct BentAxis {
  double cosine = 1;    ///< to the vertical, at the sea
  double aside_m = 0;   ///< distance of where it meets the sea from below the instrument
  double length_m = 0;  ///< to there
  double group_path_m = 0;
  double apparent_distance_m = 0;  ///< by the solid angle that a lens fills from there
  double apparent_angle = 1;       ///< angles about the axis there, over those at the instrument
};

/// The axis of the laser's light. `cosine`: to the vertical at the instrument, above 0.
BentAxis bent_axis(const Air& air, double height_m, double cosine);

}  // namespace photic::medium
