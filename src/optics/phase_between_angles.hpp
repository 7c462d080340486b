// A phase function known at a few hundred angles, with a smooth curve between them.
#pragma once

#include <vector>

#include "optics/phase_table.hpp"

namespace photic::optics {

/// Angles from 0 to 180 degrees, close together where large spheres have their forward peak and
/// their glory: even steps of a coordinate.
class PhaseAngles {
 public:
  PhaseAngles();

  [[nodiscard]] const std::vector<double>& degrees() const { return degrees_; }
  /// The coordinate: 0 at the first angle, 1 at the second, …
  [[nodiscard]] double step(double degrees) const;

 private:
  double first_ = 0, per_step_ = 1;
  std::vector<double> degrees_;
};

/// A phase function through values above 0 at PhaseAngles, its integral scaled to 1: the logarithm
/// of p is a piecewise cubic of their coordinate.
struct PhaseBetweenAngles {
  PhaseShape shape;
  double integral = 1;  ///< before it was scaled
};
PhaseBetweenAngles phase_between_angles(const std::vector<double>& values_per_sr);

}  // namespace photic::optics
