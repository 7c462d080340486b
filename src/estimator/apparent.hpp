// Instruments as the sea sees them through air that bends light.
#pragma once

#include <vector>

#include "geometry/axis.hpp"
#include "medium/air.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// The instruments of a scene.
struct GivenInstruments {
  scene::Source source;
  std::vector<scene::Telescope> telescope;
};

/// Puts the instruments of a scene where they seem to stand, each by its own axis, with views and
/// beams as wide as they come to the sea (medium/bent_axis.hpp).
geometry::ApparentPath put_where_they_seem(const medium::Air& air, scene::Scene& scene);

}  // namespace photic::estimator
