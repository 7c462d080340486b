// What scenes with waves, or a film of oil, cannot have.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace photic::scene {

/// What the bidirectional estimator has not yet that a scene asks for, if there is anything.
std::optional<std::string> bidirectional_lacks(const Scene& scene);

/// Whether a channel may count light that a film of oil emits: all of it, or through a filter.
bool counts_light_of_oil(const Scene& scene);
inline const std::string light_of_oil = "light of a film of oil in this version";

}  // namespace photic::scene
