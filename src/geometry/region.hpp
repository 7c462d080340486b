// The regions that interfaces cut space into, and how light gets from the water to one of them.
#pragma once

#include <cstdint>
#include <span>

#include "core/elementary.hpp"
#include "core/lanes.hpp"

namespace photic::geometry {

/// The column of air, or water, straight between the sea surface and an instrument on its other
/// side. Without numbers where that is clear.
struct OutsideColumn {
  ShortTable optical_depth;  ///< [line]
  ShortTable delay;          ///< by how much the group path is longer than in a vacuum [m], [line]
  std::int32_t excess = -1;  ///< row of how much deeper it is in environments, of line 0; -1: none
  /// 1 over its length, of water: points of a lens are nearer and farther than its centre. In air
  /// that does not count. 0: it counts as equally long for all [1/m].
  double per_metre = 0;

  [[nodiscard]] bool exists() const { return optical_depth.size > 0; }
};

/// The region where something stands: inside the medium whose light is followed, in one of its
/// layers, or outside, beyond the sea surface.
template <class T>
struct Region {
  bool outside = false;
  Index<T> layer{};        ///< of what stands inside
  OutsideColumn column{};  ///< to what stands outside

  /// By how much the column to a point so far from the surface is longer than to the instrument: as
  /// if all of it were stretched.
  [[nodiscard]] T stretch(const T& distance) const {
    return column.per_metre == 0 ? T(1) : distance * T(column.per_metre);
  }
  /// The share of a line's light that gets between there and the surface without a collision.
  /// `cosine`: of its direction to the vertical, above 0.
  [[nodiscard]] T through_column(const Index<T>& line, const T& cosine,
                                 const T& stretch = T(1)) const {
    if (!column.exists()) [[likely]]
      return T(1);
    return exp_minus(gather<T>(column.optical_depth, line) * stretch / cosine);
  }
  /// By how much that way is longer than in a vacuum, as group path [m].
  [[nodiscard]] T delay(const Index<T>& line, const T& cosine, const T& stretch = T(1)) const {
    if (!column.exists()) [[likely]]
      return T(0);
    return gather<T>(column.delay, line) * stretch / cosine;
  }
};

/// A sequence of interfaces that light may take from the medium to where an instrument stands.
enum class Route {
  direct,   ///< straight, through the surface if the instrument stands outside
  mirrored  ///< within the medium, reflected by the surface
};

inline std::span<const Route> routes_to(bool outside) {
  static constexpr Route routes[] = {Route::direct, Route::mirrored};
  return {routes, outside ? std::size_t{1} : std::size_t{2}};
}

/// Returns whether a route to where an instrument stands meets the surface.
template <class T>
bool meets_surface(const Region<T>& region, Route route) {
  return region.outside || route == Route::mirrored;
}

}  // namespace photic::geometry
