// Columns of numbers side by side, for the terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace photic::io {

/// A heading, of one line or more, and what stands below it.
struct TextColumn {
  std::string heading;
  std::vector<std::string> cells;
  bool left = false;  ///< aligned to the left; numbers to the right
};

/// Some of the values, each in a format of fmt; "?" for what is not a number.
TextColumn text_column(const std::string& heading, const std::vector<double>& values,
                       std::size_t first, std::size_t count, const char* format);

/// Columns of as many cells side by side, as wide as they need, with blanks before each. Headings
/// end in one line. No blanks at the ends of lines.
std::string side_by_side(const std::vector<TextColumn>& columns, std::size_t blanks = 2);

/// A line of any length, broken; what follows the first is set back.
std::string set_back(const std::string& line);

}  // namespace photic::io
