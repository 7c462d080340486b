// The rough sea surface as walks see it.
#pragma once

#include "core/lanes.hpp"
#include "optics/sea_slopes.hpp"

namespace photic::medium {

/// The slopes of facets along the wind and across it (optics/sea_slopes.hpp), and whitecaps: of a
/// surface that scatters light.
struct WavesView {
  bool one_dimensional = false;       ///< all facets are level across the wind
  bool conserving = false;            ///< the weight at facets is over its mean
  double upwind_x = 1, upwind_y = 0;  ///< towards where the wind comes from, a unit vector
  double upwind_deviation = 0, crosswind_deviation = 0;  ///< of slopes
  optics::GramCharlier series;
  double per_norm = 1;
  double whitecap_fraction = 0;
  ShortTable whitecap_reflectance;  ///< from above, [line]
};

/// The ways by which light goes on at a film of oil: through it, or back where it came from.
inline constexpr std::int32_t through_film = 0, back_into_water = 1, back_into_air = 2;
inline constexpr std::int32_t ways_at_film = 3;

/// A film of oil on all of the sea: of a surface that absorbs light.
struct FilmView {
  std::int32_t band = -1;        ///< that it emits in; none if no channel counts its light
  ShortTable index;              ///< against what lies outside, [line]
  ShortTable optical_thickness;  ///< straight through it, [line]
  ShortTable emission;  ///< photons in the line per photon of the laser's that it absorbs, over the
                        ///< share of spectral_bins that may emit them, [line]
};

/// Rows of what environments have of a surface: of two surfaces, of which the medium's changes have
/// the difference, and behind them what that counts.
enum class SurfaceRow : std::int32_t {
  per_upwind,     ///< 1 over the deviation of slopes; 0: all are level that way
  per_crosswind,  ///< the same
  c21,            ///< of the Gram-Charlier series
  c03,            ///< the same; its other coefficients are the medium's
  of_facets,      ///< factor before the density of slopes, over that in the medium
  facets,         ///< share of the surface free of whitecaps, over the same
  whitecaps,      ///< fraction of whitecaps, over the same; 0 if there are none
  rows            ///< their number
};
inline constexpr std::int32_t surface_rows = 2 * static_cast<std::int32_t>(SurfaceRow::rows) + 1;

}  // namespace photic::medium
