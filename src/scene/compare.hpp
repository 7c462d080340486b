// In what two scenes differ.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace photic::scene {

/// A value that two scenes do not share: its path, in the style of --set, and what messages call it
/// in each ("not given" where it is not).
struct Difference {
  std::string path, left, right;
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// All of them, in the order of the scene file; none if the scenes simulate the same.
std::vector<Difference> differences(const Scene& left, const Scene& right);

}  // namespace photic::scene
