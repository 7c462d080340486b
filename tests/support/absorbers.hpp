// Two layers of water that absorb and do not scatter, and integrals over what light they leave.
#pragma once

#include <fmt/format.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "support/lit_scenes.hpp"

namespace photic::test {

/// Of smooth integrands.
template <class F>
double integral(F f, double from, double to) {
  return to > from ? boost::math::quadrature::gauss<double, 30>::integrate(f, from, to) : 0;
}

/// Fresnel's reflectance for natural light from index 1 to n, and the cosine beyond.
inline std::pair<double, double> refracted(double cosine, double n) {
  const double beyond = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  const double s = (cosine - n * beyond) / (cosine + n * beyond);
  const double p = (n * cosine - beyond) / (n * cosine + beyond);
  return {(s * s + p * p) / 2, beyond};
}

/// Down to the edge between them, and to the bed.
struct TwoAbsorbers {
  static constexpr double upper_a = 1.0, lower_a = 0.5, edge_m = 1.0, bed_m = 3.0;

  static std::string scene(double refractive_index) {
    return fmt::format("[sea]\nrefractive_index = {}\n", refractive_index) +
           layer_to(edge_m, upper_a, 0) + layer_to(bed_m, lower_a, 0);
  }
  static double optical_depth(double depth) {
    return depth < edge_m ? upper_a * depth : upper_a * edge_m + lower_a * (depth - edge_m);
  }
  /// Of a straight way between two depths that is `longer` than what is between these.
  static double between(double one, double other, double longer) {
    return std::abs(optical_depth(one) - optical_depth(other)) * longer;
  }
};

}  // namespace photic::test
