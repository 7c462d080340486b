// What walks see of a rough sea surface.
#pragma once

#include "core/lanes.hpp"
#include "optics/sea_slopes.hpp"

namespace photic::medium {

/// The slopes of facets along the wind and across it (optics/sea_slopes.hpp), and whitecaps.
struct WavesView {
  bool rough = false;                 ///< else the surface is flat, and nothing below counts
  bool one_dimensional = false;       ///< all facets are level across the wind
  double upwind_x = 1, upwind_y = 0;  ///< towards where the wind comes from, a unit vector
  double upwind_deviation = 0, crosswind_deviation = 0;  ///< of slopes
  optics::GramCharlier series;
  double per_norm = 1;
  double whitecap_fraction = 0;
  ShortTable whitecap_reflectance;  ///< from above, [line]
};

}  // namespace photic::medium
