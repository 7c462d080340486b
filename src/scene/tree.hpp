// Scene -> tree of values, every default written out; and back.
#pragma once

#include <optional>
#include <string>

#include "scene/findings.hpp"
#include "scene/node.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

Node tree_of(Scene scene);

/// Every value checked alone. The water of environments and the parameters of sensitivities are
/// still to be read (scene/environments.hpp, scene/sensitivities.hpp). Relative files lie in the
/// folder; without one the document may name none.
Scene scene_of(const Node& document, const std::optional<std::string>& folder, Findings& findings);

}  // namespace photic::scene
