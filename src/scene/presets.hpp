// The sets of data and models that [optics] set = "…" stands for.
#pragma once

#include "scene/scene.hpp"

namespace photic::scene {

/// All choices of a set.
Optics optics_of(OpticsSet set);

}  // namespace photic::scene
