// Rays traced from the water into the air by Snell's law alone, and what finite differences make of
// them.
#pragma once

#include <cmath>
#include <functional>

#include "core/vec3.hpp"

namespace photic::transport {

/// Derivative by central differences, with the error of the third derivative taken out.
inline double derivative(const std::function<double(double)>& f, double x, double step) {
  return (8 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step))) / (12 * step);
}

/// Solid angle in water of a bundle of rays from `depth` below the surface, per area across it
/// where it is `height` above; the middle ray has the angle `angle_in_air` to the vertical.
inline double solid_angle_per_area(double n, double depth, double height, double angle_in_air) {
  // Horizontal direction cosines (u, v) in water; a ray at (u, v) crosses the height `reach` times
  // (u, v) aside.
  const auto reach = [=](double u, double v) {
    const double squared = u * u + v * v;
    return depth / std::sqrt(1 - squared) + height * n / std::sqrt(1 - n * n * squared);
  };
  const double u = std::sin(angle_in_air) / n;
  constexpr double step = 1e-5;
  const double dx_du = derivative([&](double t) { return t * reach(t, 0); }, u, step);
  const double dy_dv = derivative([&](double t) { return t * reach(u, t); }, 0, step);
  const double cos_water = std::sqrt(1 - u * u);
  return 1 / (cos_water * dx_du * dy_dv *
              std::cos(angle_in_air));  // x does not change with v, nor y with u
}

}  // namespace photic::transport
