// exp and log of a walk, in lanes: for the arguments a walk has, without libm's calls and branches.
#pragma once

#include <cmath>

#include "core/lanes.hpp"

namespace photic {

/// The starting points of the series below: the cells of an octave.
struct OctaveTables {
  CellTable power;    ///< 2^-x
  CellTable inverse;  ///< a cell's width over 1 + x
  CellTable log;      ///< ln(1 + x)
};
extern const OctaveTables octave_tables;
inline constexpr double ln2 = 0.69314718055994530942;

/// exp(-y) for y >= -80, to a few units of rounding; 0 beyond the smallest normal number.
template <class T>
T exp_minus(const T& y) {
  const T limit(sizeof(Element<T>) == sizeof(double) ? 700
                                                     : 80);  // above the smallest normal number
  const T within = select(y < limit, y, limit);
  const Index<T> k = floor_index(within * T(cells<T> / ln2) + T(0.5));
  // ln 2 over the number of cells in two parts, the first so short that its multiples are exact.
  constexpr bool is_double = sizeof(Element<T>) == sizeof(double);
  const T high = T(is_double ? 0x1.62e42fefp-7 : 0x1.62cp-4);
  const T low = T(is_double ? 0x1.473de6af278edp-40 : 0x1.217f7d1cf79acp-15);
  const T r = (to_real<T>(k) * high - within) + to_real<T>(k) * low;
  const T r2 = r * r;
  const T series =
      T(1) + r + r2 * (T(0.5) + r * T(1.0 / 6) + r2 * (T(1.0 / 24) + r * T(1.0 / 120)));
  const T power = gather<T>(octave_tables.power, k & Index<T>(cells<T> - 1));
  const T result = power * series * octave_edge<T>(Index<T>(0) - (k >> cell_bits<T>), 0);
  return select(y < limit, result, T(0));
}

/// -ln(u) for 0 < u <= 1.
template <class T>
T minus_log(const T& u) {
  const auto [cell, fraction] = octave_cell(u, cell_bits<T>);
  const Index<T> i = cell & Index<T>(cells<T> - 1);
  const T log_of_cell = gather<T>(octave_tables.log, i);
  const T r = fraction * gather<T>(octave_tables.inverse, i);
  const T r2 = r * r;
  const T series =
      r - r2 * (T(0.5) - r * T(1.0 / 3) +
                r2 * (T(0.25) - r * T(0.2) + r2 * (T(1.0 / 6) - r * T(1.0 / 7) + r2 * T(0.125))));
  return (T(-ln2) * to_real<T>(cell >> cell_bits<T>) - log_of_cell) - series;
}

}  // namespace photic
