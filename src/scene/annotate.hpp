// The hints that the schema gives to editors about a key, besides the values it may have.
#pragma once

#include <string>

#include "scene/node.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

/// Adds `description`, `x-unit` (as unit_of returns it; "" leaves it out) and `x-level` to the
/// schema of a key.
inline void annotate(Node& schema, const std::string& meaning, const std::string& unit,
                     Level level) {
  schema.add("description", to_node(meaning));
  if (!unit.empty()) schema.add("x-unit", to_node(unit));
  schema.add("x-level", to_node(level == Level::basic ? "basic" : "expert"));
}

}  // namespace photic::scene
