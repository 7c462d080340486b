#include "scene/override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "scene/deep.hpp"
#include "scene/parse.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {
namespace {

std::optional<std::size_t> number(const std::string& key) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
  if (error == std::errc::invalid_argument || end != key.data() + key.size()) return std::nullopt;
  return error == std::errc() ? index : static_cast<std::size_t>(-1);
}

std::optional<std::size_t> named(const Node::Array& array, const std::string& name) {
  for (std::size_t i = 0; i < array.size(); ++i) {
    const Node* given = array[i].find("name");
    if (given && given->as<std::string>() && *given->as<std::string>() == name) return i;
  }
  return std::nullopt;
}

/// The place in an array to which a number or a name leads, there or not; none for a name that
/// nothing has.
std::optional<std::size_t> place_in(const Node::Array& array, const std::string& key) {
  const auto index = number(key);
  return index ? index : named(array, key);
}

/// One change on its way down the document.
class Assignment {
 public:
  Assignment(Place place, Findings& findings) : place_(std::move(place)), findings_(findings) {}

  /// Returns the path by numbers; nothing where it is refused.
  std::optional<std::string> apply(Node& document, const std::vector<std::string>& keys,
                                   Node value) {
    Node* node = &document;
    std::string path;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const bool last = i + 1 == keys.size();
      Node* next = step(*node, keys[i], i == 0 ? "the scene" : fmt::format("'{}'", keys[i - 1]));
      if (!next) return std::nullopt;
      const auto* array = node->as<Node::Array>();
      path = array ? below(path, static_cast<std::size_t>(next - array->data()))
                   : below(path, keys[i]);
      if (last) {
        // A vector that had one of its numbers replaced is no longer what the file says.
        if (array && !next->as<Node::Table>()) node->place = place_;
        *next = std::move(value);
        return path;
      }
      node = next;
    }
    return std::nullopt;
  }

  void refuse(std::string reason, std::string suggestion) {
    findings_.add_at(place_, std::move(reason), std::move(suggestion));
  }

 private:
  Node* step(Node& node, const std::string& key, const std::string& parent) {
    if (node.as<Node::Table>()) return member(node, key);
    if (auto* array = node.as<Node::Array>()) return element(*array, key, parent);
    refuse(fmt::format("{} is {}: there is no '{}' in it", parent, found_text(node), key), "");
    return nullptr;
  }

  /// The value of a key; a missing one is created.
  Node* member(Node& table, const std::string& key) {
    for (Entry& entry : *table.as<Node::Table>()) {
      if (entry.key == key) return &entry.value;
    }
    Node created = empty_table();
    created.place = place_;
    return &table.add(key, std::move(created));
  }

  Node* element(Node::Array& array, const std::string& key, const std::string& parent) {
    const std::optional<std::size_t> index = place_in(array, key);
    if (index && *index < array.size()) return &array[*index];
    if (index)
      refuse(fmt::format("there is no element {} in {}", key, parent),
             fmt::format("it has {}, counted from 0", array.size()));
    else
      refuse(fmt::format("nothing in {} is called '{}'", parent, key),
             suggestion_for(key, names_in(array), "its names and numbers"));
    return nullptr;
  }

  static std::vector<std::string> names_in(const Node::Array& array) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < array.size(); ++i) {
      const Node* given = array[i].find("name");
      names.push_back(given && given->as<std::string>() ? *given->as<std::string>()
                                                        : std::to_string(i));
    }
    return names;
  }

  Place place_;
  Findings& findings_;
};

/// Joins a path that is one key as a whole: "environment.0.set.sea.layer.0.name",
/// "environment_grid.sea.…".
void join_changed_path(std::vector<std::string>& keys) {
  const bool in_grid = keys[0] == "environment_grid";
  const bool in_set = keys.size() > 2 && keys[0] == "environment" && keys[2] == "set";
  const std::size_t first = in_grid ? 1 : 3;
  if (keys.size() <= first || !(in_grid || in_set)) return;
  for (std::size_t i = first + 1; i < keys.size(); ++i) keys[first] = below(keys[first], keys[i]);
  keys.resize(first + 1);
}

/// The keys of a path: none of them is empty if it can lead anywhere.
std::vector<std::string> keys_of(const std::string& path) {
  std::vector<std::string> keys(1);
  for (const char c : path) {
    if (c == '.')
      keys.emplace_back();
    else
      keys.back() += c;
  }
  join_changed_path(keys);
  return keys;
}

/// `Value`: a Node, or a const one.
template <class Value>
Value* child_of(Value& node, const std::string& key) {
  auto* array = node.template as<Node::Array>();
  if (!array) return node.find(key);
  const auto index = place_in(*array, key);
  return index && *index < array->size() ? &(*array)[*index] : nullptr;
}

/// The place to which a path leads in a document, where it has one, and in the scene read from it.
struct InBoth {
  const Node* given;
  const Node* whole;
  std::string key = {};            ///< that leads there, a number for an element
  bool is_one_of_several = false;  ///< an element of the scene beside others from the same one

