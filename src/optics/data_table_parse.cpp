#include <fmt/format.h>

#include <algorithm>

#include "optics/data_table.hpp"
#include "optics/table_head.hpp"
#include "optics/table_text.hpp"

namespace photic::optics {
DataTable DataTable::parse(const std::string& text, const std::string& name) {
  DataTable table;
  table.name_ = name;
  const std::vector<std::string> lines = lines_of_table(text, name);
  const TableHead head = head_of(lines, name);
  table.columns_ = head.names;
  table.columns_.resize(head.columns);
  table.has_names_ = !head.names.empty();
  table.column_line_ = head.line;
  table.separator_ = head.separator;
  table.missing_ = head.missing;
  table.units_ = head.units;
  table.units_.resize(head.columns);
  table.read_lines(lines, head);
  if (table.cells_.empty())
    table.fail_at(std::max<int>(1, static_cast<int>(lines.size())), 1,
                  fmt::format("{}: no rows of data", no_numbers));
  table.leave_out_unnamed_columns();
  table.listed_ = table.columns_;
  table.look_for_numbers();
  return table;
}

void DataTable::read_lines(const std::vector<std::string>& lines, const TableHead& head) {
  std::vector<Diagnostic> found;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    const std::string content = trimmed(lines[i]);
    if (content.empty() || (i < head.first_row && !is_comment(content))) continue;
    if (is_comment(content)) {
      add_comment(content, number);
      continue;
    }
    ++rows;
    try {
      add_row(fields_of(lines[i], separator_, name_, number), number);
    } catch (const InputError& error) {
      found.insert(found.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  if (!head.has_numbers && !found.empty()) raise_without_numbers(found.front());
  raise_together(std::move(found), rows);
}

void DataTable::add_comment(const std::string& content, int number) {
  std::size_t at = 0;
  std::string text = content.front() == '"' ? quoted_text(content, at, name_, number) : content;
  // Spreadsheets fill up every line to the same number of columns.
  text.erase(std::min(text.find_last_not_of(" \t,;") + 1, text.size()));
  const auto colon = text.find(':');
  if (colon != std::string::npos)
    headers_.emplace(trimmed(text.substr(1, colon - 1)),
                     Header{trimmed(text.substr(colon + 1)), number});
}

std::string DataTable::how_to_separate(const Cells& row) const {
  const char* separator = name_of(separator_);
  if (row.size() < columns_.size() && separator_ == blank)
    return "a gap between blanks is not seen: leave the row out, or write commas";
  if (row.size() < columns_.size())
    return fmt::format("separate them by {}s, as the {} are", separator,
                       has_names_ ? "names" : "others");
  if (has_names_ && row.size() == columns_.size() + 1 && row.back().text.empty())
    return fmt::format("end the line of names with a {}, too", separator);
  return fmt::format("{}a text with a {} needs double quotes",
                     separator_ == comma ? "a number needs a decimal point, " : "", separator);
}

void DataTable::add_row(Cells cells, int number) {
  const bool gaps =
      std::all_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.text.empty(); });
  if (gaps && cells.size() > 1) return;
  const std::size_t named = columns_.size();
  if (cells.size() != named)
    fail_at(number, 1,
            has_names_
                ? fmt::format("{} fields where {} columns are named", cells.size(), named)
                : fmt::format("{} fields where line {} has {}", cells.size(), column_line_, named),
            how_to_separate(cells));
  cells_.push_back(std::move(cells));
  line_.push_back(number);
}

void DataTable::leave_out_unnamed_columns() {
  while (columns_.size() > 1 && columns_.back().empty() &&
         std::all_of(cells_.begin(), cells_.end(),
                     [](const Cells& row) { return row.back().text.empty(); })) {
    columns_.pop_back();
    for (Cells& row : cells_) row.pop_back();
  }
  if (has_names_ && columns_.size() > 1 && columns_.back().empty())
    fail_columns("the last column has no name, but fields",
                 "leave out what ends the line of names");
}

void DataTable::look_for_numbers() {
  const auto numbers = [this](const Cells& row) { return are_numbers(row, separator_); };
  shows_ = columns_.size() > 1 ? std::ranges::any_of(cells_, numbers)
                               : std::ranges::all_of(cells_, numbers);
  if (separator_ == comma) {  // a decimal mark is a point there
    whole_numbers_ =
        !has_names_ && columns_.size() > 1 && std::ranges::none_of(cells_, [](const Cells& row) {
          return std::ranges::any_of(row, [](const Cell& cell) {
            return cell.text.find_first_of(".eE") != std::string::npos;
          });
        });
    return;
  }
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
