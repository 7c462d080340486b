// The solid angle of a disc, exact at any distance.
#pragma once

#include <array>
#include <cmath>

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic::instrument {

/// Points of the trapezoidal rule around the disc's rim, and their cosines (the sines are not
/// needed: the integrand is even). Beyond `far_radii` radii the far formula is as good.
inline constexpr int rim_points = 32;
inline constexpr double far_radii = 100.0;

extern const std::array<double, rim_points> rim_cosines;

/// Solid angle [sr] of a disc of radius r seen from a point at height h > 0 over its plane and
/// distance p >= 0 from its axis. By Stokes' theorem it is the rim integral of (x dy - y dx) / (s
/// (s + h)), s the distance from the point to the rim: a smooth periodic integrand, so the
/// trapezoidal rule converges exponentially. Relative error below 1e-4 at more than 100 radii and
/// where the rim is farther than 0.2 r, rising nearer to the rim.
template <class T>
T disc_solid_angle(const T& r, const T& h, const T& p) {
  using std::sqrt;
  T sum(0);
  for (const double cosine : rim_cosines) {
    const T cross = r * (r + p * T(cosine));
    const T s = sqrt(h * h + p * p + r * r + T(2 * cosine) * p * r);
    sum = sum + cross / (s * (s + h));
  }
  return sum * T(2 * pi / rim_points);
}

}  // namespace photic::instrument