  /// `counts`: how many elements each has become, if this is a list; null: one.
  [[nodiscard]] std::optional<InBoth> below(const std::string& next,
                                            const std::vector<std::size_t>* counts) const {
    if (given && given->as<Node::Array>()) return element(next, counts);
    const Node* in_whole = child_of(*whole, next);
    if (!in_whole) return std::nullopt;
    return InBoth{given ? given->find(next) : nullptr, in_whole, next};
  }

 private:
  [[nodiscard]] std::optional<InBoth> element(const std::string& name,
                                              const std::vector<std::size_t>* counts) const {
    const auto& list = *given->as<Node::Array>();
    const auto* all = whole->as<Node::Array>();
    const auto asked = place_in(list, name);
    std::size_t first = 0;
    for (std::size_t i = 0; all && i < list.size() && first < all->size(); ++i) {
      const Node& here = (*all)[first];
      const std::size_t count = counts ? (*counts)[i] : 1;
      const Node* by_default = list[i].find("name") ? nullptr : here.find("name");
      const bool is_called =
          by_default && by_default->as<std::string>() && *by_default->as<std::string>() == name;
      if (asked ? *asked == i : is_called)
        return InBoth{&list[i], &here, std::to_string(i), count > 1};
      first += count;
    }
    return std::nullopt;
  }
};

/// A name by default without the number that it has among its cuts: "layer1.0" -> "layer1".
Node without_number(Node name) {
  auto& text = *name.as<std::string>();
  text.resize(text.rfind('.'));
  return name;
}

void erase_child(Node& node, const std::string& key) {
  if (auto* array = node.as<Node::Array>())
    array->erase(array->begin() + static_cast<std::ptrdiff_t>(*place_in(*array, key)));
  else
    std::erase_if(*node.as<Node::Table>(), [&](const Entry& entry) { return entry.key == key; });
}

}  // namespace

const Node* find(const std::string& path, const Node& document) {
  const Node* node = &document;
  for (const std::string& key : keys_of(path)) {
    node = child_of(*node, key);
    if (!node) return nullptr;
  }
  return node;
}

std::optional<Node> find_default(const std::string& path, const Node& given, const Node& whole,
                                 const Multiples& multiples) {
  const std::vector<std::string> keys = keys_of(path);
  if (keys.size() > 3 && keys[0] == "environment" && keys[2] == "set") return std::nullopt;
  InBoth here{&given, &whole};
  std::string at;
  for (const std::string& key : keys) {
    const bool is_name = here.is_one_of_several && key == "name";
    const auto counts = multiples.find(at);
    const auto next = here.below(key, counts == multiples.end() ? nullptr : &counts->second);
    if (!next) return std::nullopt;
    if (is_name && !next->given) return without_number(*next->whole);
    at = below(at, next->key);
    here = *next;
  }
  return *here.whole;
}

void take_away(const std::string& path, const Place& place, Node& document, Findings& findings) {
  Node* node = &document;
  const std::vector<std::string> keys = keys_of(path);
  for (const std::string& key : keys) {
    Node* next = child_of(*node, key);
    if (!next) return findings.add_at(place, fmt::format("there is no '{}' to take away", key), "");
    if (&key == &keys.back()) return erase_child(*node, key);
    node = next;
  }
}

std::optional<std::string> assign(const std::string& path, Node value, const Place& place,
                                  Node& document, Findings& findings) {
  const std::vector<std::string> keys = keys_of(path);
  if (keys.size() > max_depth) {
    findings.add_at({shortened(place.file), place.line, place.column},
                    fmt::format("the path has {} parts", keys.size()),
                    fmt::format("at most {} are possible", max_depth));
    return std::nullopt;
  }
  Assignment assignment(place, findings);
  if (std::find(keys.begin(), keys.end(), "") != keys.end()) {
    assignment.refuse("there is an empty name in the path",
                      "write names and numbers with dots between");
    return std::nullopt;
  }
  return assignment.apply(document, keys, std::move(value));
}

std::vector<std::string> make_changes(const std::vector<Change>& changes, Node& document,
                                      Findings& findings) {
  std::vector<std::string> paths;
  for (const Change& change : changes) {
    auto value = parse_value(change.value, {});
    if (!value) continue;
    if (auto path = assign(change.path, std::move(*value), {}, document, findings))
      paths.push_back(std::move(*path));
  }
  return paths;
}

void apply_override(const std::string& override_text, Node& document, Findings& findings) {
  const std::size_t equals = override_text.find('=');
  const std::string path = override_text.substr(0, equals);
  const Place place{"--set " + path, 0, 0};
  if (equals == std::string::npos)
    return findings.add_at(place, "there is no value", "write path=value");
  const auto value = parse_value(override_text.substr(equals + 1), place);
  if (!value) return findings.add_at(place, "the value is not UTF-8 text", "");
  assign(path, *value, place, document, findings);
}

}  // namespace photic::scene
