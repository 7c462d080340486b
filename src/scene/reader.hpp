// The visitor that fills a section from a table of the file and says all that is wrong with it.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/table_reader.hpp"
#include "scene/user_table_reader.hpp"

namespace photic::scene {

template <class T>
struct Plain {
  using Type = T;
};
template <class T>
struct Plain<std::optional<T>> {
  using Type = T;
};

class Reader : public TableReader {
 public:
  using TableReader::TableReader;

  template <class T, class Rule>
  void required(const char* key, T& value, const Rule& rule, const char* meaning) {
    if (const Node* node = look(key))
      read(key, *node, value, rule);
    else
      missing(key, meaning);
  }

  template <class T, class Rule>
  void optional(const char* key, T& value, const Rule& rule, const char*) {
    if (const Node* node = look(key)) read(key, *node, value, rule);
  }

  /// Profiles have become numbers.
  template <class T, class Rule>
  void profiled(const char* key, T& value, const Rule& rule, const char* meaning, double = 0) {
    optional(key, value, rule, meaning);
  }

  template <class T>
  void section(const char* key, T& value, Need need, const char* meaning) {
    const TableName name = section_name(key, "[", "]");
    const Node* node = look(key);
    if (!node && need == Need::required) return section_missing(name, meaning);
    descend(key, node, value, name);
  }

  /// A section that may be left out as a whole.
  template <class T>
  void section(const char* key, std::optional<T>& value, Need, const char*) {
    if (const Node* node = look(key))
      descend(key, node, value.emplace(), section_name(key, "[", "]"));
  }

  template <class T>
  void sections(const char* key, std::vector<T>& values, Need need, const char* meaning) {
    const TableName name = section_name(key, "[[", "]]");
    const Node* node = look(key);
    if (!node && need == Need::required) section_missing(name, meaning);
    if (!node) return;
    elements(key, *node, values, name, [](Reader& child, T& value) { describe(child, value); });
  }

  /// An optional inline table; its defaults are filled in where it is absent.
  template <class T>
  void table(const char* key, T& value, const char*) {
    descend(key, look(key), value, inline_name(key));
  }

  /// One that may be left out as a whole.
  template <class T>
  void table(const char* key, std::optional<T>& value, const char*) {
    if (const Node* node = look(key)) descend(key, node, value.emplace(), inline_name(key));
  }

  template <class T, class Keys>
  void tables(const char* key, std::vector<T>& values, const char* meaning, const Keys& keys) {
    const Node* node = look(key);
    if (!node) return missing(key, meaning);
    elements(key, *node, values, inline_name(key), keys);
  }

  /// An optional inline table, for which a word may stand that is the value of `word_key`.
  template <class T>
  void table_or_word(const char* key, std::optional<T>& value, const char* word_key, const char*) {
    const Node* node = look(key);
    if (!node) return;
    if (!node->as<std::string>()) return descend(key, node, value.emplace(), inline_name(key));
    Node table = empty_table();
    table.place = node->place;
    table.add(word_key, *node);
    descend(key, &table, value.emplace(), inline_name(key));
  }

  /// Keys that belong to one choice of another key, and are foreign to the others.
  template <class T, class Value, class Keys>
  void when(const char* selector, const T& chosen, const Value& choice, const Keys& keys) {
    if (chosen == choice)
      keys(*this);
    else
      refuse_foreign(Names(keys), selector, word_of(chosen), words_of(choice));
  }

  template <class E, class... Keys>
  void by_choice(const char* selector, const E& chosen, const ForChoice<E, Keys>&... groups) {
    if (shared_.findings.good({path_of(selector)}))
      ((chosen == groups.value ? groups.keys(*this) : void()), ...);
    refuse_of_others(selector, word_of(chosen), {{word_of(groups.value), Names(groups.keys)}...});
  }

  template <class... Keys>
  void one_of(const Option<Keys>&... options) {
    forgive_missing_ = check_groups({Names(options.keys)...}) > 1;
    (read_group(options.keys), ...);
    forgive_missing_ = false;
  }

  template <class Keys>
  void any_of(const Keys& keys, const char* suggestion = "") {
    keys(*this);
    check_any(Names(keys), suggestion);
  }

  template <class Keys>
  void with(const char* owner, bool, const Keys& keys) {
    if (table_.find(owner))
      keys(*this);
    else
      refuse_without(owner, Names(keys));
  }

  template <class Keys>
  void unless(const char* table, const char* key, bool, const char* reason, const Keys& keys) {
    const Node* node = table_.find(table);
    if (node && node->find(key))
      refuse_beside(below(table, key), reason, Names(keys));
    else
      keys(*this);
  }

  template <class Rule, class... Default>
  void expanded(const char* key, const Rule&, const char*, const Default&...) {
    look(key);
  }
  template <class Action>
  void once_read(const Action& action) {
    action();
  }

 private:
  template <class T, class Rule>
  void read(const std::string& key, const Node& node, T& value, const Rule& rule) {
    typename Rule::Value plain{};
    std::optional<Refusal> problem;
    if constexpr (std::is_same_v<Rule, TableOrFile>)
      problem = read_user_table(rule, node, inline_name(key), shared_, plain);
    else if constexpr (std::is_same_v<Rule, NumberOrTable>)
      problem = read_number_or_table(rule, node, inline_name(key), shared_, plain);
    else if constexpr (std::is_same_v<Rule, WordOrTable>)
      problem = read_word_or_table(rule, node, inline_name(key), shared_, plain);
    else if constexpr (std::is_same_v<Rule, File>)
      problem = check(rule, node, plain, shared_.folder);
    else
      problem = check(rule, node, plain);
    if constexpr (std::is_same_v<typename Rule::Value, double>)
      if (problem && problem->suggestion.empty())
        problem->suggestion = other_unit(key, node, [&rule](const Node& meant) {
          double ignored = 0;
          return !check(rule, meant, ignored);
        });
    if (problem)
      refuse(key, node, *problem);
    else
      value = static_cast<typename Plain<T>::Type>(plain);
  }

  template <class T>
  void descend(const std::string& key, const Node* node, T& value, const TableName& name) {
    if (node && !is_table(key, *node, name)) return;
    Node nothing = empty_table();
    nothing.place = shared_.findings.end();
    Reader child(node ? *node : nothing, name, shared_);
    describe(child, value);
    child.finish();
  }

  template <class T, class Keys>
  void elements(const std::string& key, const Node& node, std::vector<T>& values,
                const TableName& name, const Keys& keys) {
    if (!is_tables(key, node, name)) return;
    const auto& array = *node.as<Node::Array>();
    values.resize(array.size());
    for (std::size_t i = 0; i < array.size(); ++i) {
      Reader child(array[i], {below(name.path, i), name.header, name.label}, shared_);
      keys(child, values[i]);
      child.finish();
    }
  }

  /// Looks at all keys of a group, so that they are known, and reads it if any is given.
  template <class Keys>
  void read_group(const Keys& keys) {
    const Names names(keys);
    if (first_given(names))
      keys(*this);
    else
      for (const std::string& key : names.all()) look(key);
  }
};

}  // namespace photic::scene
