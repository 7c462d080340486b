// The reach of the light in a scene's gates.
#pragma once

#include <algorithm>

#include "geometry/axis.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// The extremes of a medium's lines.
struct GroupIndices {
  double least, greatest;
};
inline GroupIndices group_indices(const medium::Medium& medium) {
  const auto [least, greatest] =
      std::ranges::minmax(medium.line, {}, [](const auto& line) { return line.group_index; });
  return {least.group_index, greatest.group_index};
}

/// The greatest depth where light can turn back within the last gate, and its distance below the
/// instruments.
struct Reach {
  double deepest, range;
};
inline Reach reach_of(const scene::Scene& scene, const medium::Medium& medium, double last_path,
                      double min_group_index) {
  const auto above = [](double z) { return std::max(0.0, z); };
  const auto depth = [](double z) { return std::max(0.0, -z); };
  const double source = scene.source.position_m.z;
  Reach reach{0, 0};
  for (const auto& t : scene.telescope) {
    // The nearest point of a tilted lens: in the air, or in the water.
    const double rise = instrument::lens_rise(t);
    const bool below = geometry::stands_in_water(t.position_m);
    const double in_water = last_path - above(source) - above(t.position_m.z) + (below ? 0 : rise);
    const double higher = std::min(depth(source), depth(t.position_m.z));
    const double lower = std::max(depth(source), depth(t.position_m.z));
    const double deepest =
        std::max(lower, (in_water / min_group_index + higher + lower + (below ? rise : 0)) / 2);
    reach = {std::max(reach.deepest, deepest), std::max(reach.range, deepest - higher)};
  }
  reach.deepest = std::min(reach.deepest, medium.top.back());
  return reach;
}

}  // namespace photic::estimator
