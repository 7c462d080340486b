// Telescopes that see one inside the other: at one place behind the same lens, they differ in the
// size of their detectors alone. The wide one sees all that the narrow one sees, so that one local
// estimate serves all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace photic::estimator {

/// Numbers of telescopes, from the narrowest view to the widest; or that of a telescope alone.
using NestedViews = std::vector<std::size_t>;

/// All telescopes of a scene, each once, in the order of the first of each group.
std::vector<NestedViews> nested_views(const scene::Scene& scene);

/// A line for each group of more than one.
std::vector<std::string> reported_nested_views(const scene::Scene& scene);

}  // namespace photic::estimator
