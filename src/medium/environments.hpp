// The effect of other waters, the environments, on the weights of paths that were drawn in the
// medium (docs/theory.md, "Environments").
#pragma once

#include <stop_token>

#include "medium/medium.hpp"
#include "medium/phase_numbers.hpp"
#include "optics/library.hpp"
#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// Adds the tables of the scene's environments to a medium that is made but for them and not yet
/// finished. Throws InputError where light goes ways in an environment that it never goes in the
/// scene.
void add_environments(const scene::Scene& scene, const optics::Library& library,
                      const PhaseNumbers& number_of, Medium& medium, const std::stop_token& stop);

/// Adds what add_environments refuses to the findings, if the environments' water is known.
void check_environments(const scene::Scene& scene, const optics::Library& library,
                        scene::Findings& findings);

}  // namespace photic::medium
