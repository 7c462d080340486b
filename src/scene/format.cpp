#include "scene/format.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "scene/findings.hpp"

namespace photic::scene {
namespace {

/// A boolean, number or text; empty for a table or an array.
std::string scalar_text(const Node& node) {
  if (const auto* b = node.as<bool>()) return *b ? "true" : "false";
  if (const auto* i = node.as<std::int64_t>()) return fmt::format("{}", *i);
  if (const auto* x = node.as<double>()) return number_text(*x);
  if (const auto* s = node.as<std::string>()) return quoted(*s);
  expect(!node.as<Date>(), "nobody writes dates");
  return "";
}

/// A key as TOML has it: bare where that is enough.
std::string key_toml(const std::string& key) {
  const auto bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), bare) ? key : quoted(key);
}

bool holds_tables(const Node::Array& array) {
  return std::any_of(array.begin(), array.end(),
                     [](const Node& element) { return element.as<Node::Table>(); });
}

/// A long array of numbers stands on one line or on several, which TOML allows within inline
/// tables, too.
enum class Lines { one, several };

std::string inline_toml(const Node& node, Lines lines);

std::string inline_array(const Node::Array& array, const std::string& separator, Lines lines) {
  std::string inside;
  for (const Node& element : array)
    inside += (inside.empty() ? "" : separator) + inline_toml(element, lines);
  return inside;
}

/// Ten numbers a line.
std::string column_toml(const Node::Array& array) {
  constexpr std::size_t in_a_line = 10;
  std::string out = "[";
  for (std::size_t i = 0; i < array.size(); ++i)
    out += (i % in_a_line == 0 ? "\n    " : " ") + inline_toml(array[i], Lines::one) + ',';
  return out + "\n  ]";
}

bool is_column(const Node::Array& array) {
  constexpr std::size_t longest_line = 12;
  return array.size() > longest_line &&
         std::ranges::all_of(array, [](const Node& element) { return element.as<double>(); });
}

/// The value of a key: an array of several tables takes a line for each.
std::string value_toml(const Node& node) {
  const auto* array = node.as<Node::Array>();
  if (!array || array->size() < 2 || !holds_tables(*array))
    return inline_toml(node, Lines::several);
  return fmt::format("[\n  {},\n]", inline_array(*array, ",\n  ", Lines::several));
}

std::string inline_toml(const Node& node, Lines lines) {
  if (const auto* array = node.as<Node::Array>()) {
    if (lines == Lines::several && is_column(*array)) return column_toml(*array);
    return fmt::format("[{}]", inline_array(*array, ", ", lines));
  }
  const auto* table = node.as<Node::Table>();
  if (!table) return scalar_text(node);
  std::string inside;
  for (const Entry& entry : *table)
    inside += (inside.empty() ? "" : ", ") +
              fmt::format("{} = {}", key_toml(entry.key), inline_toml(entry.value, lines));
  return table->empty() ? "{}" : fmt::format("{{ {} }}", inside);
}

void write_table(const Node& table, const std::string& header, std::string& out) {
  const auto& entries = std::get<Node::Table>(table.value);
  for (const Entry& entry : entries)
    if (!entry.value.section)
      out += fmt::format("{} = {}\n", key_toml(entry.key), value_toml(entry.value));
  for (const Entry& entry : entries) {
    if (!entry.value.section) continue;
    const std::string path = below(header, key_toml(entry.key));
    if (const auto* array = entry.value.as<Node::Array>()) {
      for (const Node& element : *array) {
        out += fmt::format("\n[[{}]]\n", path);
        write_table(element, path, out);
      }
    } else {
      out += fmt::format("\n[{}]\n", path);
      write_table(entry.value, path, out);
    }
  }
}

}  // namespace

std::string format_toml(const Node& table) {
  std::string out;
  write_table(table, "", out);
  return out;
}

std::string format_value(const Node& node) { return inline_toml(node, Lines::one); }

}  // namespace photic::scene
