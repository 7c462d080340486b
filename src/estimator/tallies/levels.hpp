// The levels of tallies.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace photic::estimator {

/// A level of a tally: a depth below the surface, or a height above it or above the ground.
struct TallyLevel {
  double distance = 0;  ///< [m]
  bool in_air = false;
};

/// The levels of a tally in the order of its grids: from the highest in the air down.
inline std::vector<TallyLevel> levels_of(const scene::Tally& tally) {
  std::vector<TallyLevel> out;
  for (auto height = tally.height_m.rbegin(); height != tally.height_m.rend(); ++height)
    out.push_back({*height, true});
  for (const double depth : tally.depth_m) out.push_back({depth, false});
  return out;
}

}  // namespace photic::estimator
