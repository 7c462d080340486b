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

  /// b_b / b.
  [[nodiscard]] double backscatter_fraction() const { return 1 - below(1); }

  [[nodiscard]] PhaseShape shape() const;

  /// The function of a backscatter fraction, on a line through the plane of index and slope that
  /// goes with what is measured in the sea: n = 1.01 + 0.1542 (slope - 3), Mobley et al. 2002
  /// [verified]. Throws InputError outside the fractions below.
  static FournierForand of_backscatter(double fraction);
  static constexpr double lowest_backscatter = 2e-4, highest_backscatter = 0.45;

 private:
  double v_;            ///< (3 - slope) / 2
  double delta_per_x_;  ///< delta = 4 / (3 (n-1)^2) sin^2(angle/2), over x
  double tail_;         ///< the factor of 3 cos^2 - 1
};

inline PhaseShape fournier_forand(double refractive_index, double slope) {
  return FournierForand(refractive_index, slope).shape();
}

}  // namespace photic::optics
