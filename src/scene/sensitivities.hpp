// The parameters of the water with respect to which echoes are derived.
#pragma once

#include <optional>
#include <vector>

#include "scene/findings.hpp"
#include "scene/read.hpp"
#include "scene/rules.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

/// An array of paths in the style of --set (a rule as those of rules.hpp). Their targets are for
/// read_sensitivities.
struct Parameters {
  using Value = std::vector<Sensitivity>;
};

std::optional<Refusal> check(const Parameters& rule, const Node& node,
                             std::vector<Sensitivity>& value);
Node schema_of(const Parameters& rule);
Node to_node(const std::vector<Sensitivity>& value);

/// Fills in what the scene's parameters are, and the water a step to either side of each, which
/// must be water that the scene can be compared with. Problems are reported at the path's place.
void read_sensitivities(const Node& document, const Check& check, Scene& scene, Findings& findings);

}  // namespace photic::scene
