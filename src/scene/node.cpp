#include "scene/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/utf8.hpp"

namespace photic::scene {
namespace {

template <class... F>
struct Match : F... {
  using F::operator()...;
};
template <class... F>
Match(F...) -> Match<F...>;

bool is_scalar(const Node& node) {
  return !node.as<Node::Array>() && !node.as<Node::Table>() && !node.as<Date>();
}

std::string short_array(const Node::Array& array) {
  if (array.size() > 4 || !std::all_of(array.begin(), array.end(), is_scalar))
    return fmt::format("an array of {}", array.size());
  std::string inside;
  for (const Node& element : array) inside += (inside.empty() ? "" : ", ") + found_text(element);
  return fmt::format("[{}]", inside);
}

}  // namespace

const Node* Node::find(const std::string& key) const {
  const Table* table = as<Table>();
  if (!table) return nullptr;
  const auto entry =
      std::find_if(table->begin(), table->end(), [&](const Entry& e) { return e.key == key; });
  return entry == table->end() ? nullptr : &entry->value;
}

Node* Node::find(const std::string& key) {
  return const_cast<Node*>(std::as_const(*this).find(key));
}

Node& Node::add(std::string key, Node child) {
  Table& table = std::get<Table>(value);
  const Place where = child.place;
  return table.emplace_back(Entry{std::move(key), where, std::move(child)}).value;
}

std::string found_text(const Node& node) {
  return std::visit(
      Match{[](bool b) -> std::string { return b ? "true" : "false"; },
            [](std::int64_t i) { return fmt::format("{}", i); },
            [](double x) { return plain_number(x); },
            [](const std::string& s) { return fmt::format("text {}", quoted(shortened(s))); },
            [](const Date&) -> std::string { return "a date"; },
            [](const Node::Array& array) { return short_array(array); },
            [](const Node::Table&) -> std::string { return "a table"; }},
      node.value);
}

std::string plain_number(double x) {
  if (std::isnan(x)) return "nan";
  return fmt::format("{}", x);
}

std::string number_text(double x) {
  std::string text = plain_number(x);
  if (text.find_first_of(".eni") == std::string::npos) text += ".0";
  return text;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 40;
  return letters(text) <= longest ? text : std::string(first_letters(text, longest)) + "…";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20U || byte == 0x7FU) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

Node to_node(bool value) { return {.value = value}; }
Node to_node(double value) { return {.value = value}; }
Node to_node(std::int64_t value) { return {.value = value}; }
Node to_node(std::uint64_t value) {
  expect(value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()),
         "counts of a scene are below 2^63");
  return to_node(static_cast<std::int64_t>(value));
}
Node to_node(const char* value) { return {.value = std::string(value)}; }
Node to_node(const std::string& value) { return {.value = value}; }

Node to_node(const Vec3<double>& value) {
  return {.value = Node::Array{to_node(value.x), to_node(value.y), to_node(value.z)}};
}

Node to_node(const std::vector<std::string>& value) {
  Node::Array array;
  for (const std::string& text : value) array.push_back(to_node(text));
  return {.value = std::move(array)};
}

Node to_node(const std::vector<double>& value) {
  Node::Array array;
  for (const double x : value) array.push_back(to_node(x));
  return {.value = std::move(array)};
}

Node empty_table() { return {.value = Node::Table{}}; }

}  // namespace photic::scene
