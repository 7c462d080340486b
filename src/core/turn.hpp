// Cosine and sine of an angle given in turns.
#pragma once

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic {

template <class T>
struct CosSin {
  T cosine, sine;
};

/// cos(2 pi u) and sin(2 pi u) for 0 <= u <= 1, to a few units of rounding, without branches: a
/// Taylor series within an eighth of a turn about the nearest quarter. (libm's sincos does not come
/// in lanes, and was a tenth of a collision's time.)
template <class T>
CosSin<T> cos_sin_of_turns(const T& u) {
  const Index<T> quarter = floor_index(T(4) * u + T(0.5));
  const T y = (T(4) * u - to_real<T>(quarter)) * T(pi / 2);
  const T y2 = y * y;
  const T y4 = y2 * y2;
  const T y8 = y4 * y4;
  // The series up to y^15 and y^16 with coefficients 1/k!, in pairs (Estrin's scheme: short chains
  // of operations).
  const T s = y * (T(1) - y2 * T(1.0 / 6) + y4 * (T(1.0 / 120) - y2 * T(1.0 / 5040)) +
                   y8 * (T(1.0 / 362880) - y2 * T(1.0 / 39916800) +
                         y4 * (T(1.0 / 6227020800.0) - y2 * T(1.0 / 1307674368000.0))));
  const T c = T(1) - y2 * T(0.5) + y4 * (T(1.0 / 24) - y2 * T(1.0 / 720)) +
              y8 * (T(1.0 / 40320) - y2 * T(1.0 / 3628800) +
                    y4 * (T(1.0 / 479001600.0) -
                          y2 * (T(1.0 / 87178291200.0) - y2 * T(1.0 / 20922789888000.0))));
  const Index<T> q = quarter & Index<T>(3);
  const Mask<T> swapped = (q & Index<T>(1)) == Index<T>(1);
  const T c_sign = select((q == Index<T>(1)) | (q == Index<T>(2)), T(-1), T(1));
  const T s_sign = select(q >= Index<T>(2), T(-1), T(1));
  return {c_sign * select(swapped, s, c), s_sign * select(swapped, c, s)};
}

}  // namespace photic
