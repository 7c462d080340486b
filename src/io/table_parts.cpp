#include "io/table_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace photic::io {
namespace {

/// Bytes of the first `count` letters of a text in UTF-8; of all if it has fewer.
std::size_t bytes_of(const std::string& text, std::size_t count) {
  std::size_t bytes = 0;
  const auto continues = [&] { return (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80; };
  while (bytes < text.size() && count-- > 0) {
    ++bytes;
    while (bytes < text.size() && continues()) ++bytes;
  }
  return bytes;
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// Where to cut a word that is too long: after a dot if it has one there, as paths do.
std::size_t end_of_line(const std::string& word, std::size_t width) {
  const std::size_t end = bytes_of(word, width);
  const std::size_t dot = word.rfind('.', end - 1);
  return dot == std::string::npos ? end : dot + 1;
}

}  // namespace

std::string trimmed(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') out.erase(out.find_last_not_of(' ') + 1);
    out += c;
  }
  return out;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

std::string place_text(const EchoRow& row) {
  const double time_ns = (row.time_start_ns + row.time_end_ns) / 2;
  return fmt::format("{:.2f}", std::isnan(row.depth_m) ? time_ns : row.depth_m);
}

std::string place_heading(const tally::Result& result, const EchoRow& row) {
  if (std::isnan(row.depth_m)) return "time [ns]";
  return result.gate_depth_is_range ? "range [m]" : "depth [m]";
}

std::string legend(const std::vector<EchoRow>& rows, std::size_t width) {
  std::string out;
  for (const auto& meaning : tally::flag_meanings()) {
    const auto count = std::count_if(rows.begin(), rows.end(), [&](const EchoRow& row) {
      return (row.flags & meaning.flag) != 0;
    });
    if (count > 0)
      out += paragraph(fmt::format("  {}, {} gate{}: {}", meaning.name, count,
                                   count == 1 ? "" : "s", meaning.explanation),
                       width, 4);
  }
  return out.empty() ? out : "* not converged, because\n" + out;
}

std::string paragraph(const std::string& text, std::size_t width, std::size_t indent) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  if (letters(text) <= width) return text + '\n';
  std::string out;
  for (const std::string& line :
       wrapped(text, std::max(width, least_width) - std::max(first, indent)))
    out += std::string(out.empty() ? first : indent, ' ') + line + '\n';
  return out;
}

std::string with_prefix(double number) {
  constexpr std::array<const char*, 6> prefixes{"", " k", " M", " G", " T", " P"};
  std::size_t k = 0;
  while (std::abs(number) >= 999.5 && k + 1 < prefixes.size()) {
    number /= 1000;
    ++k;
  }
  if (k == 0) return fmt::format("{:.3g}", number);
  return fmt::format("{:.{}f}{}", number, number < 9.995 ? 2 : number < 99.95 ? 1 : 0, prefixes[k]);
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && letters(lines.back()) + 1 + letters(word) > width)
      lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    while (letters(lines.back()) > width) {
      const std::size_t end = end_of_line(lines.back(), width);
      lines.push_back(lines.back().substr(end));
      lines[lines.size() - 2].resize(end);
    }
  }
  return lines;
}

}  // namespace photic::io
