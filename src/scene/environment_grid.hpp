// [environment_grid]: environments as the product of values.
#pragma once

#include "scene/findings.hpp"
#include "scene/node.hpp"

namespace photic::scene {

/// A table of paths in the style of --set and of arrays of values (a rule as those of rules.hpp).
struct Grid {};

Node schema_of(const Grid& rule);

/// Takes [environment_grid] out of a scene's document and puts the environments it stands for
/// behind those that there are, the values of its first path changing slowest. Each is called by
/// its values, which keep their places. A grid that is refused leaves none.
void expand_grid(Node& document, Findings& findings);

}  // namespace photic::scene
