#include "scene/stray.hpp"

#include <algorithm>
#include <string_view>

#include "core/utf8.hpp"

namespace photic::scene {
namespace {

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80U; }

}  // namespace

bool begins_free_text(char c) { return c == '#' || c == '"' || c == '\''; }

std::size_t end_of_free_text(std::string_view toml, std::size_t start) {
  const char open = toml[start];
  if (open == '#') return std::min(toml.find('\n', start), toml.size());
  const std::string three(3, open);
  const bool tall = toml.substr(start, 3) == three;
  const std::string_view close = std::string_view(three).substr(0, tall ? 3 : 1);
  for (std::size_t at = start + close.size(); at < toml.size(); ++at) {
    if (open == '"' && toml[at] == '\\')
      ++at;
    else if (toml.substr(at, close.size()) == close)
      return at + close.size();
    else if (!tall && toml[at] == '\n')
      return at;
  }
  return toml.size();
}

LineColumn place_of(std::string_view toml, std::size_t position) {
  LineColumn place;
  for (const char c : toml.substr(0, position)) {
    if (c == '\n')
      place = {place.line + 1, 1};
    else if (!continues_letter(c))
      ++place.column;
  }
  return place;
}

std::optional<LineColumn> find_stray_character(const std::string& toml) {
  std::size_t at = toml.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0;
  while (at < toml.size()) {
    if (!is_ascii(toml[at])) return place_of(toml, at);
    at = begins_free_text(toml[at]) ? end_of_free_text(toml, at) : at + 1;
  }
  return std::nullopt;
}

}  // namespace photic::scene
