// --set path=value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/findings.hpp"
#include "scene/node.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

/// Puts a value where a path in the style of --set leads, and returns that path with numbers in the
/// place of names. Says at `place` why it cannot be, and returns nothing.
std::optional<std::string> assign(const std::string& path, Node value, const Place& place,
                                  Node& document, Findings& findings);

/// Takes the value away to which such a path leads. Says at `place` why it cannot be.
void take_away(const std::string& path, const Place& place, Node& document, Findings& findings);

/// The value to which such a path leads; null if there is none.
const Node* find(const std::string& path, const Node& document);

/// Makes an environment's changes. Returns the paths of those that could be made, by numbers.
std::vector<std::string> make_changes(const std::vector<Change>& changes, Node& document,
                                      Findings& findings);

/// Puts the value into the document, or says why it cannot be.
void apply_override(const std::string& override_text, Node& document, Findings& findings);

}  // namespace photic::scene
