// Straight flights of light as tallies take them, in double whatever the engine: one photon's.
#pragma once

#include <cmath>
#include <cstddef>

#include "core/vec3.hpp"

namespace photic::estimator {

/// A flight on one side of the sea surface. Distances are from the surface: depths in the water,
/// heights in the air.
struct Flight {
  Vec3<double> start;       ///< relative to the world's origin [m]
  Vec3<double> direction;   ///< a unit vector
  double from = 0, to = 0;  ///< distances at its ends
  double length = 0;        ///< [m]
  double weight = 0;        ///< at its start
  std::size_t layer = 0;    ///< where it starts, among those of its column

  [[nodiscard]] double near() const { return from < to ? from : to; }
  [[nodiscard]] double far() const { return from < to ? to : from; }
  /// Returns whether it leads away from the surface.
  [[nodiscard]] bool leads_away() const { return to > from; }
  /// The length up to a distance within it; of a level flight 0.
  [[nodiscard]] double length_to(double distance) const {
    return to == from ? 0 : length * std::abs(distance - from) / (far() - near());
  }
};

}  // namespace photic::estimator
