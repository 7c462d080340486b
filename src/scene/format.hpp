// Node -> text.
#pragma once

#include <string>

#include "scene/node.hpp"

namespace photic::scene {

/// A scene as TOML: sections under their headers, all else as inline values; long columns of
/// numbers take several lines.
std::string format_toml(const Node& table);

/// A value as TOML, on one line.
std::string format_value(const Node& node);

/// Indented JSON; arrays of plain values on one line.
std::string format_json(const Node& node);

}  // namespace photic::scene
