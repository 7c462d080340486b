#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scene/rules.hpp"
#include "scene/suggest.hpp"

namespace photic::scene {
namespace {

Refusal refusal(const std::string& requirement, const Node& node, std::string suggestion = "") {
  return {fmt::format("must be {}, not {}", requirement, found_text(node)), std::move(suggestion)};
}

/// A float, or a whole number in its place.
std::optional<double> finite_number(const Node& node) {
  if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
  const auto* number = node.as<double>();
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return *number;
}

std::string requirement_of(const Number& rule) {
  std::vector<std::string> bounds;
  if (std::isfinite(rule.low))
    bounds.push_back((rule.low_open ? "greater than " : "at least ") + plain_number(rule.low));
  if (std::isfinite(rule.high))
    bounds.push_back((rule.high_open ? "less than " : "at most ") + plain_number(rule.high));
  return bounds.empty() ? "a finite number"
                        : fmt::format("a finite number, {}", joined(bounds, "and"));
}

std::string requirement_of(const Count& rule) {
  if (rule.high == std::numeric_limits<std::int64_t>::max())
    return fmt::format("a whole number, at least {} and below 2^63", rule.low);
  return fmt::format("a whole number from {} to {}", rule.low, rule.high);
}

std::optional<std::int64_t> whole_number(const Node& node) {
  if (const auto* integer = node.as<std::int64_t>()) return *integer;
  const auto* number = node.as<double>();
  constexpr double limit = 9223372036854775808.0;  // 2^63
  if (!number || !(std::fabs(*number) < limit) || *number != std::floor(*number))
    return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

std::optional<Vec3<double>> finite_vector(const Node& node) {
  const auto* array = node.as<Node::Array>();
  if (!array || array->size() != 3) return std::nullopt;
  const auto x = finite_number((*array)[0]);
  const auto y = finite_number((*array)[1]);
  const auto z = finite_number((*array)[2]);
  if (!x || !y || !z) return std::nullopt;
  return Vec3<double>{*x, *y, *z};
}

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7F'; });
}

}  // namespace

std::optional<Refusal> check(const Number& rule, const Node& node, double& value) {
  const auto x = finite_number(node);
  const bool inside = x && (rule.low_open ? *x > rule.low : *x >= rule.low) &&
                      (rule.high_open ? *x < rule.high : *x <= rule.high);
  if (!inside) return refusal(requirement_of(rule), node, rule.advice);
  value = *x;
  return std::nullopt;
}

std::optional<Refusal> check(const Wavelength&, const Node& node, double& value) {
  if (auto problem = check(positive, node, value)) return problem;
  if (value >= Wavelength::shortest_nm) return std::nullopt;
  return Refusal{fmt::format("must be at least {} nm, not {}",
                             plain_number(Wavelength::shortest_nm), found_text(node)),
                 ""};
}

std::optional<Refusal> check(const Count& rule, const Node& node, std::int64_t& value) {
  const auto n = whole_number(node);
  if (!n || *n < rule.low || *n > rule.high) return refusal(requirement_of(rule), node);
  value = *n;
  return std::nullopt;
}

std::optional<Refusal> check(const YesOrNo&, const Node& node, bool& value) {
  const auto* given = node.as<bool>();
  if (!given) return refusal("true or false", node);
  value = *given;
  return std::nullopt;
}

std::optional<Refusal> check(const Numbers&, const Node& node, std::vector<double>& value) {
  const auto* array = node.as<Node::Array>();
  const bool good = array && array->size() >= 2 &&
                    std::all_of(array->begin(), array->end(),
                                [](const Node& x) { return finite_number(x).has_value(); });
  if (!good) return refusal("two or more finite numbers [a, b, …]", node);
  for (const Node& x : *array) value.push_back(*finite_number(x));
  return std::nullopt;
}

std::optional<Refusal> check(const Choice& rule, const Node& node, std::string& value) {
  const auto* word = node.as<std::string>();
  std::vector<std::string> known;
  for (const Word& w : rule.words) known.push_back(w.word);
  if (!word || std::ranges::find(known, *word) == known.end()) {
    std::vector<std::string> words;
    for (const std::string& w : known) words.push_back(quoted(w));
    std::string suggestion = word ? suggestion_for(*word, known, "choose from") : "";
    for (const Word& other : rule.instead)
      if (word && other.word == *word) suggestion = "write " + other.meaning;
    return refusal(joined(words, "or"), node, suggestion);
  }
  value = *word;
  return std::nullopt;
}

std::optional<Refusal> check(const Text& rule, const Node& node, std::string& value) {
  const auto* text = node.as<std::string>();
  if (!text || has_control_character(*text))
    return refusal("one line of text", node, text ? "" : "put it in quotes");
  if (text->empty() && !rule.may_be_empty) return Refusal{"must not be empty", ""};
  value = *text;
  return std::nullopt;
}

std::optional<Refusal> check(const File&, const Node& node, std::string& value,
                             const std::optional<std::string>& folder) {
  if (!folder) return Refusal{"must not name a file here", ""};
  if (auto problem = check(Text{}, node, value)) return problem;
  namespace fs = std::filesystem;
  std::error_code failure;
  const fs::path path = fs::absolute(fs::path(*folder) / value, failure).lexically_normal();
  if (optics::is_no_regular_file(path))
    return Refusal{fmt::format("names no regular file: {}", path.string()),
                   optics::files_are_regular};
  const bool readable = !failure && ::access(path.c_str(), R_OK) == 0;
  if (!readable)
    return Refusal{fmt::format("names a file that cannot be read: {}", path.string()),
                   "a relative path starts at the scene file"};
  value = path.string();
  return std::nullopt;
}

std::optional<Refusal> check(const ColumnOfFile&, const Node& node, optics::ColumnInFile& value) {
  if (node.as<std::string>()) return check(Text{}, node, value.name);
  if (check(Count{}, node, value.number))
    return refusal("the name of a column, or its number from 1 on", node);
  return std::nullopt;
}

std::vector<std::string> NumberOrTable::depends_on() const {
  std::vector<std::string> columns;
  for (const TableOrFile::Column& column : table.columns)
    if (column.may_lack) columns.emplace_back(column.name);
  return columns;
}

std::optional<Refusal> check(const Position&, const Node& node, Vec3<double>& value) {
  const auto v = finite_vector(node);
  if (!v) return refusal("three finite numbers [x, y, z]", node);
  value = *v;
  return std::nullopt;
}

std::optional<Refusal> check(const Direction&, const Node& node, Vec3<double>& value) {
  const auto v = finite_vector(node);
  // Also refuses what is too short or too long to be normalised in doubles.
  if (!v || !std::isnormal(dot(*v, *v)))
    return refusal("three finite numbers [x, y, z] that are not all 0", node);
  value = *v;
  return std::nullopt;
}

}  // namespace photic::scene
