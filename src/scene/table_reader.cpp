#include "scene/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "optics/table_text.hpp"
#include "scene/place_of_key.hpp"
#include "scene/suggest.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

std::vector<std::string> in_quotes(const std::vector<std::string>& keys) {
  std::vector<std::string> out;
  for (const std::string& key : keys) out.push_back(fmt::format("'{}'", key));
  return out;
}

}  // namespace

const Node* TableReader::look(const std::string& key) {
  known_.push_back(key);
  return table_.find(key);
}

TableName TableReader::inline_name(const std::string& key) const {
  return {path_of(key), below(name_.header, key), fmt::format("'{}'", key)};
}

TableName TableReader::section_name(const std::string& key, const char* open,
                                    const char* close) const {
  const std::string header = below(name_.header, key);
  return {path_of(key), header, open + header + close};
}

void TableReader::missing(const std::string& key, const char* meaning) {
  if (forgive_missing_) return;
  shared_.findings.add(path_of(key), table_.place,
                       fmt::format("'{}' is missing in {}", key, name_.label),
                       fmt::format("add it: {}", meaning));
}

void TableReader::section_missing(const TableName& section, const char* meaning) {
  Findings& findings = shared_.findings;
  const bool from_set = table_.place.line == 0;
  findings.add(section.path, from_set ? table_.place : findings.end(),
               section.label + " is missing", fmt::format("add it: {}", meaning));
}

void TableReader::refuse(const std::string& key, const Node& node, const Refusal& problem) {
  shared_.findings.add(path_of(key), node.place, fmt::format("'{}' {}", key, problem.reason),
                       problem.suggestion);
}

std::string TableReader::other_unit(const std::string& key, const Node& node,
                                    const std::function<bool(const Node&)>& is_good) {
  double given = 0;
  if (check(any_number, node, given)) return "";
  for (const OtherUnit& unit : other_units_of(key)) {
    // Rounded: 5.32e-7 m are 532 nm.
    const std::string meant = fmt::format("{:.9g}", unit(given));
    const auto value = optics::finite_number(meant);
    if (value && unit(given) <= unit.most && is_good(to_node(*value)))
      return fmt::format("did you mean {}? {} would be {}", meant, found_text(node), unit.name);
  }
  return "";
}

bool TableReader::is_table(const std::string& key, const Node& node, const TableName& name) {
  if (node.as<Node::Table>()) return true;
  refuse(key, node,
         {fmt::format("must be a table, not {}", found_text(node)),
          name.is_section() ? fmt::format("write {}", name.label) : "write { … }"});
  return false;
}

bool TableReader::is_tables(const std::string& key, const Node& node, const TableName& name) {
  const auto* array = node.as<Node::Array>();
  const bool good = array && !array->empty() &&
                    std::all_of(array->begin(), array->end(),
                                [](const Node& element) { return element.as<Node::Table>(); });
  if (!good)
    refuse(key, node,
           {fmt::format("must be one or more tables, not {}", found_text(node)),
            name.is_section() ? fmt::format("write {}", name.label) : "write [ { … }, { … } ]"});
  return good;
}

/// A suggestion of what to write in place of a key that is not known here.
std::string TableReader::instead_of(const std::string& key) const {
  if (const auto same = same_word(key, known_)) return *same;
  if (const auto place = place_of_key(key, name_.header)) return *place;
  return suggestion_for(key, known_, "known here");
}

void TableReader::finish() {
  for (const Entry& entry : *table_.as<Node::Table>()) {
    const auto in = [&](const std::vector<std::string>& keys) {
      return std::find(keys.begin(), keys.end(), entry.key) != keys.end();
    };
    if (in(known_)) continue;
    shared_.findings.add_at(entry.place,
                            fmt::format("unknown key '{}' in {}", entry.key, name_.label),
                            instead_of(entry.key));
  }
}

void TableReader::refuse_foreign(const Names& keys, const std::string& selector,
                                 const std::string& word, const std::vector<std::string>& choices) {
  std::vector<std::string> owners;
  for (const std::string& choice : choices) owners.push_back(quoted(choice));
  const bool chosen = !word.empty() && shared_.findings.good({path_of(selector)});
  for (const std::string& key : keys.all()) {
    const Node* node = look(key);
    if (node && chosen) refuse_choice(key, *node, selector, word, owners);
  }
}

