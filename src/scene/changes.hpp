// The changes of an environment: as the value of a key, and as tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/node.hpp"
#include "scene/rules.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

/// A table of paths in the style of --set and of values (a rule as those of rules.hpp). The targets
/// of the paths are for scene/environments.hpp.
struct Changes {
  using Value = std::vector<Change>;
};

std::optional<Refusal> check(const Changes& rule, const Node& node, std::vector<Change>& value);
Node schema_of(const Changes& rule);
Node to_node(const std::vector<Change>& value);

/// Returns whether a path leads to what may differ in environments: sea, optics, bed, film and air.
bool leads_to_medium(const std::string& path);
inline constexpr const char* media = "sea., optics., bottom., oil. or atmosphere.";
inline constexpr const char* may_differ =
    "only the water, the bed, a film of oil and the air may differ, since the histories are the "
    "same";

/// The reason why a path must not be changed in other water, as far as the path alone shows.
std::optional<Refusal> check_path(const std::string& path);

/// The same of a path and its value.
std::optional<Refusal> check_change(const std::string& path, const Node& value);

/// Takes out of a document what changes at these paths take the place of: a visibility or an
/// optical depth of aerosols that of the other key, aerosol = "none" that of both.
void take_out_replaced(const std::vector<std::string>& paths, Node& document);

/// Returns whether scenes can hold the value: no dates, and finite numbers.
bool is_value(const Node& node);

}  // namespace photic::scene
