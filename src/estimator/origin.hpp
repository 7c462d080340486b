// The origin of places and paths in a World: near where the light gets into the water, so that
// floats resolve 0.01 ns even from space.
//
// The sea is the same everywhere, so places are relative to a point of the surface, the origin.
// Paths leave out the ways in the air between the instruments and the origin; scores add them, in
// double.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/vec3.hpp"
#include "estimator/nested_views.hpp"
#include "geometry/axis.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

/// Returns whether any instrument of a scene stands in the water.
inline bool any_in_water(const scene::Scene& scene) {
  return geometry::stands_in_water(scene.source.position_m) ||
         std::ranges::any_of(scene.telescope,
                             [](const auto& t) { return geometry::stands_in_water(t.position_m); });
}
inline double way_ahead(const scene::Source& source) {
  if (source.fills_cone()) return 0;
  return geometry::way_ahead(source.position_m, normalised(source.direction));
}
/// The point of the surface above or below the one where a laser's light starts, in a medium of
/// that kind.
inline Vec3<double> origin_of(const scene::Source& source, medium::MediumKind kind) {
  const double side = kind == medium::MediumKind::air ? -1 : 1;
  const auto in_medium = [&](const Vec3<double>& v) { return Vec3<double>{v.x, v.y, side * v.z}; };
  const auto axis = in_medium(normalised(source.direction));
  const double ahead =
      source.fills_cone() ? 0 : geometry::way_ahead(in_medium(source.position_m), axis);
  const auto start = source.position_m + ahead * axis;
  return {start.x, start.y, 0};
}
/// An instrument of a scene, its place relative to the origin.
template <class Instrument>
Instrument from_origin(Instrument instrument, const Vec3<double>& origin) {
  instrument.position_m = instrument.position_m - origin;
  return instrument;
}

/// The length that paths from the laser to a telescope, its place relative to the origin, leave out
/// [m]. `above_air`: of the telescope.
inline double path_to_origin(const geometry::Ahead& of_laser, const scene::Telescope& telescope,
                             bool above_air) {
  const Vec3<double>& lens = telescope.position_m;
  const bool relative_to_origin = above_air || !geometry::stands_in_water(lens);
  return of_laser.length + of_laser.to_sea + (relative_to_origin ? length(lens) : 0);
}

/// Until when light in the water has to be on its way to an instrument.
template <class T>
struct Deadline {
  T z{};     ///< of the instrument, if it is in the water, or of the surface [m]
  T path{};  ///< of light that gets there, or else to the surface, by the end of the last gate [m]

  /// `path`: of light that gets to the instrument then.
  static Deadline to(double z, double path) {
    return {T(std::min(0.0, z)), T(path - std::max(0.0, z))};
  }

  /// The shortest way, at the least group index, is over in time.
  Mask<T> is_met(const transport::Photon<T>& photon, const T& min_group_index) const {
    using std::abs;
    return photon.path + min_group_index * T(abs(z - photon.position.z)) < path;
  }
};

/// The deadlines of the laser's light, of which it has to meet one; `last_path`: the end of the
/// last gate [m]. Points of a tilted lens may be nearer than its centre. Nested views have the
/// same.
template <class T>
std::vector<Deadline<T>> deadlines_at_telescopes(const scene::Scene& scene, double last_path,
                                                 const geometry::Ahead& of_laser,
                                                 double greatest_index) {
  const double path = last_path - of_laser.length - of_laser.to_sea;
  std::vector<Deadline<T>> deadlines;
  std::optional<double> lowest_in_air;
  for (const NestedViews& views : nested_views(scene)) {
    const scene::Telescope& t = scene.telescope[views.back()];
    const double rise = instrument::lens_rise(t);
    const double z = t.position_m.z;
    if (z < 0) deadlines.push_back(Deadline<T>::to(z, path + greatest_index * rise));
    if (z >= 0) lowest_in_air = std::min(z - rise, lowest_in_air.value_or(z - rise));
  }
  if (lowest_in_air) deadlines.push_back(Deadline<T>::to(std::max(0.0, *lowest_in_air), path));
  return deadlines;
}

/// The deadline of a telescope's walks; `last_path`: of both walks together, at the end of the last
/// gate [m].
template <class T>
Deadline<T> deadline_at_laser(const scene::Scene& scene, double last_path,
                              const geometry::Ahead& of_laser) {
  return Deadline<T>::to(scene.source.position_m.z, last_path + of_laser.length + of_laser.to_sea);
}

}  // namespace photic::estimator
