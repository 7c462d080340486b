// The sea bed of a scene, as numbers of a Medium.
#pragma once

#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// Fills in the bed's albedo at the medium's lines, and what environments and derivatives have more
/// of it. A bed that reflects nothing is black. Throws InputError for a wavelength that a table
/// does not reach.
void add_bed(const scene::Scene& scene, Medium& medium);

}  // namespace photic::medium
