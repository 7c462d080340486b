#include "io/text_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

std::string side_by_side(const std::vector<TextColumn>& columns) {
  std::string out;
  const auto add_line = [&](const auto& text_of) {
    for (const TextColumn& c : columns) {
      std::size_t wide = c.heading.size();
      for (const std::string& cell : c.cells) wide = std::max(wide, cell.size());
      out += fmt::format("  {:>{}}", text_of(c), wide);
    }
    out += '\n';
  };
  add_line([](const TextColumn& c) { return c.heading; });
  for (std::size_t i = 0; i < columns.front().cells.size(); ++i)
    add_line([i](const TextColumn& c) { return c.cells[i]; });
  return out;
}

std::string set_back(const std::string& line) {
  constexpr std::size_t width = 100;
  std::string out;
  for (const std::string& part : wrapped(line, width - 4))
    out += (out.empty() ? "  " : "    ") + part + '\n';
  return out;
}

}  // namespace photic::io
