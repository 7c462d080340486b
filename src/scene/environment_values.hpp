// The numbers that environments set.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace photic::scene {

/// The paths that any environment sets to a number, elements of lists by their numbers, in the
/// order in which they are first set; and the values there.
struct EnvironmentValues {
  std::vector<std::string> path;
  std::vector<double> value;  ///< [environment][path]; NaN where it is no number
};

/// A value that an environment does not set is the scene's.
EnvironmentValues environment_values(const Scene& scene);

}  // namespace photic::scene
