// One table of a scene file: which keys were asked for, and the messages about the others.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/findings.hpp"
#include "scene/rules.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

/// The context that the readers of all tables of one scene share.
struct ReadContext {
  Findings& findings;
  std::optional<std::string> folder;  ///< that of relative files; none: no file may be named
};

/// The place of a table in the scene.
struct TableName {
  std::string path;    ///< "sea.layer.0"
  std::string header;  ///< "sea.layer"
  std::string label;   ///< its name in messages: "[[sea.layer]]", "'phase_function'"

  [[nodiscard]] bool is_section() const { return label.front() == '['; }
};

class TableReader {
 public:
  TableReader(const Node& table, TableName name, ReadContext& shared)
      : table_(table), name_(std::move(name)), shared_(shared) {}

  /// To be called last: keys that were not asked for are errors.
  void finish();

 protected:
  /// The value of a key, which is known from now on; null if it is not given.
  const Node* look(const std::string& key);
  [[nodiscard]] std::string path_of(const std::string& key) const { return below(name_.path, key); }
  [[nodiscard]] TableName inline_name(const std::string& key) const;
  [[nodiscard]] TableName section_name(const std::string& key, const char* open,
                                       const char* close) const;

  void missing(const std::string& key, const char* meaning);
  void section_missing(const TableName& section, const char* meaning);
  void refuse(const std::string& key, const Node& node, const Refusal& problem);
  /// "did you mean …?" of a number that is refused, and would not be in another unit; else "".
  static std::string other_unit(const std::string& key, const Node& node,
                                const std::function<bool(const Node&)>& is_good);
  /// Refuses and returns false unless it is a table, or an array of at least one table.
  bool is_table(const std::string& key, const Node& node, const TableName& name);
  bool is_tables(const std::string& key, const Node& node, const TableName& name);

  /// Keys of a choice of `selector` that was not made: `word` was.
  void refuse_foreign(const Names& keys, const std::string& selector, const std::string& word,
                      const std::vector<std::string>& choices);
  /// Keys of other choices of `selector` than the `word` that was made; all keys of each choice are
  /// given. Where it is not known which was made, nothing is known of any of the keys.
  void refuse_of_others(const std::string& selector, const std::string& word,
                        const std::vector<std::pair<std::string, Names>>& choices);
  /// Keys that make sense only beside a section that is not given.
  void refuse_without(const std::string& owner, const Names& keys);
  /// Keys whose place the value at a path has taken.
  void refuse_beside(const std::string& path, const std::string& reason, const Names& keys);
  /// The number of the groups of keys that are given here; reports it if it should be one.
  std::size_t check_groups(const std::vector<Names>& groups);
  /// Says so if none of the keys is given.
  void check_any(const Names& keys, const char* suggestion);
  [[nodiscard]] const Entry* first_given(const Names& keys) const;

  const Node& table_;
  TableName name_;
  ReadContext& shared_;
  bool forgive_missing_ = false;  ///< while reading groups that exclude each other

 private:
  void nothing_given(const std::vector<Names>& groups);
  void needs(const std::vector<std::string>& ways, const char* suggestion = "");
  void refuse_choice(const std::string& key, const Node& node, const std::string& selector,
                     const std::string& word, const std::vector<std::string>& owners);
  [[nodiscard]] std::string instead_of(const std::string& key) const;

  std::vector<std::string> known_;
};

}  // namespace photic::scene
