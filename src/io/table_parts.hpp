// What the tables for the terminal are made of.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/echo_rows.hpp"

namespace photic::io {

/// Without blanks at the ends of lines.
std::string trimmed(const std::string& text);

/// Without ends of lines, for the head of a CSV file.
std::string one_line(std::string text);

/// Where a gate lies: its depth or range, or its time where the telescope has none; and what that
/// is called.
std::string place_text(const EchoRow& row);
std::string place_heading(const tally::Result& result, const EchoRow& row);

/// Narrower lines than this are not made.
inline constexpr std::size_t least_width = 40;

/// Each reason why gates have not converged, with the number of gates it concerns.
std::string legend(const std::vector<EchoRow>& rows, std::size_t width);

/// A text in lines of at most `width` letters, each with its newline; all but the first are set
/// back by `indent`. Blanks at its beginning are kept.
std::string paragraph(const std::string& text, std::size_t width, std::size_t indent = 2);

/// "4.00 M", "91.2 k", "512": three digits and a prefix of the SI.
std::string with_prefix(double number);

/// A text in lines of at most `width` letters, broken at blanks; a word that is longer is cut,
/// after a dot if it can be.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace photic::io
