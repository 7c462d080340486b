// Scene + optics → Medium.
#pragma once

#include "medium/medium.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The sea of a scene at the laser's wavelength and at those of the inelastic processes that a
/// channel of the scene counts. Throws InputError where there are no data for a wavelength.
Medium build_medium(const scene::Scene& scene, const optics::Library& library);

/// Whether a channel counts the light of a line.
bool counts(const scene::Channel& channel, const Line& line);

}  // namespace photic::medium
