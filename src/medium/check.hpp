// The problems that the optics find in a scene, each at its place in the scene file.
#pragma once

#include "optics/library.hpp"
#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// Asks for all that build_medium would ask for, and adds what is refused to the findings: a
/// wavelength without data, optical properties that do not reach it, a table of no use. Looks only
/// at values with which nothing is wrong yet. A scene that it accepts is accepted by build_medium.
/// Returns the highest albedo, b / c, of the laser's light in any layer; 0 if none is known.
double check_medium(const scene::Scene& scene, const optics::Library& library,
                    scene::Findings& findings);

}  // namespace photic::medium
