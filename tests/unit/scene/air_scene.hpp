// The base scene with air.
#pragma once

#include "unit/scene/base_scene.hpp"

namespace photic::scene {

inline const Override us_standard{"atmosphere={ profile = \"us-standard\" }"};

}  // namespace photic::scene
