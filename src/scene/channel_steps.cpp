#include "scene/channel_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "scene/annotate.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

constexpr const char* centre_key = "centre_nm";
constexpr double max_steps = 1000;

struct Steps {
  double from{}, to{}, step{};
  /// The number of steps: `to` counts if rounding alone keeps it from being one.
  [[nodiscard]] double count() const { return std::floor((to - from) / step + 1e-9) + 1; }
};

std::optional<Refusal> read(const Node& table, Steps& steps) {
  const std::array keys{std::pair{"from", &steps.from}, std::pair{"to", &steps.to},
                        std::pair{"step", &steps.step}};
  const char* const as_it_should_be = "write { from = 380, to = 700, step = 5 }";
  for (const auto& [key, value] : keys) {
    const Node* node = table.find(key);
    if (!node) return Refusal{fmt::format("lacks '{}'", key), as_it_should_be};
    const bool is_step = value == &steps.step;
    if (auto refusal =
            is_step ? check(positive, *node, *value) : check(Wavelength{}, *node, *value)) {
      refusal->reason = fmt::format("has a '{}' that {}", key, refusal->reason);
      return refusal;
    }
  }
  if (table.as<Node::Table>()->size() != keys.size())
    return Refusal{"has other keys than from, to and step", as_it_should_be};
  if (steps.to < steps.from)
    return Refusal{fmt::format("goes from {:g} to {:g} nm", steps.from, steps.to),
                   "give the shorter wavelength first"};
  if (steps.count() > max_steps)
    return Refusal{fmt::format("makes {:.7g} channels", steps.count()),
                   fmt::format("at most {:.0f} are possible: take longer steps", max_steps)};
  return std::nullopt;
}

/// The steps of a channel that is to be many.
std::optional<Steps> steps_of(const Node& channel) {
  const Node* centre = channel.find(centre_key);
  const Node* name = channel.find("name");
  Steps steps;
  if (!centre || !centre->as<Node::Table>() || !name || !name->as<std::string>() ||
      read(*centre, steps))
    return std::nullopt;
  return steps;
}

Node channel_at(const Node& channel, double nm) {
  Node one = channel;
  for (Entry& entry : *one.as<Node::Table>()) {
    const Place place = entry.value.place;
    if (entry.key == centre_key) entry.value = to_node(nm);
    if (entry.key == "name")
      entry.value = to_node(fmt::format("{}_{}", *entry.value.as<std::string>(), plain_number(nm)));
    entry.value.place = place;
  }
  return one;
}

}  // namespace

std::optional<Refusal> check(const WavelengthOrSteps&, const Node& node, double& value) {
  if (!node.as<Node::Table>()) return check(Wavelength{}, node, value);
  Steps steps;
  auto refusal = read(node, steps);
  value = steps.from;
  return refusal;
}

Node schema_of(const WavelengthOrSteps&) {
  Node steps = empty_table();
  Node properties = empty_table();
  Node required{.value = Node::Array{}};
  for (auto [key, meaning, schema] :
       {std::tuple{"from", "the first centre in nm", schema_of(Wavelength{})},
        std::tuple{"to", "the last centre in nm", schema_of(Wavelength{})},
        std::tuple{"step", "how far the centres are apart in nm", schema_of(positive)}}) {
    annotate(schema, meaning, unit_of(centre_key), Level::basic);
    properties.add(key, std::move(schema));
    required.as<Node::Array>()->push_back(to_node(key));
  }
  steps.add("type", to_node("object"));
  steps.add("properties", std::move(properties));
  steps.add("required", std::move(required));
  steps.add("additionalProperties", to_node(false));
  Node either = empty_table();
  either.add("anyOf", {.value = Node::Array{schema_of(Wavelength{}), std::move(steps)}});
  return either;
}

std::vector<std::size_t> expand_channels(Node& document) {
  const auto& table = *document.as<Node::Table>();
  const auto given =
      std::ranges::find_if(table, [](const Entry& entry) { return entry.key == "channel"; });
  if (given == table.end() || !given->value.as<Node::Array>()) return {};
  Node::Array out;
  std::vector<std::size_t> counts;
  for (const Node& channel : *given->value.as<Node::Array>()) {
    const auto steps = channel.as<Node::Table>() ? steps_of(channel) : std::nullopt;
    counts.push_back(steps ? static_cast<std::size_t>(steps->count()) : 1);
    if (!steps) {
      out.push_back(channel);
      continue;
    }
    for (int i = 0; i < static_cast<int>(steps->count()); ++i)
      out.push_back(channel_at(channel, steps->from + i * steps->step));
  }
  auto& channels = *document.as<Node::Table>();
  channels[static_cast<std::size_t>(given - table.begin())].value.value = std::move(out);
  return counts;
}

}  // namespace photic::scene
