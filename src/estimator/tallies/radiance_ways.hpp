// The ways of scattered light to the levels and directions of a tally of radiance.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/model.hpp"
#include "estimator/tallies/radiance.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// The ways that begin in a model's medium: straight to levels there, reflected by the flat
/// surface, or through it. `first_cell`: of the grid, by direction and then by level.
std::vector<RadianceWay> radiance_ways(const scene::Tally& tally, const Model& model,
                                       const geometry::Slabs& slabs, std::size_t first_cell);

}  // namespace photic::estimator
