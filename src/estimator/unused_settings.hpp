// The settings of a simulation that a scene names and that its estimator does not use.
#pragma once

#include "medium/medium.hpp"
#include "optics/library.hpp"
#include "scene/findings.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Returns whether the water converts light that a channel counts.
bool converts_light(const medium::Medium& medium);

/// Remarks on each of them. Where "auto" may choose the estimator of a setting, the setting counts
/// as used.
void check_unused_settings(const scene::Scene& scene, const optics::Library& library,
                           scene::Findings& findings);

/// The simulation with what is in effect in their place.
scene::Simulation without_unused_settings(const scene::Scene& scene, const medium::Medium& medium);

}  // namespace photic::estimator
