// The effect of other airs, those of environments, on the weights of paths that were drawn in the
// scene's (docs/theory.md, "Environments"): as medium/environments.hpp has it of the water.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "medium/air.hpp"
#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The air of an environment, or of the two steps of a derivative: what changes, in units of
/// `scale`.
struct OtherAir {
  std::string name;  ///< as users know it
  Air from, to;
  double scale = 1;
};

/// The airs of all environments of a scene with an [atmosphere], and then of all derivatives.
/// Throws InputError where light is scattered in an environment where it never is in the scene.
std::vector<OtherAir> other_airs(const scene::Scene& scene, const optics::Library& library,
                                 const std::vector<Line>& lines, const std::stop_token& stop = {});

/// The excess depth of the air in each of them, straight up from the sea to heights [m],
/// [environment][height][line]; 0 for heights below it.
std::vector<double> excess_depths(const std::vector<OtherAir>& airs,
                                  const std::vector<double>& height_m);

/// Adds their tables to the air as a medium, which is not finished yet. The surface is in each as
/// it is for the sea.
void add_other_airs(const Air& air, const std::vector<OtherAir>& airs, const Medium& sea,
                    Medium& medium, const std::stop_token& stop);

}  // namespace photic::medium
