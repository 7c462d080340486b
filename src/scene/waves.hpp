// What scenes with waves cannot have.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace photic::scene {

/// What the bidirectional estimator has not yet that a scene's waves ask for, if there is anything.
std::optional<std::string> bidirectional_lacks(const Scene& scene);

}  // namespace photic::scene
