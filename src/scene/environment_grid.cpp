#include "scene/environment_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/changes.hpp"
#include "scene/format.hpp"
#include "scene/rules.hpp"

namespace photic::scene {
namespace {

constexpr const char* grid_key = "environment_grid";
/// More would take minutes to be read, and more memory than tallies may have.
constexpr double max_environments = 10000;

std::string last_part(const std::string& path) {
  return path.substr(path.find_last_of('.') + 1);  // all of a path without dots
}

/// The name of each path in the environments' names: its last part, if that is no other's, too.
std::vector<std::string> short_names(const Node::Table& grid) {
  std::vector<std::string> names;
  for (const Entry& entry : grid) {
    const std::string name = last_part(entry.key);
    const auto same = std::count_if(grid.begin(), grid.end(),
                                    [&](const Entry& e) { return last_part(e.key) == name; });
    names.push_back(same == 1 ? name : entry.key);
  }
  return names;
}

/// Says what is wrong with one path and its values; returns whether nothing is.
bool check_values(const Entry& entry, Findings& findings) {
  const auto refuse = [&](const Place& place, const Refusal& refusal) {
    findings.add_at(place, refusal.reason, refusal.suggestion);
    return false;
  };
  if (const auto refusal = check_path(entry.key)) return refuse(entry.place, *refusal);
  const auto* values = entry.value.as<Node::Array>();
  if (!values || values->empty())
    return refuse(entry.value.place,
                  {fmt::format("'{}' must be an array of one or more values, not {}", entry.key,
                               found_text(entry.value)),
                   "write the values in brackets: [0.1, 0.5]"});
  std::set<std::string> seen;
  for (const Node& value : *values) {
    if (const auto refusal = check_change(entry.key, value)) return refuse(value.place, *refusal);
    if (!seen.insert(format_value(value)).second)
      return refuse(value.place, {fmt::format("'{}' has {} twice", entry.key, found_text(value)),
                                  "each value once"});
  }
  return true;
}

double product(const Node::Table& grid) {
  double count = 1;
  for (const Entry& entry : grid)
    count *= static_cast<double>(entry.value.as<Node::Array>()->size());
  return count;
}

/// Reports all that is wrong, and returns whether nothing is.
bool check_grid(const Entry& grid, Findings& findings) {
  const auto* table = grid.value.as<Node::Table>();
  if (!table || table->empty()) {
    findings.add_at(
        grid.value.place,
        fmt::format("'{}' must be a table of one or more paths with their values, "
                    "not {}",
                    grid_key, table ? "an empty one" : found_text(grid.value)),
        R"(write "sea.layer.0.chlorophyll_mg_m3" = [0.1, 0.5] below [environment_grid])");
    return false;
  }
  bool good = true;
  for (const Entry& entry : *table) good = check_values(entry, findings) && good;
  if (!good || product(*table) <= max_environments) return good;
  findings.add_at(grid.value.place, fmt::format("these are {:.7g} environments", product(*table)),
                  fmt::format("at most {:.0f} are possible: give fewer values", max_environments));
  return false;
}

/// A value as it stands in a name: without quotes.
std::string name_of(const Node& value) {
  const auto* text = value.as<std::string>();
  return text ? *text : format_value(value);
}

/// One of each path's values, by their numbers.
Node environment_of(const Entry& grid, const std::vector<std::string>& names,
                    const std::vector<std::size_t>& chosen) {
  const auto& table = *grid.value.as<Node::Table>();
  Node set = empty_table();
  std::string name;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Node& value = (*table[k].value.as<Node::Array>())[chosen[k]];
    name += fmt::format("{}{} = {}", k == 0 ? "" : ", ", names[k], name_of(value));
    set.add(table[k].key, value);
  }
  Node environment = empty_table();
  environment.add("name", to_node(name));
  environment.add("set", std::move(set));
  for (Entry& entry : *environment.as<Node::Table>())
    entry.place = entry.value.place = grid.value.place;
  environment.place = grid.value.place;
  return environment;
}

/// The next choice of values; false after the last.
bool advance(const Node::Table& grid, std::vector<std::size_t>& chosen) {
  for (std::size_t k = chosen.size(); k-- > 0;) {
    if (++chosen[k] < grid[k].value.as<Node::Array>()->size()) return true;
    chosen[k] = 0;
  }
  return false;
}

void append(const Entry& grid, Node& environments) {
  const auto& table = *grid.value.as<Node::Table>();
  const auto names = short_names(table);
  std::vector<std::size_t> chosen(table.size());
  do {
    environments.as<Node::Array>()->push_back(environment_of(grid, names, chosen));
  } while (advance(table, chosen));
  environments.place = grid.value.place;  // if they are too many, it is the grid's doing
}

/// Takes an entry out of a table.
std::optional<Entry> take(Node::Table& table, const std::string& key) {
  const auto entry =
      std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.key == key; });
  if (entry == table.end()) return std::nullopt;
  Entry taken = std::move(*entry);
  table.erase(entry);
  return taken;
}

}  // namespace

Node schema_of(const Grid&) {
  Node values = empty_table();
  values.add("type", to_node("array"));
  values.add("minItems", to_node(std::int64_t{1}));
  Node schema = empty_table();
  schema.add("type", to_node("object"));
  schema.add("minProperties", to_node(std::int64_t{1}));
  schema.add("additionalProperties", std::move(values));
  return schema;
}

void expand_grid(Node& document, Findings& findings) {
  auto& table = *document.as<Node::Table>();
  const auto grid = take(table, grid_key);
  if (!grid || !check_grid(*grid, findings)) return;
  const auto given = std::find_if(table.begin(), table.end(),
                                  [](const Entry& e) { return e.key == "environment"; });
  if (given == table.end())
    append(*grid, document.add("environment", {.value = Node::Array{}}));
  else if (const auto* array = given->value.as<Node::Array>(); array && !array->empty())
    append(*grid, given->value);  // other entries are refused where they are read
}

}  // namespace photic::scene
