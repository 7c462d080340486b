// The sets of data and models that [optics] set = "…" stands for.
#pragma once

#include <string>
#include <vector>

#include "scene/rules.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

std::vector<Word> optics_sets();

/// All choices of a set that optics_sets() names.
Optics optics_of(const std::string& set);

}  // namespace photic::scene
