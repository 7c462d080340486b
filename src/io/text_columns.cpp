#include "io/text_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/utf8.hpp"
#include "io/table_parts.hpp"

namespace photic::io {

TextColumn text_column(const std::string& heading, const std::vector<double>& values,
                       std::size_t first, std::size_t count, const char* format) {
  TextColumn out{heading, {}};
  for (std::size_t i = first; i < first + count; ++i) {
    std::string cell = std::isnan(values[i]) ? "?" : fmt::format(fmt::runtime(format), values[i]);
    if (cell.starts_with("-0.") && cell.find_first_of("123456789") == std::string::npos)
      cell.erase(0, 1);  // g of molecules is 0, but for rounding
    out.cells.push_back(std::move(cell));
  }
  return out;
}

namespace {

std::vector<std::string> lines_of(const std::string& heading) {
  std::vector<std::string> out(1);
  for (const char c : heading) {
    if (c == '\n')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

/// The lines of a column from the top of the highest heading down, all as wide.
std::vector<std::string> padded(const TextColumn& column, std::size_t heading_lines) {
  std::vector<std::string> lines = lines_of(column.heading);
  lines.insert(lines.begin(), heading_lines - lines.size(), "");
  lines.insert(lines.end(), column.cells.begin(), column.cells.end());
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, letters(line));
  for (std::string& line : lines)
    line.insert(column.left ? line.size() : 0, width - letters(line), ' ');
  return lines;
}

}  // namespace

std::string side_by_side(const std::vector<TextColumn>& columns, std::size_t blanks) {
  std::size_t heading_lines = 0;
  for (const TextColumn& c : columns)
    heading_lines = std::max(heading_lines, lines_of(c.heading).size());
  std::vector<std::string> lines(heading_lines + columns.front().cells.size());
  for (const TextColumn& c : columns) {
    const auto more = padded(c, heading_lines);
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += std::string(blanks, ' ') + more[i];
  }
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return trimmed(out);
}

std::string set_back(const std::string& line) {
  constexpr std::size_t width = 100;
  std::string out;
  for (const std::string& part : wrapped(line, width - 4))
    out += (out.empty() ? "  " : "    ") + part + '\n';
  return out;
}

}  // namespace photic::io
