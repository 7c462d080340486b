// Lines of `photic show` about spherical air.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace photic::estimator {

/// The planet, and where the straight continuation of the source's axis meets it; none of plane
/// air.
std::vector<std::string> reported_spherical_air(const scene::Scene& scene);

}  // namespace photic::estimator
