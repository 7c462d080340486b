// The share of the attenuation that free paths are drawn from. For connected walks: the default of
// a scene, the values that "auto" chooses from, those that `bench` compares.
#pragma once

#include <vector>

#include "geometry/free_paths.hpp"
#include "medium/medium.hpp"
#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Free paths of emitted light that is to be connected are drawn from so much less of its
/// attenuation than those of the laser's, unless it is scattered more: it is absorbed before a walk
/// from a telescope gets to where deep echoes come from (docs/decisions/0014).
inline constexpr double emitted_walk_share = 0.6;

/// b / c of the laser's light in the layer where it is largest.
double highest_albedo(const medium::Medium& medium);

/// The least walk attenuation. Where c' is smaller than b, weights grow at every vertex: below this
/// value their tail is longer than a run.
double min_walk_attenuation(double highest_albedo);

/// The values worth a try, ascending; at least one.
std::vector<double> walk_attenuations(double highest_albedo);

/// The value of a scene that names none: 0.6, or, where water scatters so much that this is too
/// little, c' = b up to 0.9.
double usual_walk_attenuation(double highest_albedo);

/// The value that the walks of a simulation take in a medium.
double walk_attenuation_in(const medium::Medium& medium, const scene::Simulation& simulation);

/// Remarks on a scene's own value if it is below the least for the laser's light.
void check_walk_attenuation(const scene::Scene& scene, double highest_albedo,
                            scene::Findings& findings);

/// The share of c that free paths of a simulation are drawn from, [line][layer].
std::vector<double> shares_of_free_paths(const medium::Medium& medium,
                                         const scene::Simulation& simulation);
inline geometry::FreePaths free_paths(const medium::Medium& medium,
                                      const scene::Simulation& simulation) {
  return {medium, shares_of_free_paths(medium, simulation)};
}

}  // namespace photic::estimator
