// The requests of a scene that the bidirectional estimator cannot meet.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace photic::scene {

/// The parts that a scene's waves, or its columns, ask for and the bidirectional estimator lacks,
/// if there are any.
std::optional<std::string> bidirectional_lacks(const Scene& scene);

}  // namespace photic::scene
