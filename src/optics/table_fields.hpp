// Lines of a table as fields: what separates them, quotes, and which of them are numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace photic::optics {

struct TableCell {
  std::string text;
  int column = 0;  ///< its start, from 1
  int line = 0;    ///< 0: that of its row
};
using TableCells = std::vector<TableCell>;

/// The separators of fields. A blank stands for any number of blanks and tabs, around
/// which there is no field.
inline constexpr char comma = ',', semicolon = ';', tab = '\t', blank = ' ';
inline constexpr char separators[] = {comma, semicolon, tab, blank};

/// "comma", "semicolon", "tab" or "blank".
const char* name_of(char separator);

/// Without blanks and tabs around it.
std::string trimmed(const std::string& text);

/// Returns whether a trimmed line is a comment: after #, in quotes as spreadsheets write it, or
/// after !.
bool is_comment(const std::string& content);

/// Between the double quotes from `at` on, which is then behind them. Throws InputError where they
/// are not closed; `number` is that of the line, `name` the file's.
std::string quoted_text(const std::string& line, std::size_t& at, const std::string& name,
                        int number);

/// Throws InputError for quotes that are none.
TableCells fields_of(const std::string& line, char separator, const std::string& name, int number);

/// Returns nothing for a line with quotes that are none.
std::optional<TableCells> fields_if_any(const std::string& line, char separator);

/// Counts a letter outside quotes.
std::size_t count_outside_quotes(const std::string& line, char letter);

/// Returns whether it is a number between such separators: decimal commas are none between commas.
bool is_number(const std::string& text, char separator);

/// Returns whether all fields are numbers, or at least one of them and the others gaps.
bool are_numbers(const TableCells& fields, char separator);
bool are_numbers_or_gaps(const TableCells& fields, char separator);

/// The part of a field or of a column's name that a message shows: its beginning, in letters that a
/// terminal prints.
std::string shown(const std::string& text);

}  // namespace photic::optics
