// What the tests of the air share.
#pragma once

#include "optics/air_library.hpp"
#include "support/tables.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {

inline const AirLibrary& air_library() { return test::tables()->air(); }

/// Over all levels, of what has values [1/m] at altitudes in km.
inline double column_per_m2(const AirProfile& air, const std::vector<double>& per_m3) {
  const double from = air.z_km.front(), to = air.z_km.back();
  return 1e3 * (to - from) * mean_between(air.z_km, per_m3, from, to);
}

}  // namespace photic::optics
