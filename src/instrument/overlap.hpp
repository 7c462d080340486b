// The share of a point's blurred image that falls on the detector.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic::instrument {

/// Area of the part of the unit circle beyond a chord at the signed distance c from its centre:
/// acos c - c sqrt(1 - c^2), of all or nothing where |c| > 1. It is z^(3/2), z = (1 - |c|) / 2,
/// times a smooth function of z, here the polynomial that agrees with it in the 11 Chebyshev points
/// of 0
/// <= z <= 1/2: within 2e-11, without the branches of libm's acos.
template <class T>
T circle_segment(const T& c) {
  using std::abs;
  using std::copysign;
  using std::sqrt;
  const T y = T(1) - abs(c);
  const T z = T(0.25) * (y + abs(y));
  const T z2 = z * z;
  const T z4 = z2 * z2;
  const T smooth =
      T(5.3333333333144415) - z * T(1.5999999908713376) -
      z2 * (T(0.2857150095583558) + z * T(0.111088899115248)) -
      z4 *
          (T(0.05716456997533666) + z * T(0.030538626061875594) +
           z2 * (T(0.03906948746394667) - z * T(0.04438307498947525)) +
           z4 * (T(0.13851365559287485) - z * T(0.14903803779579894) + z2 * T(0.0969934875531382)));
  return T(pi / 2) - copysign(T(pi / 2) - z * sqrt(z) * smooth, c);
}

/// Area common to two circles of radii r1 and r2 whose centres are d apart [m^2]; all >= 0. Source:
/// elementary geometry (two circular segments), e.g. Harms, Lahmann & Weitkamp, Appl. Opt. 17, 1131
/// (1978).
template <class T>
T circles_overlap(const T& r1, const T& r2, const T& d) {
  const T tiny = T(1e-30);  // [m^2], against 0 / 0
  const T difference = (r1 - r2) * (r1 + r2);
  const T c1 = (d * d + difference) / (T(2) * d * r1 + tiny);
  const T c2 = (d * d - difference) / (T(2) * d * r2 + tiny);
  return r1 * r1 * circle_segment(c1) + r2 * r2 * circle_segment(c2);
}

}  // namespace photic::instrument
