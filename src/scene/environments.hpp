// The water of the environments of a scene.
#pragma once

#include "scene/expand_layers.hpp"
#include "scene/findings.hpp"
#include "scene/read.hpp"

namespace photic::scene {

/// Applies the changes of each environment to the scene's document and reads the water that comes
/// of it. Its problems that are not the scene's are reported at the change that did it.
void read_environments(const Layered& layered, const Check& check, Scene& scene,
                       Findings& findings);

}  // namespace photic::scene
