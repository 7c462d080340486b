// The cones in which the walks of a scene begin: those of free walks, or the instruments' own rays.
#pragma once

#include <string>
#include <vector>

#include "estimator/entry_cone.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// The cones of walks, with places relative to the origin.
struct WalkCones {
  EntryCone<double> laser;
  std::vector<EntryCone<double>> telescope;   ///< of nested views that of the widest alone
  double free_laser = 0, free_telescope = 0;  ///< two rays of free walks meet so often [1/m]
};

/// A line for each telescope of which a share of the walks is aimed.
std::vector<std::string> reported_aimed_walks(const scene::Scene& scene,
                                              const medium::Medium& medium);

/// `deepest`: of the water that counts [m].
WalkCones walk_cones(const scene::Scene& scene, const medium::Medium& medium, double deepest);

}  // namespace photic::estimator
