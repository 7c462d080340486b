// A row of filters in place of one: centre_nm = { from = 380, to = 700, step = 5 }.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/findings.hpp"
#include "scene/node.hpp"
#include "scene/rules.hpp"

namespace photic::scene {

/// A wavelength, or steps from one to another (a rule as those of rules.hpp).
struct WavelengthOrSteps {
  using Value = double;
};

std::optional<Refusal> check(const WavelengthOrSteps& rule, const Node& node, double& value);
Node schema_of(const WavelengthOrSteps& rule);

/// Puts in place of each channel of a scene's document whose centre goes in steps one channel for
/// each step, which has its centre behind its name: "fluorescence_385". Malformed channels are left
/// for the reader to refuse. Returns how many each has become.
std::vector<std::size_t> expand_channels(Node& document);

}  // namespace photic::scene
