// Which share of the attenuation the free paths of walks that are to be connected are drawn from:
// what a scene gets that names none, what "auto" chooses from, what `bench` compares.
#pragma once

#include <vector>

#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// b / c of the laser's light in the layer where it is largest.
double highest_albedo(const Medium& medium);

/// Where c' is smaller than b, weights grow at every vertex: below this value the tail that this
/// makes is longer than a run.
double least_walk_attenuation(double highest_albedo);

/// Those worth a try, ascending; at least one.
std::vector<double> walk_attenuations(double highest_albedo);

/// Of a scene that names none: 0.6, or, where water scatters so much that this is too little, c' =
/// b up to 0.9.
double usual_walk_attenuation(double highest_albedo);

/// What the walks of a simulation take in a medium.
double walk_attenuation_in(const Medium& medium, const scene::Simulation& simulation);

}  // namespace photic::medium
