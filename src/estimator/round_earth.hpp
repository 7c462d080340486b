// Remarks on scenes whose echoes show that the sea is simulated as a plane.
#pragma once

#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Remarks on instruments in the air whose axis has another length to a round earth than to a flat
/// one, or another slope in the water.
void check_round_earth(const scene::Scene& scene, scene::Findings& findings);

}  // namespace photic::estimator
