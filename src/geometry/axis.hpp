// The way of light along the axis of an instrument, by the flat surface: the reference of paths,
// deadlines and gates. Instruments stand at z >= 0 in the air, or below in the water.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/vec3.hpp"

namespace photic::geometry {

inline bool stands_in_water(const Vec3<double>& position) { return position.z < 0; }

/// Distance ahead of an instrument where its light's places and paths begin [m]: where its axis, a
/// unit vector, meets the sea, or for grazing light on the way there. So the long ways from space
/// are left out of places and paths, and floats keep these as precise. In the water, and where the
/// axis leads away from it: 0.
inline double way_ahead(const Vec3<double>& position, const Vec3<double>& axis) {
  if (position.z <= 0 || axis.z >= 0) return 0;
  constexpr double max_heights = 10;
  return position.z * std::min(max_heights, -1 / axis.z);
}

/// The start of an instrument's places and paths: its distance ahead on the axis, and from there to
/// the sea [m]. Paths leave out both.
struct Ahead {
  double length = 0, to_sea = 0;
};
inline Ahead ahead_of(const Vec3<double>& position, const Vec3<double>& axis) {
  return {way_ahead(position, axis), 0};
}
/// All rays of an instrument come through its disc, within a cone about its axis.
struct RaysOfDisc {
  double radius = 0;   ///< [m]
  double tangent = 0;  ///< of the cone's half angle
};
/// The same where air that is so high is upside down: for an instrument above it that looks at the
/// sea, a plane across its axis that no ray meets within the air. Paths of others leave out
/// nothing.
inline Ahead ahead_of_air(const Vec3<double>& position, const Vec3<double>& axis, double air_m,
                          const RaysOfDisc& rays) {
  const double above = -position.z - air_m;
  const double sine = std::hypot(axis.x, axis.y);
  const double length = (above - rays.radius * sine) / (axis.z + rays.tangent * sine);
  if (axis.z <= 0 || length <= 0) return {};
  return {length, (air_m + (above - length * axis.z)) / axis.z};
}

/// The cosine to the vertical that light of the given one in the air has in water of index n
/// (Snell's law).
inline double cosine_in_water(double cos_air, double n) {
  return std::sqrt(1 - (1 - cos_air * cos_air) / (n * n));
}
/// The continuation of an instrument's axis in the water.
struct AxisInWater {
  Vec3<double> entry;      ///< its beginning there: at the surface, or at the instrument
  Vec3<double> direction;  ///< a unit vector
  double in_air = 0;       ///< its length before [m]
  double index = 1;        ///< of the water against the instrument's medium
};
/// In water of index n. An axis that looks away from the sea is left as it is.
inline AxisInWater axis_in_water(const Vec3<double>& position, const Vec3<double>& axis, double n) {
  if (stands_in_water(position)) return {position, axis};
  if (!(axis.z < 0)) return {position, axis, 0, n};
  const double in_air = position.z / -axis.z;
  const Vec3<double> refracted{axis.x / n, axis.y / n, -cosine_in_water(axis.z, n)};
  return {position + in_air * axis, normalised(refracted), in_air, n};
}

/// The excess length of the axes of the laser and each telescope [m], from where they seem to stand
/// to the sea, in air that bends light; else none. Instruments are simulated where they seem to
/// stand.
struct ApparentPath {
  std::vector<double> group_path, length;

  /// The excess of the laser's axis and a telescope's together.
  [[nodiscard]] double both_paths(std::size_t telescope) const {
    return group_path.empty() ? 0 : group_path.front() + group_path[telescope + 1];
  }
  [[nodiscard]] double range(std::size_t telescope) const {
    return length.empty() ? 0 : length[telescope + 1];
  }
  [[nodiscard]] double max_of_both() const {
    double most = 0;
    for (std::size_t t = 0; t + 1 < group_path.size(); ++t) most = std::max(most, both_paths(t));
    return most;
  }
};

/// Group path along an axis that looks down: to the surface, and per metre of depth above and below
/// it, as if the air were clear. For an instrument in the water `to_surface` is negative. NaN for
/// axes that do not look down.
struct GroupPath {
  double to_surface, per_depth_in_air, per_depth_in_water;
};
inline GroupPath group_path(const Vec3<double>& position, const Vec3<double>& axis, double n,
                            double group_index) {
  if (!(axis.z < 0)) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  const bool submerged = stands_in_water(position);
  const double in_water = group_index / (submerged ? -axis.z : cosine_in_water(axis.z, n));
  const double in_air = submerged ? in_water : -1 / axis.z;
  return {position.z * in_air, in_air, in_water};
}

}  // namespace photic::geometry
