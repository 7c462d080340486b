// The Fournier-Forand phase function: particles of one refractive index with a power law of sizes.
// Sources: Fournier & Jonasz 1999, Proc. SPIE 3761, 62; Mobley, Sundman & Boss 2002, Appl. Opt. 41,
// 1035, eqs. (4)-(8).
#pragma once

#include "optics/phase_table.hpp"

namespace photic::optics {

/// The index is that of the particles relative to water.
class FournierForand {
 public:
  static constexpr double lowest_index = 1.005, highest_index = 1.35;
  static constexpr double slope_above = 3.0, slope_below = 5.0;  ///< both excluded

  /// Throws InputError outside that range.
  FournierForand(double refractive_index, double slope);

  /// p [1/sr] at x = 1 - cos, 0 < x <= 2; unbounded at 0.
  [[nodiscard]] double p(double x) const;

  /// The share of the scattering at angles below that of x.
  [[nodiscard]] double below(double x) const;

  [[nodiscard]] PhaseShape shape() const;

 private:
  double v_;            ///< (3 - slope) / 2
  double delta_per_x_;  ///< delta = 4 / (3 (n-1)^2) sin^2(angle/2), over x
  double tail_;         ///< what multiplies 3 cos^2 - 1
};

inline PhaseShape fournier_forand(double refractive_index, double slope) {
  return FournierForand(refractive_index, slope).shape();
}

}  // namespace photic::optics
