#include "io/table_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/utf8.hpp"

namespace photic::io {
namespace {

/// The place to cut a word that is too long: after a dot if it has one there, as paths do.
std::size_t end_of_line(const std::string& word, std::size_t width) {
  const std::size_t end = first_letters(word, width).size();
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

std::string place_heading(const tally::Result& result, double depth_m) {
  if (std::isnan(depth_m)) return "time [ns]";
  return result.gate_depth_is_range ? "range [m]" : "depth [m]";
}

TextColumn place_column(const tally::Result& result, const EchoRow& first, std::size_t gates,
                        std::size_t step) {
  const EchoRow* row = &first;
  TextColumn out{place_heading(result, first.depth_m), {}};
  for (std::size_t gate = 0; gate < gates; gate += step) {
    const double time_ns = (row[gate].time_start_ns + row[gate].time_end_ns) / 2;
    const double place = std::isnan(row[gate].depth_m) ? time_ns : row[gate].depth_m;
    const double shown = std::abs(place) < 0.005 ? 0.0 : place;  // not "-0.00"
    out.cells.push_back(fmt::format("{:>{}.2f}", shown, place_width));
  }
  return out;
}

std::string relative_error_text(double relative_error) {
  if (std::isnan(relative_error)) return "-";
  const double percent = 100 * relative_error;
  if (percent >= 1000) return "> 999 %";
  return fmt::format("{:.{}f} %", percent, percent < 1 ? 2 : percent < 10 ? 1 : 0);
}

std::string estimate_cell(double value, double relative_error, bool converged) {
  const std::string number = value == 0 ? "0" : fmt::format("{:.3e}", value);
  return fmt::format("{:>9} {:>7} {}", number, relative_error_text(relative_error),
                     converged ? ' ' : '*');
}

std::string estimate_heading(const std::string& above, const std::string& value) {
  std::string out;
  if (!above.empty())
    for (const std::string& line : wrapped(above, cell_width))
      out += line + std::string(cell_width - letters(line), ' ') + '\n';
  return out + fmt::format("{:>9} {:>7}  ", value, "error");
}

std::string legend(const std::vector<std::int32_t>& all_flags, const std::string& of,
                   std::size_t width) {
  std::string out;
  for (const auto& meaning : tally::flag_meanings()) {
    const auto count = std::ranges::count_if(
        all_flags, [&](std::int32_t flags) { return (flags & meaning.flag) != 0; });
    if (count > 0)
      out += paragraph(fmt::format("  {}, {} {}{}: {}", meaning.name, count, of,
                                   count == 1 ? "" : "s", meaning.explanation),
                       width, 4);
  }
  return out.empty() ? out : "* not converged, because\n" + out;
}

std::string legend(const std::vector<EchoRow>& rows, std::size_t width) {
  std::vector<std::int32_t> flags;
  for (const EchoRow& row : rows) flags.push_back(row.flags);
  return legend(flags, "gate", width);
}

std::string paragraph(const std::string& text, std::size_t width, std::size_t indent) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  if (letters(text) <= width) return text + '\n';
  std::string out;
  for (const std::string& line :
       wrapped(text, std::max(width, min_width) - std::max(first, indent)))
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
