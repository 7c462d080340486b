// The base scene with environments.
#pragma once

#include <string>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {

/// The base scene with these lines behind it: the first of them is line 31.
inline std::string with_environments(const std::string& environments) {
  return edited({}) + environments + '\n';
}

/// With one environment that sets this, from line 32, column 9 on.
inline std::string setting(const std::string& changes) {
  return with_environments("[[environment]]\nset = { " + changes + " }");
}

}  // namespace photic::scene
