// The share of a point's blurred image that falls on the detector.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic::instrument {

/// Area common to two circles of radii r1 and r2 whose centres are d apart [m^2]; all >= 0.
/// Source: elementary geometry (two circular segments), e.g. Harms, Lahmann & Weitkamp, Appl. Opt.
/// 17, 1131 (1978).
template <class T>
T circles_overlap(const T& r1, const T& r2, const T& d) {
  using std::abs;
  using std::acos;
  using std::sqrt;
  const T small = select(r1 < r2, r1, r2);
  const T large = select(r1 < r2, r2, r1);
  const Mask<T> apart = d >= r1 + r2;
  const Mask<T> inside = d <= large - small;
  const T simple = select(apart, T(0), T(pi) * small * small);
  const Mask<T> lens = !(apart | inside);
  if (!any(lens)) return simple;
  // The general case, made harmless where it does not hold.
  const T dd = select(lens, d, T(1));
  const T a = select(lens, small, T(1));
  const T b = select(lens, large, T(1));
  const auto clamped = [](const T& c) {
    return select(c > T(1), T(1), select(c < T(-1), T(-1), c));
  };
  const T cos_a = clamped((dd * dd + a * a - b * b) / (T(2) * dd * a));
  const T cos_b = clamped((dd * dd + b * b - a * a) / (T(2) * dd * b));
  const T area = a * a * (acos(cos_a) - cos_a * sqrt(T(1) - cos_a * cos_a)) +
                 b * b * (acos(cos_b) - cos_b * sqrt(T(1) - cos_b * cos_b));
  return select(lens, area, simple);
}

}  // namespace photic::instrument
