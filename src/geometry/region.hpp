// The regions that interfaces cut space into, and how light gets from the water to one of them.
#pragma once

#include <span>

#include "core/elementary.hpp"
#include "core/lanes.hpp"

namespace photic::geometry {

/// Where something stands: in the air above the surface, or in a layer of the water.
template <class T>
struct Region {
  bool in_air = false;
  Index<T> layer{};  ///< of what stands in the water
  ShortTable air{};  ///< of what stands in the air, the optical depth straight down to the sea,
                     ///< [line]; without numbers where the air is clear

  /// The share of a line's light that gets between there and the sea without meeting the air.
  /// `cosine`: of its direction to the vertical, above 0.
  [[nodiscard]] T through_air(const Index<T>& line, const T& cosine) const {
    if (air.size == 0) [[likely]]
      return T(1);
    return exp_minus(gather<T>(air, line) / cosine);
  }
};

/// A sequence of interfaces that light may take from the water to where an instrument stands.
enum class Route {
  direct,   ///< straight, through the surface if the instrument stands in the air
  mirrored  ///< within the water, reflected by the surface from below
};

inline std::span<const Route> routes_to(bool in_air) {
  static constexpr Route routes[] = {Route::direct, Route::mirrored};
  return {routes, in_air ? std::size_t{1} : std::size_t{2}};
}

}  // namespace photic::geometry
