// Scene + optics → Medium.
#pragma once

#include <stop_token>

#include "medium/lines.hpp"
#include "medium/medium.hpp"
#include "optics/aerosols.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The sea of a scene at the laser's wavelength and at those of the inelastic processes that a
/// channel of the scene counts. Throws InputError for what check_medium (medium/check.hpp) finds,
/// which reports more: all of it, and where. With phase functions left out, which take nearly all
/// the time, it has no bed, surface or film either, and is not finished: environments are refused
/// all the same, and nothing but its lines is of use.
Medium build_medium(const scene::Scene& scene, const optics::Library& library,
                    const std::stop_token& stop = {},
                    optics::Phases phases = optics::Phases::wanted);

}  // namespace photic::medium
