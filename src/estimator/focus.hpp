// The focus of a scene's telescopes.
#pragma once

#include <string>
#include <vector>

#include "estimator/model.hpp"
#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Remarks on telescopes in the air to which the sea's surface is out of focus, unless the scene
/// itself says where their detector is.
void check_focus(const scene::Scene& scene, scene::Findings& findings);

/// The line of `photic show` on each telescope.
std::vector<std::string> reported_focus(const Model& model);

}  // namespace photic::estimator
