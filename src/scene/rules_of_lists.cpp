// The rules for lists of numbers and of directions (rules.hpp).
#include <fmt/format.h>

#include <algorithm>

#include "scene/rules.hpp"

namespace photic::scene {
namespace {

/// Refuses what is no list of so many elements; `like` shows one.
std::optional<Refusal> check_list(const Node& node, std::size_t least, const std::string& what,
                                  const std::string& like) {
  const auto* array = node.as<Node::Array>();
  if (array && array->size() >= least) return std::nullopt;
  return Refusal{fmt::format("must be a list of {}, not {}", what, found_text(node)),
                 fmt::format("write {}", like)};
}

/// An element of a list is refused.
Refusal in_list(const Refusal& of_element) {
  return {"must be a list, each element" + of_element.reason.substr(sizeof("must be") - 1),
          of_element.suggestion};
}

/// "[0.5]" for 0.5.
std::string as_list(const Node& node) {
  double number = 0;
  return check(any_number, node, number) ? "[a, b, …]" : fmt::format("[{}]", plain_number(number));
}

Node array_of(Node items) {
  Node schema = empty_table();
  schema.add("type", to_node("array"));
  schema.add("items", std::move(items));
  return schema;
}

}  // namespace

std::optional<Refusal> check(const NumberList& rule, const Node& node, std::vector<double>& value) {
  const bool one = rule.least == 1;
  if (auto problem = check_list(node, rule.least, one ? "numbers" : "two or more numbers",
                                one ? as_list(node) : "[a, b, …]"))
    return problem;
  std::vector<double> numbers;
  for (const Node& element : *node.as<Node::Array>())
    if (const auto problem = check(rule.number, element, numbers.emplace_back()))
      return in_list(*problem);
  value = std::move(numbers);
  return std::nullopt;
}

std::optional<Refusal> check(const TravelDirections&, const Node& node,
                             std::vector<TravelDirection>& value) {
  const char* like = "[[zenith, azimuth], …], as [[0, 0]] for straight up";
  if (auto problem = check_list(node, 1, "directions", like)) return problem;
  for (const Node& element : *node.as<Node::Array>()) {
    std::vector<double> angles;
    if (check(NumberList{.number = any_number, .least = 2}, element, angles) || angles.size() != 2)
      return Refusal{
          fmt::format("must be a list of pairs of angles, not of {}", found_text(element)),
          fmt::format("write {}", like)};
    value.push_back({angles[0], angles[1]});
  }
  return std::nullopt;
}

Node to_node(const std::vector<TravelDirection>& value) {
  Node::Array all;
  for (const TravelDirection& direction : value)
    all.push_back(to_node(std::vector{direction.zenith_deg, direction.azimuth_deg}));
  return {.value = std::move(all)};
}

Node schema_of(const NumberList& rule) {
  Node schema = array_of(schema_of(rule.number));
  schema.add("minItems", to_node(static_cast<std::int64_t>(rule.least)));
  return schema;
}

Node schema_of(const TravelDirections&) {
  Node pair = array_of(schema_of(any_number));
  pair.add("minItems", to_node(std::int64_t{2}));
  pair.add("maxItems", to_node(std::int64_t{2}));
  Node schema = array_of(std::move(pair));
  schema.add("minItems", to_node(std::int64_t{1}));
  return schema;
}

}  // namespace photic::scene
