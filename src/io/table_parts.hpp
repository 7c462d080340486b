// The parts that the tables for the terminal are made of.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/echo_rows.hpp"
#include "io/text_columns.hpp"

namespace photic::io {

/// Without blanks at the ends of lines.
std::string trimmed(const std::string& text);

/// Without ends of lines, for the head of a CSV file.
std::string one_line(std::string text);

/// The heading of the column of places: "depth [m]", "range [m]", or "time [ns]" where the
/// telescope has none.
std::string place_heading(const tally::Result& result, double depth_m);

/// The place of every `step`-th gate, from the row of the first on: `place_width` columns.
inline constexpr std::size_t place_width = 9;
TextColumn place_column(const tally::Result& result, const EchoRow& first, std::size_t gates,
                        std::size_t step);

/// Narrower lines than this are not made.
inline constexpr std::size_t min_width = 40;

/// Two digits of a percentage, as many as an error deserves; "-" of what is not a number.
std::string relative_error_text(double relative_error);

/// An estimate, its error over itself, and '*' where it has not converged: `cell_width` columns.
inline constexpr std::size_t cell_width = 19;  // "1.235e-08 > 999 % *"
std::string estimate_cell(double value, double relative_error, bool converged);

/// The heading of such a column: a text, which may be empty, above "echo   error" or another word.
std::string estimate_heading(const std::string& above, const std::string& value);

/// Each reason why some have not converged, with the number of them that it concerns; of: what each
/// is called, "gate".
std::string legend(const std::vector<std::int32_t>& flags, const std::string& of,
                   std::size_t width);
/// The same of gates.
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
