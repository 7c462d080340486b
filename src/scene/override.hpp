// --set path=value.
#pragma once

#include <cstddef>
#include <map>
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

/// For each list that stands for a longer one in the scene ("sea.layer", whose profiles are cut,
/// and "channel"): the number of elements that each of its own has become.
using Multiples = std::map<std::string, std::vector<std::size_t>>;

/// The value that a scene has by default where such a path leads in the document that it was read
/// from, `given`. `whole`: the scene's tree, every default in it.
std::optional<Node> find_default(const std::string& path, const Node& given, const Node& whole,
                                 const Multiples& multiples);

/// Makes an environment's changes. Returns the paths of those that could be made, by numbers.
std::vector<std::string> make_changes(const std::vector<Change>& changes, Node& document,
                                      Findings& findings);

/// Puts the value into the document, or says why it cannot be.
void apply_override(const std::string& override_text, Node& document, Findings& findings);

}  // namespace photic::scene
