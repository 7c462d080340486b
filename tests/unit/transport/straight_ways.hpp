// Straight lines through the layers: their ends, and optical depths added up layer by layer.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "support/random.hpp"

namespace photic::transport {

/// Integral of a coefficient [line][layer] along the straight way from a to b.
inline double integral_between(const medium::Medium& sea, const std::vector<double>& coefficient,
                               std::int32_t line, const Vec3<double>& a, const Vec3<double>& b) {
  const auto layers = static_cast<std::size_t>(sea.layers());
  const double* c = coefficient.data() + static_cast<std::size_t>(line) * layers;
  const double distance = length(b - a);
  const double upper = std::min(-a.z, -b.z);
  const double lower = std::max(-a.z, -b.z);
  if (lower - upper < 1e-12) return c[sea.layer_at(upper)] * distance;
  double sum = 0;
  for (std::size_t k = 0; k < layers; ++k) {
    sum += c[k] * std::max(0.0, std::min(lower, sea.top[k + 1]) - std::max(upper, sea.top[k]));
  }
  return sum * distance / (lower - upper);
}

inline double optical_depth_between(const medium::Medium& sea, std::int32_t line,
                                    const Vec3<double>& a, const Vec3<double>& b) {
  return integral_between(sea, sea.c, line, a, b);
}

/// Of a straight way in a medium, or in the air upside down.
inline double group_path_between(const medium::Medium& sea, std::int32_t line,
                                 const Vec3<double>& a, const Vec3<double>& b) {
  const double path = length(b - a) * sea.line[static_cast<std::size_t>(line)].group_index;
  return sea.delay.empty() ? path : path + integral_between(sea, sea.delay, line, a, b);
}

/// What free paths are drawn from: scattering alone, or a fifth of c where there is less.
inline std::vector<double> walk_coefficients(const medium::Medium& sea) {
  std::vector<double> out;
  for (std::size_t i = 0; i < sea.c.size(); ++i)
    out.push_back(sea.c[i] * std::max(0.2, sea.albedo[i]));
  return out;
}

inline Vec3<double> random_place(test::Random& random) {
  return {random.between(-10, 10), random.between(-10, 10), -random.between(0.01, 30)};
}

}  // namespace photic::transport
