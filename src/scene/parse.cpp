#include "scene/parse.hpp"

// toml++ 3.3 asserts (and in release builds of clang assumes) what broken texts such as "[=" do not
// keep to; the checks it has behind the assertions report them as syntax errors.
#undef NDEBUG
#define TOML_ASSERT(condition) static_assert(true)
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <functional>
#include <tuple>
#include <type_traits>

#include "core/error.hpp"
#include "scene/deep.hpp"
#include "scene/stray.hpp"

namespace photic::scene {
namespace {

using Placer = std::function<Place(const toml::source_region&)>;

Node convert(const toml::node& from, const Placer& place);

/// toml++ sorts keys by name; the scene keeps the order of the file.
Node::Table in_file_order(const toml::table& from, const Placer& place) {
  std::vector<std::pair<toml::source_position, Entry>> entries;
  for (const auto& [key, value] : from)
    entries.emplace_back(key.source().begin,
                         Entry{std::string(key.str()), place(key.source()), convert(value, place)});
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.line, a.first.column) < std::tie(b.first.line, b.first.column);
  });
  Node::Table table;
  for (auto& [position, entry] : entries) table.push_back(std::move(entry));
  return table;
}

Node convert(const toml::node& from, const Placer& place) {
  Node to;
  to.place = place(from.source());
  from.visit([&](const auto& n) {
    using Kind = std::decay_t<decltype(n)>;
    if constexpr (std::is_same_v<Kind, toml::table>) {
      to.value = in_file_order(n, place);
    } else if constexpr (std::is_same_v<Kind, toml::array>) {
      Node::Array array;
      for (const auto& element : n) array.push_back(convert(element, place));
      to.value = std::move(array);
    } else if constexpr (toml::is_chronological<Kind>) {
      to.value = Date{};
    } else {
      to.value = n.get();
    }
  });
  return to;
}

int as_int(toml::source_index index) { return static_cast<int>(index); }

std::optional<Node> sole_value(const std::string& toml_value, const Place& place) {
  const std::string text = "value = " + toml_value;
  if (find_stray_character(text) || find_deep_key(text)) return std::nullopt;
  try {
    const toml::table table = toml::parse(text);
    if (table.size() != 1) return std::nullopt;  // more keys were smuggled in behind a line break
    return convert(*table.get("value"), [&](const toml::source_region&) { return place; });
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

}  // namespace

Node parse_toml(const std::string& text, const std::string& file) {
  const auto place = [&](const toml::source_region& region) {
    return Place{file, as_int(region.begin.line), as_int(region.begin.column)};
  };
  // Also keeps toml++ 3.3 from looking at such characters: it is undefined what it does about them.
  if (const auto stray = find_stray_character(text))
    throw InputError(
        {{file, stray->line, stray->column,
          "this is not TOML: a character that is not ASCII is outside quotes and comments",
          "look for typographic quotes, dashes and spaces"}});
  if (const auto deep = find_deep_key(text))
    throw InputError({{file, deep->line, deep->column,
                       fmt::format("more than {} tables lie in each other here", max_depth),
                       "no scene needs that: look for dots"}});
  try {
    return convert(toml::parse(text), place);
  } catch (const toml::parse_error& error) {
    const Place at = place(error.source());
    throw InputError({{at.file, at.line, at.column,
                       "this is not TOML: " + std::string(error.description()), ""}});
  }
}

std::optional<Node> parse_value(const std::string& text, const Place& place) {
  if (auto value = sole_value(text, place)) return value;
  return sole_value(quoted(text), place);
}

}  // namespace photic::scene
