#include <fmt/format.h>

#include <algorithm>

#include "optics/data_table.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {
namespace {

constexpr const char* separators = ",;\t";

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

const char* name_of(char separator) {
  return separator == ',' ? "comma" : separator == ';' ? "semicolon" : "tab";
}

std::size_t count_outside_quotes(const std::string& line, char letter) {
  bool quoted = false;
  std::size_t count = 0;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == letter && !quoted) ++count;
  }
  return count;
}

/// Those that the line of names has, the one of the first row among several.
std::string possible_separators(const std::string& names, const std::string& row) {
  std::string in_names, alike;
  for (const char* s = separators; *s != '\0'; ++s) {
    const std::size_t count = count_outside_quotes(names, *s);
    if (count == 0) continue;
    in_names += *s;
    if (count == count_outside_quotes(row, *s)) alike += *s;
  }
  return in_names.size() > 1 && !alike.empty() ? alike : in_names;
}

}  // namespace

/// What is left to read.
struct DataTable::Lines {
  std::vector<std::string> text;
  std::size_t next = 0;

  [[nodiscard]] bool any() const { return next < text.size(); }
  /// Numbers of lines begin with 1.
  [[nodiscard]] int number() const { return static_cast<int>(next) + 1; }
  /// Without what is no row.
  [[nodiscard]] std::string first_row(std::size_t from) const {
    const auto row = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(),
                                  [](const std::string& line) {
                                    const std::string content = trimmed(line);
                                    return !content.empty() && content.front() != '#';
                                  });
    return row == text.end() ? "" : *row;
  }
};

DataTable DataTable::parse(const std::string& text, const std::string& name) {
  DataTable table;
  table.name_ = name;
  Lines lines{lines_of_table(text, name)};
  table.read_head(lines);
  table.read_rows(lines);
  if (table.cells_.empty())
    table.fail_at(std::max<int>(1, static_cast<int>(lines.text.size())), 1, "has no rows of data");
  table.leave_out_unnamed_columns();
  table.look_for_decimal_marks();
  return table;
}

void DataTable::read_head(Lines& lines) {
  std::string told;
  for (; lines.any() && columns_.empty(); ++lines.next) {
    const std::string& line = lines.text[lines.next];
    const std::string content = trimmed(line);
    if (content.empty()) continue;
    if (content.starts_with("#") || content.starts_with("\"#")) {
      add_comment(content, lines.number());
    } else if (line.size() == 5 && line.starts_with("sep=")) {  // as Excel writes it
      told = line.substr(4);
    } else {
      if (told.empty()) told = possible_separators(line, lines.first_row(lines.next + 1));
      if (told.size() > 1)
        fail_at(lines.number(), 1,
                fmt::format("are columns separated by a {} or by a {}?", name_of(told[0]),
                            name_of(told[1])),
                "put names that hold the other one in double quotes");
      if (!told.empty()) separator_ = told.front();
      for (const Cell& cell : split(line, lines.number())) columns_.push_back(cell.text);
      column_line_ = lines.number();
    }
  }
}

void DataTable::read_rows(Lines& lines) {
  std::vector<Diagnostic> found;
  std::size_t rows = 0;
  for (; lines.any(); ++lines.next) {
    const std::string content = trimmed(lines.text[lines.next]);
    if (content.empty()) continue;
    if (content.starts_with("#") || content.starts_with("\"#")) {
      add_comment(content, lines.number());
      continue;
    }
    ++rows;
    try {
      add_row(split(lines.text[lines.next], lines.number()), lines.number());
    } catch (const InputError& error) {
      found.insert(found.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  raise_together(std::move(found), rows);
}

void DataTable::add_comment(const std::string& content, int number) {
  std::size_t at = 0;
  std::string text = content.front() == '"' ? quoted_text(content, at, number) : content;
  // Spreadsheets fill up every line to the same number of columns.
  text.erase(std::min(text.find_last_not_of(" \t,;") + 1, text.size()));
  const auto colon = text.find(':');
  if (colon != std::string::npos)
    headers_.emplace(trimmed(text.substr(1, colon - 1)),
                     Header{trimmed(text.substr(colon + 1)), number});
}

std::string DataTable::how_to_separate(const Cells& row) const {
  const char* separator = name_of(separator_);
  if (row.size() < columns_.size())
    return fmt::format("separate them by {}s, as the names are", separator);
  if (row.size() == columns_.size() + 1 && row.back().text.empty())
    return fmt::format("end the line of names with a {}, too", separator);
  return fmt::format("{}a text with a {} needs double quotes",
                     separator_ == ',' ? "a number needs a decimal point, " : "", separator);
}

void DataTable::add_row(Cells cells, int number) {
  const bool gaps =
      std::all_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.text.empty(); });
  if (gaps && cells.size() > 1) return;
  const std::size_t named = columns_.size();
  if (cells.size() != named)
    fail_at(number, 1, fmt::format("{} fields where {} columns are named", cells.size(), named),
            how_to_separate(cells));
  cells_.push_back(std::move(cells));
  line_.push_back(number);
}

/// Between double quotes from `at` on, which is then behind them.
std::string DataTable::quoted_text(const std::string& line, std::size_t& at, int number) const {
  const int column = static_cast<int>(at) + 1;
  std::string text;
  for (++at; at < line.size(); ++at) {
    if (line[at] == '"' && line.compare(at, 2, "\"\"") != 0) {
      ++at;
      return text;
    }
    if (line[at] == '"') ++at;  // the first of two
    text += line[at];
  }
  fail_at(number, column, "a double quote is not closed");
}

DataTable::Cells DataTable::split(const std::string& line, int number) const {
  Cells cells;
  const char* blanks = separator_ == '\t' ? " " : " \t";
  for (std::size_t at = 0;; ++at) {
    const int column = static_cast<int>(at) + 1;
    const std::size_t begin = std::min(line.find_first_not_of(blanks, at), line.size());
    const bool quoted = begin < line.size() && line[begin] == '"';
    std::string text;
    at = begin;
    if (quoted) text = quoted_text(line, at, number);
    const std::size_t end = std::min(line.find(separator_, at), line.size());
    const std::string rest = trimmed(line.substr(at, end - at));
    if (rest.find('"') != std::string::npos || (quoted && !rest.empty()))
      fail_at(number, column, "a double quote inside a text",
              "put the text in double quotes, and write those inside twice");
    cells.push_back({trimmed(quoted ? text : rest), column});
    at = end;
    if (at == line.size()) return cells;
  }
}

void DataTable::leave_out_unnamed_columns() {
  while (columns_.size() > 1 && columns_.back().empty() &&
         std::all_of(cells_.begin(), cells_.end(),
                     [](const Cells& row) { return row.back().text.empty(); })) {
    columns_.pop_back();
    for (Cells& row : cells_) row.pop_back();
  }
  if (columns_.size() > 1 && columns_.back().empty())
    fail_columns("the last column has no name, but fields",
                 "leave out what ends the line of names");
}

void DataTable::look_for_decimal_marks() {
  if (separator_ == ',') return;  // a decimal mark is a point there
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    for (const Cell& cell : cells_[row]) {
      const Mark mark{cell.text, line_[row]};
      if (!point_ && has_decimal_point(cell.text)) point_ = mark;
      if (!number_with_comma(cell.text)) continue;
      if (!comma_) comma_ = mark;
      if (!sure_comma_ && !may_be_thousands(cell.text)) sure_comma_ = mark;
    }
  }
}

}  // namespace photic::optics
