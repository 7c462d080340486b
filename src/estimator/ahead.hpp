// The ways that paths of a scene's instruments leave out.
#pragma once

#include <cmath>

#include "core/vec3.hpp"
#include "estimator/entry_cone.hpp"
#include "geometry/axis.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// The half angle of the cone that holds all rays of an instrument [rad].
inline double half_angle_of(const scene::Source& source) { return source.half_divergence_of_all(); }
inline double half_angle_of(const scene::Telescope& telescope) { return half_view(telescope); }
/// The radius of the disc that they come through [m].
inline double radius_of(const scene::Source& source) { return source.radius_of_all(); }
inline double radius_of(const scene::Telescope& telescope) { return telescope.diameter_m / 2; }

/// Returns whether places and paths of an instrument's rays may begin ahead of it: of one that
/// fills a wide cone no plane across its axis meets them all.
inline bool begins_ahead(const scene::Source& source) { return !source.fills_cone(); }
inline bool begins_ahead(const scene::Telescope&) { return true; }

/// The distances ahead of an instrument to where its rays begin in a medium.
template <class Instrument>
geometry::Ahead ahead_in(const medium::Medium& medium, const Instrument& instrument) {
  if (!begins_ahead(instrument)) return {};
  const auto axis = normalised(instrument.direction);
  if (medium.kind == medium::MediumKind::water)
    return geometry::ahead_of(instrument.position_m, axis);
  return geometry::ahead_of_air(instrument.position_m, axis, medium.air_m,
                                {radius_of(instrument), std::tan(half_angle_of(instrument))});
}

}  // namespace photic::estimator
