// TOML text -> Node. The only door to the TOML library.
#pragma once

#include <optional>
#include <string>

#include "scene/node.hpp"

namespace photic::scene {

/// Throws InputError with the one syntax error that stopped the parser.
Node parse_toml(const std::string& text, const std::string& file);

/// The value of "--set path=value": TOML, or else the text as it stands; nothing if it is not
/// UTF-8. Every place inside is `place`.
std::optional<Node> parse_value(const std::string& text, const Place& place);

}  // namespace photic::scene
