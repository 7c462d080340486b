// The visitor that turns the description of a section into JSON Schema (draft 2020-12).
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/annotate.hpp"
#include "scene/rules.hpp"
#include "scene/scene.hpp"
#include "scene/units.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

class SchemaBuilder {
 public:
  template <class T, class Rule>
  void required(const Key& key, const T&, const Rule& rule, const char* meaning) {
    property(key, schema_of(rule), meaning, unit_for<Rule>(key));
    required_.emplace_back(key.name);
  }
  template <class T, class Rule>
  void optional(const Key& key, const T& value, const Rule& rule, const char* meaning) {
    add_default(property(key, schema_of(rule), meaning, unit_for<Rule>(key)), value);
  }

  template <class T, class Rule>
  void profiled(const Key& key, const T& value, const Rule& rule, const char* meaning, double = 0) {
    add_default(property(key, or_profile(schema_of(rule)), meaning, unit_for<Rule>(key)), value);
  }

  /// A section with keys that must be given is required itself.
  template <class T>
  void section(const Key& key, T& value, Need need, const char* meaning) {
    if (table(key, value, meaning) || need == Need::required) required_.emplace_back(key.name);
  }
  template <class T>
  void section(const Key& key, std::optional<T>&, Need, const char* meaning) {
    T value{};
    table(key, value, meaning);
  }
  template <class T>
  void sections(const Key& key, std::vector<T>& values, Need need, const char* meaning) {
    tables(key, values, meaning, [](auto& child, T& value) { describe(child, value); });
    if (need == Need::optional) required_.pop_back();
  }
  /// Returns whether any of its keys must be given.
  template <class T>
  bool table(const Key& key, T& value, const char* meaning) {
    SchemaBuilder child;
    describe(child, value);
    const bool needed = !child.required_.empty() || child.needs_one_;
    property(key, child.take(), meaning);
    return needed;
  }
  template <class T>
  void table(const Key& key, std::optional<T>&, const char* meaning) {
    T value{};
    table(key, value, meaning);
  }
  template <class T, class Keys>
  void tables(const Key& key, std::vector<T>&, const char* meaning, const Keys& keys) {
    Node element;
    if constexpr (std::is_same_v<T, PhaseFunction>) {
      element =
          reference(component_name);  // it holds itself: by reference, or there would be no end
    } else {
      SchemaBuilder child;
      T value{};
      keys(child, value);
      element = child.take();
    }
    property(key, array_of(std::move(element)), meaning);
    required_.emplace_back(key.name);
  }
  template <class T>
  void table_or_word(const Key& key, std::optional<T>&, const char* word_key, const char* meaning) {
    SchemaBuilder table;
    T value{};
    describe(table, value);
    Node words = table.sufficient_words(word_key);
    Node whole =  // it holds itself: by reference, or there would be no end
        std::is_same_v<T, PhaseFunction> ? reference(phase_function_name) : table.take();
    property(key, either_of(std::move(words), std::move(whole)), meaning);
  }

  template <class T, class Value, class Keys>
  void when(const char* selector, const T&, const Value& choice, const Keys& keys) {
    adopt(keys);
    conditional(selector, words_of(choice), Names(keys));
  }
  template <class E, class... Keys>
  void by_choice(const char* selector, const E& by_default, const ForChoice<E, Keys>&... groups) {
    choices(selector, word_of(by_default), {{word_of(groups.value), apart(groups.keys)}...});
  }
  template <class... Keys>
  void one_of(const Option<Keys>&... options) {
    (adopt(options.keys), ...);
    alternatives({Names(options.keys)...});
  }
  template <class Keys>
  void any_of(const Keys& keys, const char* = "") {
    keys(*this);
    at_least_one(Names(keys));
  }
  template <class Keys>
  void with(const char* owner, bool, const Keys& keys) {
    only_with(owner, apart(keys));
  }
  template <class Keys>
  void unless(const char* table, const char* key, bool, const char*, const Keys& keys) {
    only_without(table, key, apart(keys));
  }
  template <class Rule, class... Default>
  void expanded(const Key& key, const Rule& rule, const char* meaning, const Default&... value) {
    Node& schema = property(key, schema_of(rule), meaning, unit_for<Rule>(key));
    (add_default(schema, value), ...);
  }
  template <class Action>
  void once_read(const Action&) {}

  /// The schema of the table, to be called once at the end.
  [[nodiscard]] Node take();

  static constexpr const char* phase_function_name = "phase_function";
  static constexpr const char* profile_name = "profile";
  static constexpr const char* component_name = "mixture_component";

 private:
  Node& property(const Key& key, Node schema, const char* meaning, const std::string& unit = "");
  /// The unit of the key's values; "" if they are no quantities.
  template <class Rule>
  static std::string unit_for(const Key& key) {
    return is_quantity<Rule> && key.has_unit ? unit_of(key.name) : "";
  }
  static Node reference(const char* definition);
  static Node array_of(Node element);
  static Node either_of(Node one, Node other);
  /// The words of a key that alone can stand for the table: those that ask for no other key.
  [[nodiscard]] Node sufficient_words(const std::string& word_key) const;
  static Node or_profile(Node schema);
  /// The keys of a group as properties, none of them required everywhere.
  template <class Keys>
  void adopt(const Keys& keys) {
    const std::size_t required_before = required_.size();
    keys(*this);
    required_.resize(required_before);
  }
  /// A group of keys by itself, what must hold for them included.
  template <class Keys>
  static SchemaBuilder apart(const Keys& keys) {
    SchemaBuilder child;
    keys(child);
    return child;
  }
  /// Returns the demands of a group beside its properties, which become this table's.
  Node take_in(SchemaBuilder group);
  [[nodiscard]] std::vector<std::string> keys() const;
  void conditional(const char* selector, const std::vector<std::string>& choices,
                   const Names& keys);
  void choices(const char* selector, const std::string& by_default,
               std::vector<std::pair<std::string, SchemaBuilder>>&& groups);
  void only_with(const char* owner, SchemaBuilder group);
  void only_without(const char* table, const char* key, SchemaBuilder group);
  void alternatives(const std::vector<Names>& groups);
  void at_least_one(const Names& keys);

  template <class T>
  static void add_default(Node& schema, const T& value) {
    schema.add("default", to_node(value));
  }
  template <class T>
  static void add_default(Node&, const std::optional<T>&) {}
  static void add_default(Node& schema, const std::string& value) {
    if (!value.empty()) schema.add("default", to_node(value));
  }
  static void add_default(Node& schema, const std::vector<double>& values) {
    if (!values.empty()) schema.add("default", to_node(values));
  }

  Node::Table properties_;
  std::vector<std::string> required_;
  std::vector<std::string> demanding_;  ///< choices that ask for other keys
  bool needs_one_ = false;              ///< of several keys
  Node::Array conditions_;              ///< schemas that must hold as well
};

}  // namespace photic::scene
