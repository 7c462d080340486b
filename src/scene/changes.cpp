#include "scene/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "scene/format.hpp"
#include "scene/parse.hpp"

namespace photic::scene {
namespace {

bool begins_with(const std::string& path, const char* start) { return path.rfind(start, 0) == 0; }

}  // namespace

bool leads_to_medium(const std::string& path) {
  return begins_with(path, "sea.") || begins_with(path, "optics.") ||
         begins_with(path, "bottom.") || begins_with(path, "oil.") ||
         begins_with(path, "atmosphere.");
}

std::optional<Refusal> check_path(const std::string& path) {
  if (path == "sea" || path == "optics" || path == "bottom" || path == "oil" ||
      path == "atmosphere")
    return Refusal{fmt::format("'{}' cannot be set as a whole in an environment", path),
                   R"(quote the whole path: "sea.layer.0.chlorophyll_mg_m3" = 0.5)"};
  if (!leads_to_medium(path))
    return Refusal{fmt::format("'{}' cannot be set in an environment: {}", path, may_differ),
                   fmt::format("set paths that begin with {}", media)};
  return std::nullopt;
}

std::optional<Refusal> check_change(const std::string& path, const Node& value) {
  if (auto refusal = check_path(path)) return refusal;
  if (!is_value(value))
    return Refusal{fmt::format("'{}' must be made of finite numbers, texts, true and false, not {}",
                               path, found_text(value)),
                   ""};
  return std::nullopt;
}

void take_out_replaced(const std::vector<std::string>& paths, Node& document) {
  constexpr const char* amounts[] = {"visibility_km", "aerosol_optical_depth_550"};
  Node* air = document.find("atmosphere");
  auto* keys = air ? air->as<Node::Table>() : nullptr;
  if (!keys) return;
  const auto is_set = [&](const std::string& key) {
    return std::ranges::find(paths, "atmosphere." + key) != paths.end();
  };
  const Node* aerosol = air->find("aerosol");
  const auto* word = aerosol ? aerosol->as<std::string>() : nullptr;
  if (!std::ranges::any_of(amounts, is_set) && !(is_set("aerosol") && word && *word == "none"))
    return;
  for (const char* amount : amounts)
    if (!is_set(amount))
      std::erase_if(*keys, [&](const Entry& entry) { return entry.key == amount; });
}

bool is_value(const Node& node) {
  if (const auto* array = node.as<Node::Array>())
    return std::all_of(array->begin(), array->end(), is_value);
  if (const auto* table = node.as<Node::Table>())
    return std::all_of(table->begin(), table->end(),
                       [](const Entry& entry) { return is_value(entry.value); });
  const auto* number = node.as<double>();
  return !node.as<Date>() && (!number || std::isfinite(*number));
}

/// A node that is no value is left out: it is refused where its path is looked at.
std::optional<Refusal> check(const Changes&, const Node& node, std::vector<Change>& value) {
  const auto* table = node.as<Node::Table>();
  if (!table)
    return Refusal{fmt::format("must be a table, not {}", found_text(node)),
                   R"(write { "sea.layer.0.chlorophyll_mg_m3" = 0.5 })"};
  for (const Entry& entry : *table)
    if (is_value(entry.value)) value.push_back({entry.key, format_value(entry.value)});
  return std::nullopt;
}

Node schema_of(const Changes&) {
  Node schema = empty_table();
  schema.add("type", to_node("object"));
  schema.add("additionalProperties", to_node(true));
  return schema;
}

Node to_node(const std::vector<Change>& value) {
  Node table = empty_table();
  for (const Change& change : value) {
    auto node = parse_value(change.value, {});
    expect(node.has_value(), "the value of a change is TOML");
    table.add(change.path, std::move(*node));
  }
  return table;
}

}  // namespace photic::scene
