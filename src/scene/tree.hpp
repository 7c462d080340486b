// Scene -> tree of values, every default written out.
#pragma once

#include "scene/node.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

Node tree_of(Scene scene);

}  // namespace photic::scene
