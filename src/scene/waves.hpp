// Settings that scenes with waves cannot have.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace photic::scene {

/// The parts that a scene's waves ask for and the bidirectional estimator lacks so far, if there
/// are any.
std::optional<std::string> bidirectional_lacks(const Scene& scene);

}  // namespace photic::scene
