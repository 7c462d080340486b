// Cosine and sine of an angle given in turns.
#pragma once

#include <cmath>

#include "core/constants.hpp"
#include "core/lanes.hpp"

namespace photic {

template <class T>
struct CosSin {
  T cosine, sine;
};

/// Cosines and sines of the directions of a rose, at the cells of a turn.
struct Rose {
  CellTable cosine, sine;
};
extern const Rose rose;

/// cos(2 pi u) and sin(2 pi u) for 0 <= u <= 1, to a few units of rounding, without branches: the
/// nearest direction of a rose, and the Taylor series of what is left. (libm's sincos does
/// not come in lanes, and branches on a random angle are never predicted.)
template <class T>
CosSin<T> cos_sin_of_turns(const T& u) {
  const T turns = T(cells<T>) * u;
  const Index<T> nearest = floor_index(turns + T(0.5));
  const T y = (turns - to_real<T>(nearest)) * T(2 * pi / cells<T>);
  const T y2 = y * y;
  const T y4 = y2 * y2;
  const T s = y * (T(1) - y2 * T(1.0 / 6) + y4 * (T(1.0 / 120) - y2 * T(1.0 / 5040)));
  const T versine = y2 * (T(0.5) - y2 * T(1.0 / 24) + y4 * (T(1.0 / 720) - y2 * T(1.0 / 40320)));
  const Index<T> i = nearest & Index<T>(cells<T> - 1);
  const T c0 = gather<T>(rose.cosine, i);
  const T s0 = gather<T>(rose.sine, i);
  return {c0 - (c0 * versine + s0 * s), s0 + (c0 * s - s0 * versine)};
}

}  // namespace photic
