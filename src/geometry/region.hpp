// The regions that interfaces cut space into, and how light gets from the water to one of them.
#pragma once

#include <span>

#include "core/lanes.hpp"

namespace photic::geometry {

/// Where something stands: in the air above the surface, or in a layer of the water.
template <class T>
struct Region {
  bool in_air = false;
  Index<T> layer{};  ///< of what stands in the water
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
