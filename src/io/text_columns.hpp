// Columns of numbers side by side, for the terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace photic::io {

/// A heading and the numbers below it.
struct TextColumn {
  std::string heading;
  std::vector<std::string> cells;
};

/// Some of the values, each in a format of fmt; "?" for what is not a number.
TextColumn text_column(const std::string& heading, const std::vector<double>& values,
                       std::size_t first, std::size_t count, const char* format);

/// Columns side by side, to the right in their widths.
std::string side_by_side(const std::vector<TextColumn>& columns);

/// A line of any length, broken; what follows the first is set back.
std::string set_back(const std::string& line);

}  // namespace photic::io