void TableReader::refuse_choice(const std::string& key, const Node& node,
                                const std::string& selector, const std::string& word,
                                const std::vector<std::string>& owners) {
  refuse(key, node,
         {fmt::format("does not belong to {} = {}", selector, quoted(word)),
          fmt::format("it belongs to {}", joined(owners, "and"))});
}

void TableReader::refuse_of_others(const std::string& selector, const std::string& word,
                                   const std::vector<std::pair<std::string, Names>>& choices) {
  const bool chosen = shared_.findings.good({path_of(selector)});
  std::map<std::string, std::vector<std::string>> owners;
  for (const auto& [choice, keys] : choices)
    for (const std::string& key : keys.all()) owners[key].push_back(quoted(choice));
  for (const auto& [key, words] : owners) {
    if (std::ranges::find(known_, key) != known_.end()) continue;
    const Node* node = look(key);
    if (!chosen)
      shared_.findings.spoil(path_of(key));
    else if (node)
      refuse_choice(key, *node, selector, word, words);
  }
}

void TableReader::refuse_without(const std::string& owner, const Names& keys) {
  for (const std::string& key : keys.all()) {
    const Node* node = look(key);
    if (node && shared_.findings.good({path_of(owner)}))
      shared_.findings.add(path_of(key), node->place,
                           fmt::format("'{}' belongs to [[{}]], of which there is none", key,
                                       below(name_.header, owner)),
                           fmt::format("add one, or leave '{}' out", key));
  }
}

void TableReader::refuse_beside(const std::string& path, const std::string& reason,
                                const Names& keys) {
  for (const std::string& key : keys.all())
    if (const Node* node = look(key))
      shared_.findings.add(path_of(key), node->place,
                           fmt::format("'{}' and '{}' exclude each other: {}", key, path, reason),
                           "keep one of them");
}

const Entry* TableReader::first_given(const Names& keys) const {
  const auto* table = table_.as<Node::Table>();
  const auto entry = std::find_if(table->begin(), table->end(), [&](const Entry& e) {
    return std::find(keys.all().begin(), keys.all().end(), e.key) != keys.all().end();
  });
  return entry == table->end() ? nullptr : &*entry;
}

std::size_t TableReader::check_groups(const std::vector<Names>& groups) {
  std::vector<const Entry*> given;
  for (const Names& group : groups)
    if (const Entry* entry = first_given(group)) given.push_back(entry);
  if (given.empty()) nothing_given(groups);
  std::sort(given.begin(), given.end(),
            [](const Entry* a, const Entry* b) { return before(a->place, b->place); });
  for (std::size_t i = 1; i < given.size(); ++i) {
    shared_.findings.spoil(path_of(given[0]->key));
    shared_.findings.add(path_of(given[i]->key), given[i]->place,
                         fmt::format("'{}' and '{}' exclude each other in {}", given[0]->key,
                                     given[i]->key, name_.label),
                         "keep one of them");
  }
  return given.size();
}

void TableReader::nothing_given(const std::vector<Names>& groups) {
  std::vector<std::string> ways;
  for (const Names& group : groups) {
    if (group.needed().empty()) return;  // this group holds where nothing is given
    ways.push_back(fmt::format("{}", fmt::join(in_quotes(group.needed()), " + ")));
  }
  for (const Names& group : groups)
    for (const std::string& key : group.all()) shared_.findings.spoil(path_of(key));
  needs(ways);
}

void TableReader::check_any(const Names& keys, const char* suggestion) {
  if (first_given(keys)) return;
  for (const std::string& key : keys.all()) shared_.findings.spoil(path_of(key));
  needs(in_quotes(keys.all()), suggestion);
}

void TableReader::needs(const std::vector<std::string>& ways, const char* suggestion) {
  shared_.findings.add_at(table_.place, fmt::format("{} needs {}", name_.label, joined(ways, "or")),
                          suggestion);
}

}  // namespace photic::scene
