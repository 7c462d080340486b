// Optical depths along straight lines through the layers, added up layer by layer.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec3.hpp"
#include "medium/medium.hpp"

namespace photic::transport {

inline double optical_depth_between(const medium::Medium& sea, std::int32_t line, const Vec3<double>& a,
                                    const Vec3<double>& b) {
  const auto layers = static_cast<std::size_t>(sea.layers());
  const double* c = sea.c.data() + static_cast<std::size_t>(line) * layers;
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

}  // namespace photic::transport
