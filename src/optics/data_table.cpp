#include "optics/data_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "optics/table_text.hpp"

namespace photic::optics {

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || text.fail()) {
    throw InputError({{path, 0, 0, "cannot be read", "is the path right, and the file readable?"}});
  }
  return text.str();
}

DataTable DataTable::read(const std::string& path) { return parse(read_text(path), path); }

DataTable DataTable::of_columns(const std::vector<Column>& columns, const std::string& name) {
  DataTable table;
  table.name_ = name;
  table.cells_.resize(columns.front().second.size());
  table.line_.resize(table.cells_.size());
  for (const auto& [column, cells] : columns) {
    table.columns_.push_back(column);
    for (std::size_t row = 0; row < cells.size(); ++row) table.cells_[row].push_back(cells[row]);
  }
  return table;
}

std::size_t DataTable::index_of(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) {
    fail_columns(fmt::format("no column \"{}\"", column),
                 fmt::format("there are: {}", fmt::join(columns_, ", ")));
  }
  if (std::find(found + 1, columns_.end(), column) != columns_.end())
    fail_columns(fmt::format("column \"{}\" appears twice", column));
  return static_cast<std::size_t>(found - columns_.begin());
}

const DataTable::Header& DataTable::header_of(const std::string& key) const {
  const auto found = headers_.find(key);
  if (found == headers_.end()) fail_at(1, 1, fmt::format("no line \"# {}: …\"", key));
  return found->second;
}

const std::string& DataTable::header(const std::string& key) const { return header_of(key).text; }

double DataTable::number_in_header(const std::string& key) const {
  const Header& header = header_of(key);
  auto value = finite_number(header.text);
  if (!value && sure_comma_ && !point_) value = number_with_comma(header.text);
  if (!value || *value < 0)
    fail_at(header.line, 1,
            fmt::format("{} must be a finite number, not negative, not \"{}\"", key, header.text));
  return *value;
}

bool DataTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::vector<std::string> DataTable::texts(const std::string& column) const {
  const std::size_t c = index_of(column);
  std::vector<std::string> out;
  out.reserve(cells_.size());
  for (const auto& row : cells_) out.push_back(row[c].text);
  return out;
}

void DataTable::check_decimal_marks(std::size_t index, const std::string& column) const {
  const auto is_marked = [index](const Cells& row) {
    return has_decimal_point(row[index].text) || number_with_comma(row[index].text);
  };
  const auto found = std::find_if(cells_.begin(), cells_.end(), is_marked);
  if (!comma_ || found == cells_.end()) return;
  const auto row = static_cast<std::size_t>(found - cells_.begin());
  if (point_)
    fail(row, column,
         fmt::format("decimal points and decimal commas in one table: \"{}\" in line {}, \"{}\" in "
                     "line {}",
                     point_->text, point_->line, comma_->text, comma_->line),
         "write decimal points, and nothing between thousands");
  if (!sure_comma_)
    fail(row, column, fmt::format("\"{}\" may have a decimal comma or thousands", comma_->text),
         "write decimal points, and nothing between thousands");
}

std::vector<double> DataTable::numbers(const std::string& column) const {
  const std::size_t c = index_of(column);
  check_decimal_marks(c, column);
  std::vector<double> out;
  std::vector<Diagnostic> found;
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    const Cell& cell = cells_[row][c];
    auto value = finite_number(cell.text);
    if (!value && comma_) value = number_with_comma(cell.text);
    if (!value)
      found.push_back({name_, line_[row], cell.column,
                       fmt::format("\"{}\" is not a finite number", cell.text),
                       how_to_write_number(cell.text)});
    out.push_back(value.value_or(0));
  }
  raise_together(std::move(found), rows());
  return out;
}

std::vector<double> DataTable::numbers_from_0(const std::string& column) const {
  std::vector<double> out = numbers(column);
  std::vector<Diagnostic> found;
  for (std::size_t row = 0; row < out.size(); ++row) {
    const auto [line, at] = place(row, column);
    if (out[row] < 0)
      found.push_back({name_, line, at, fmt::format("{} {} is negative", column, out[row]), ""});
  }
  raise_together(std::move(found), rows());
  return out;
}

std::vector<double> DataTable::ascending_numbers(const std::string& column) const {
  std::vector<double> out = numbers(column);
  const auto bad = std::adjacent_find(out.begin(), out.end(), std::greater_equal<>());
  if (bad != out.end()) {
    fail(static_cast<std::size_t>(bad - out.begin()) + 1, column,
         fmt::format("{} {} is not above the {} before it", column, *(bad + 1), *bad),
         "this column must ascend");
  }
  return out;
}

void DataTable::fail(std::size_t row, const std::string& column, const std::string& reason,
                     const std::string& suggestion) const {
  const auto [at_line, at_column] = place(row, column);
  fail_at(at_line, at_column, reason, suggestion);
}

void DataTable::fail_columns(const std::string& reason, const std::string& suggestion) const {
  fail_at(column_line_, 1, reason, suggestion);
}

void DataTable::fail_at(int line, int column, const std::string& reason,
                        const std::string& suggestion) const {
  throw InputError({{name_, line, column, reason, suggestion}});
}

}  // namespace photic::optics
