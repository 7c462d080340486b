// The text of a table as other programs write it, on the way to cells and numbers: encodings, ends
// of lines, decimal commas, and faults that most lines have.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace photic::optics {

/// The lines of a text, ended by \n, \r\n or \r alone, in UTF-8: read from UTF-8 or UTF-16 with its
/// mark, from Latin-1 if it is no UTF-8. Throws InputError, one line, for what is no text.
std::vector<std::string> lines_of_table(const std::string& bytes, const std::string& name);

/// Throws those of `found`, if there are any, as an InputError: one for all where most of so many
/// lines have them, and 20 at most.
void raise_together(std::vector<Diagnostic> found, std::size_t lines);

/// The message on a file without a line of numbers, and the suggestion.
inline constexpr const char* no_numbers = "no table of numbers";
inline constexpr const char* what_a_table_is =
    "a table has rows of numbers, between commas, semicolons, tabs or blanks";
/// Throws the InputError that says so, and nothing else, at the place of what was found.
[[noreturn]] void raise_without_numbers(const Diagnostic& found);

/// The number that a whole text is, with a plus or a minus before it or none.
std::optional<double> finite_number(const std::string& text);

/// The same of a number that holds one decimal comma and no point.
std::optional<double> number_with_comma(const std::string& text);

/// Returns whether its decimal point (a number that finite_number reads) is written.
bool has_decimal_point(const std::string& text);

/// Returns whether a number with a decimal comma may as well be one of thousands: 1,234 but not
/// 0,123.
bool may_be_thousands(const std::string& text);

/// Half a unit of the last digit of a number as it is written.
double half_last_digit(const std::string& text);

/// Returns whether nothing stands there, or what programs write for what is not known: nan, NaN,
/// -nan, NA.
bool is_gap(const std::string& text);

/// A hint for a place where a number is expected; may be empty.
std::string how_to_write_number(const std::string& text);

}  // namespace photic::optics
