// A scene file as a tree of values that know where they stand. Keeps the order of the file.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/vec3.hpp"

namespace photic::scene {

/// The place where a value was written: a line and column of the file, or a --set (line 0).
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// A date or time of TOML: no key of a scene takes one.
struct Date {};

struct Entry;

struct Node {
  using Array = std::vector<Node>;
  using Table = std::vector<Entry>;

  std::variant<bool, std::int64_t, double, std::string, Date, Array, Table> value;
  Place place = {};
  bool section = false;  ///< written under a [header] of its own; an inline value otherwise

  /// The value as one of the kinds above, or null.
  template <class T>
  [[nodiscard]] const T* as() const {
    return std::get_if<T>(&value);
  }
  template <class T>
  [[nodiscard]] T* as() {
    return std::get_if<T>(&value);
  }

  /// The value of a key; null if this is no table or has no such key.
  [[nodiscard]] const Node* find(const std::string& key) const;
  [[nodiscard]] Node* find(const std::string& key);
  /// Adds a key to this table.
  Node& add(std::string key, Node child);
};

struct Entry {
  std::string key;
  Place place;  ///< of the key
  Node value;
};

/// A value as a node of the tree.
Node to_node(bool value);
Node to_node(double value);
Node to_node(std::int64_t value);
Node to_node(std::uint64_t value);
Node to_node(const char* value);
Node to_node(const std::string& value);
Node to_node(const Vec3<double>& value);
Node to_node(const std::vector<std::string>& value);
Node to_node(const std::vector<double>& value);
Node empty_table();

/// The name of this value in messages: `-0.4`, `text "abc"`, `[1, 2]`, `a table`, …
std::string found_text(const Node& node);

/// The shortest decimal that reads back to the same double, always recognisable as a float: 532.0,
/// 1e-05.
std::string number_text(double x);

/// The same without ".0", for messages.
std::string plain_number(double x);

/// Cut to a length that leaves a message readable.
std::string shortened(const std::string& text);

/// A string in quotes, escaped as both TOML and JSON read it.
std::string quoted(const std::string& text);

}  // namespace photic::scene
