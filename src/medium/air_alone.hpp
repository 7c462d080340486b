// Air without a sea: a medium from its top down to the ground.
#pragma once

#include <stop_token>

#include "medium/medium.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The air of a scene that has no sea, above its ground. Its depths are from the top down, and its
/// surface, the top, does nothing to light. Throws as build_air() does.
Medium build_air_alone(const scene::Scene& scene, const optics::Library& library,
                       const std::stop_token& stop);

}  // namespace photic::medium
