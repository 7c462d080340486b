// The water of the environments of a scene.
#pragma once

#include <string>

#include "scene/findings.hpp"
#include "scene/read.hpp"

namespace photic::scene {

/// Applies the changes of each environment to the scene's document and reads the water that comes
/// of it. What is wrong with it, and not with the scene, is told at the change that did it.
void read_environments(const Node& document, const std::string& folder, const Check& check,
                       Scene& scene, Findings& findings);

}  // namespace photic::scene
