// Where it shows that the sea is simulated as a plane.
#pragma once

#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Remarks on instruments in the air whose axis comes to a round earth after another way, or goes
/// on in the water more or less steeply, than to a flat one.
void check_round_earth(const scene::Scene& scene, scene::Findings& findings);

}  // namespace photic::estimator
