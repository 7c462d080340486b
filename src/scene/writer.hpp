// The visitor that turns a section into a table of the tree, every default written out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/node.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

class Writer {
 public:
  template <class T, class... Rest>
  void required(const char* key, const T& value, const Rest&...) {
    table_.add(key, to_node(value));
  }
  template <class T, class... Rest>
  void required(const char* key, const std::optional<T>& value, const Rest&...) {
    if (value) table_.add(key, to_node(*value));
  }
  template <class T, class... Rest>
  void optional(const char* key, const T& value, const Rest&...) {
    required(key, value);
  }
  /// A list is written if there is anything in it, as sections are.
  template <class T, class... Rest>
  void optional(const char* key, const std::vector<T>& values, const Rest&...) {
    if (!values.empty()) required(key, values);
  }

  template <class T, class... Rest>
  void profiled(const char* key, const T& value, const Rest&...) {
    required(key, value);
  }

  template <class T>
  void section(const char* key, T& value, Need, const char*) {
    table_.add(key, written(value, describe_it)).section = true;
  }
  template <class T>
  void section(const char* key, std::optional<T>& value, Need need, const char*) {
    if (value) section(key, *value, need, "");
  }
  template <class T>
  void sections(const char* key, std::vector<T>& values, Need need, const char*) {
    if (need == Need::optional && values.empty()) return;
    tables(key, values, "", describe_it);
    std::get<Node::Table>(table_.value).back().value.section = true;
  }
  template <class T>
  void table(const char* key, T& value, const char*) {
    table_.add(key, written(value, describe_it));
  }
  template <class T>
  void table(const char* key, std::optional<T>& value, const char*) {
    if (value) table(key, *value, "");
  }
  template <class T, class Keys>
  void tables(const char* key, std::vector<T>& values, const char*, const Keys& keys) {
    Node::Array array;
    for (T& value : values) array.push_back(written(value, keys));
    table_.add(key, {.value = std::move(array)});
  }
  template <class T>
  void table_or_word(const char* key, std::optional<T>& value, const char*, const char*) {
    if (value) table(key, *value, "");
  }

  template <class T, class Value, class Keys>
  void when(const char*, const T& chosen, const Value& choice, const Keys& keys) {
    if (chosen == choice) keys(*this);
  }
  template <class E, class... Keys>
  void by_choice(const char*, const E& chosen, const ForChoice<E, Keys>&... groups) {
    ((chosen == groups.value ? groups.keys(*this) : void()), ...);
  }
  template <class... Keys>
  void one_of(const Option<Keys>&... options) {
    (write_if_active(options), ...);
  }
  template <class Keys>
  void any_of(const Keys& keys, const char* = "") {
    keys(*this);
  }
  template <class Keys>
  void with(const char*, bool active, const Keys& keys) {
    if (active) keys(*this);
  }
  template <class Keys>
  void unless(const char*, const char*, bool active, const char*, const Keys& keys) {
    if (!active) keys(*this);
  }
  template <class... Rest>
  void expanded(const char*, const Rest&...) {}
  template <class Action>
  void once_read(const Action&) {}

  [[nodiscard]] Node take() { return std::move(table_); }

 private:
  static constexpr auto describe_it = [](Writer& child, auto& value) { describe(child, value); };

  template <class T, class Keys>
  static Node written(T& value, const Keys& keys) {
    Writer child;
    keys(child, value);
    return child.take();
  }
  template <class Keys>
  void write_if_active(const Option<Keys>& option) {
    if (option.active) option.keys(*this);
  }

  Node table_ = empty_table();
};

}  // namespace photic::scene
