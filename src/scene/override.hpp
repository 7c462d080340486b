// --set path=value.
#pragma once

#include <string>

#include "scene/findings.hpp"
#include "scene/node.hpp"

namespace photic::scene {

/// Puts the value into the document, or says why it cannot be.
void apply_override(const std::string& override_text, Node& document, Findings& findings);

}  // namespace photic::scene
