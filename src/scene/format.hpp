// Node -> text.
#pragma once

#include <string>

#include "scene/node.hpp"

namespace photic::scene {

/// A scene as TOML: sections under their headers, all else as inline values.
std::string format_toml(const Node& table);

/// Indented JSON; arrays of plain values on one line.
std::string format_json(const Node& node);

}  // namespace photic::scene
