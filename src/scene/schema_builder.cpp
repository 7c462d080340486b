#include "scene/schema_builder.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/error.hpp"

namespace photic::scene {
namespace {

Node keyed(const char* key, Node value) {
  Node table = empty_table();
  table.add(key, std::move(value));
  return table;
}

Node array(std::vector<Node> elements) { return {.value = std::move(elements)}; }

/// A schema that refuses these keys.
Node without(const std::vector<std::string>& keys) {
  Node properties = empty_table();
  for (const std::string& key : keys) properties.add(key, to_node(false));
  return keyed("properties", std::move(properties));
}

}  // namespace

Node SchemaBuilder::take() {
  Node schema = keyed("type", to_node("object"));
  schema.add("properties", {.value = std::move(properties_)});
  if (!required_.empty()) schema.add("required", to_node(required_));
  schema.add("additionalProperties", to_node(false));
  if (!conditions_.empty()) schema.add("allOf", {.value = std::move(conditions_)});
  return schema;
}

Node& SchemaBuilder::property(const Key& key, Node schema, const char* meaning,
                              const std::string& unit) {
  annotate(schema, meaning, unit, key.level);
  return properties_.emplace_back(Entry{key.name, {}, std::move(schema)}).value;
}

Node SchemaBuilder::reference(const char* definition) {
  return keyed("$ref", to_node(std::string("#/$defs/") + definition));
}

Node SchemaBuilder::array_of(Node element) {
  Node schema = keyed("type", to_node("array"));
  schema.add("items", std::move(element));
  schema.add("minItems", to_node(std::int64_t{1}));
  return schema;
}

Node SchemaBuilder::either_of(Node one, Node other) {
  return keyed("anyOf", array({std::move(one), std::move(other)}));
}

Node SchemaBuilder::sufficient_words(const std::string& word_key) const {
  const auto choice =
      std::ranges::find_if(properties_, [&](const Entry& entry) { return entry.key == word_key; });
  expect(choice != properties_.end(), "the word is a key of the table");
  Node words = keyed("oneOf", *choice->value.find("oneOf"));
  std::erase_if(*words.find("oneOf")->as<Node::Array>(), [&](const Node& word) {
    return std::ranges::count(demanding_, *word.find("const")->as<std::string>()) > 0;
  });
  return words;
}

Node SchemaBuilder::or_profile(Node schema) {
  return either_of(std::move(schema), reference(profile_name));
}

void SchemaBuilder::conditional(const char* selector, const std::vector<std::string>& choices,
                                const Names& keys) {
  if (!keys.needed().empty()) demanding_.insert(demanding_.end(), choices.begin(), choices.end());
  const Node is_chosen = choices.size() == 1 ? keyed("const", to_node(choices.front()))
                                             : keyed("enum", to_node(choices));
  Node chosen = keyed("properties", keyed(selector, is_chosen));
  chosen.add("required", to_node(std::vector<std::string>{selector}));
  Node condition = keyed("if", std::move(chosen));
  condition.add("then", keyed("required", to_node(keys.needed())));
  condition.add("else", without(keys.all()));
  conditions_.push_back(std::move(condition));
}

std::vector<std::string> SchemaBuilder::keys() const {
  std::vector<std::string> names;
  for (const Entry& property : properties_) names.push_back(property.key);
  return names;
}

Node SchemaBuilder::take_in(SchemaBuilder group) {
  for (Entry& property : group.properties_)
    if (std::ranges::find(properties_, property.key, &Entry::key) == properties_.end())
      properties_.push_back(std::move(property));
  Node demands = empty_table();
  if (!group.required_.empty()) demands.add("required", to_node(group.required_));
  if (!group.conditions_.empty()) demands.add("allOf", {.value = std::move(group.conditions_)});
  return demands;
}

void SchemaBuilder::choices(const char* selector, const std::string& by_default,
                            std::vector<std::pair<std::string, SchemaBuilder>>&& groups) {
  std::set<std::string> all;
  for (const auto& [word, group] : groups)
    for (const std::string& key : group.keys()) all.insert(key);
  for (auto& [word, group] : groups) {
    std::vector<std::string> foreign;
    const std::vector<std::string> own = group.keys();
    std::ranges::copy_if(all, std::back_inserter(foreign), [&](const std::string& key) {
      return std::ranges::find(own, key) == own.end();
    });
    Node chosen = keyed("properties", keyed(selector, keyed("const", to_node(word))));
    if (!group.required_.empty()) demanding_.push_back(word);
    if (word != by_default) chosen.add("required", to_node(std::vector<std::string>{selector}));
    Node then = take_in(std::move(group));
    Node refused = without(foreign);
    then.add("properties", std::move(*refused.find("properties")));
    Node condition = keyed("if", std::move(chosen));
    condition.add("then", std::move(then));
    conditions_.push_back(std::move(condition));
  }
}

void SchemaBuilder::only_with(const char* owner, SchemaBuilder group) {
  Node condition = keyed("if", keyed("required", to_node(std::vector<std::string>{owner})));
  Node refused = without(group.keys());
  condition.add("then", take_in(std::move(group)));
  condition.add("else", std::move(refused));
  conditions_.push_back(std::move(condition));
}

void SchemaBuilder::only_without(const char* table, const char* key, SchemaBuilder group) {
  Node given = keyed("required", to_node(std::vector<std::string>{table}));
  given.add("properties", keyed(table, keyed("required", to_node(std::vector<std::string>{key}))));
  Node condition = keyed("if", std::move(given));
  condition.add("then", without(group.keys()));
  condition.add("else", take_in(std::move(group)));
  conditions_.push_back(std::move(condition));
}

void SchemaBuilder::alternatives(const std::vector<Names>& groups) {
  Node::Array ways;
  for (const Names& group : groups) {
    std::vector<std::string> foreign;
    for (const Names& other : groups)
      if (&other != &group) foreign.insert(foreign.end(), other.all().begin(), other.all().end());
    Node& way = ways.emplace_back(without(foreign));
    if (!group.needed().empty()) way.add("required", to_node(group.needed()));
  }
  conditions_.push_back(keyed("oneOf", array(std::move(ways))));
  needs_one_ |= std::ranges::none_of(groups, [](const Names& g) { return g.needed().empty(); });
}

void SchemaBuilder::at_least_one(const Names& keys) {
  Node::Array ways;
  for (const std::string& key : keys.all())
    ways.push_back(keyed("required", to_node(std::vector<std::string>{key})));
  conditions_.push_back(keyed("anyOf", array(std::move(ways))));
}

}  // namespace photic::scene
