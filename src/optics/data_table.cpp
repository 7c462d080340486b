#include "optics/data_table.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "optics/table_text.hpp"

namespace photic::optics {

bool is_no_regular_file(const std::string& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

std::string read_text(const std::string& path) {
  constexpr std::size_t block = 65536;
  // Some files of the system block a program that opens or reads them.
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  struct stat status {};
  const bool regular = file < 0 || ::fstat(file, &status) != 0 || S_ISREG(status.st_mode);
  std::string text;
  ssize_t more = file < 0 ? -1 : 1;
  while (regular && more > 0) {
    const std::size_t before = text.size();
    text.resize(before + block);
    more = ::read(file, text.data() + before, block);
    text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(more, 0)));
  }
  if (file >= 0) ::close(file);
  if (!regular) throw InputError({{path, 0, 0, "no regular file", files_are_regular}});
  if (more < 0)
    throw InputError({{path, 0, 0, "cannot be read", "is the path right, and the file readable?"}});
  return text;
}

DataTable DataTable::read(const std::string& path) { return parse(read_text(path), path); }

DataTable DataTable::of_columns(const std::vector<Column>& columns, const std::string& name,
                                Headers headers) {
  DataTable table;
  table.name_ = name;
  table.headers_ = std::move(headers);
  table.cells_.resize(columns.front().second.size());
  table.line_.resize(table.cells_.size());
  for (const auto& [column, cells] : columns) {
    table.columns_.push_back(column);
    for (std::size_t row = 0; row < cells.size(); ++row) table.cells_[row].push_back(cells[row]);
  }
  table.listed_ = table.columns_;
  table.units_.resize(columns.size());
  return table;
}

DataTable DataTable::with(const std::vector<std::pair<std::string, ColumnInFile>>& columns) const {
  DataTable out = *this;
  out.columns_.clear();
  out.units_.clear();
  for (Cells& row : out.cells_) row.clear();
  std::map<std::size_t, std::string> taken;
  for (const auto& [called, column] : columns) {
    if (!column.given() && !has(called)) continue;
    const std::size_t index = column.given() ? index_of(column) : index_of(called);
    if (const auto [other, is_new] = taken.emplace(index, called); !is_new)
      fail_columns(
          fmt::format("column {} is named as both {} and {}", index + 1, other->second, called),
          "each has a column of its own");
    out.columns_.push_back(called);
    out.units_.push_back(units_[index]);
    for (std::size_t row = 0; row < cells_.size(); ++row)
      out.cells_[row].push_back(cells_[row][index]);
  }
  return out;
}

std::string DataTable::name_of_column(const ColumnInFile& column) const {
  if (column.number == 0) return column.name;
  const auto index = static_cast<std::size_t>(column.number) - 1;
  const bool shown_name = index < columns_.size() && shows_ && !columns_[index].empty();
  return shown_name ? shown(columns_[index]) : fmt::format("column {}", column.number);
}

std::string DataTable::what_there_is() const {
  constexpr std::size_t most = 20;
  if (!shows_) return what_a_table_is;
  const std::size_t count = listed_.size();
  const bool separated = column_line_ > 0 && count > 1;
  const std::string between =
      separated ? fmt::format(", between {}s", name_of(separator_)) : std::string();
  if (!has_names_)
    return fmt::format("there {} {}{}, without names: call {}", count == 1 ? "is" : "are", count,
                       between, count == 1 ? "it column 1" : "them by their numbers");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(most, count); ++i) names.push_back(shown(listed_[i]));
  const std::string more = count > most ? fmt::format(" and {} more", count - most) : "";
  return fmt::format("there are{}: {}{}", between, fmt::join(names, ", "), more);
}

std::string DataTable::lack_of(const std::string& column) const {
  const std::string lack = fmt::format("no column \"{}\"", column);
  return shows_ ? lack : fmt::format("{}: {}", no_numbers, lack);
}

std::size_t DataTable::index_of(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) fail_columns(lack_of(column), what_there_is());
  if (std::find(found + 1, columns_.end(), column) != columns_.end())
    fail_columns(fmt::format("column \"{}\" appears twice", column),
                 "give each a name of its own; a scene may call columns by their numbers");
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t DataTable::index_of(const ColumnInFile& column) const {
  if (column_line_ == 0) fail_at(0, 0, "is no table of text, whose columns could be named");
  if (column.number == 0) return index_of(column.name);
  const auto index = static_cast<std::size_t>(column.number) - 1;
  if (index >= columns_.size())
    fail_columns(shows_ ? fmt::format("no column {}", column.number)
                        : lack_of(std::to_string(column.number)),
                 what_there_is());
  if (whole_numbers_)
    fail_columns("whole numbers between commas, without names: may these be decimal commas?",
                 "write decimal points, or the names of columns in the first line");
  if (is_number(columns_[index], separator_))
    fail_columns(
        fmt::format("the name of column {} is a number: is this line a row?", column.number),
        "give names above it, or call the column by its name, in quotes");
  return index;
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
            fmt::format("{} must be a finite number, not negative{}", key,
                        shows_ ? fmt::format(", not \"{}\"", shown(header.text)) : ""));
  return *value;
}

bool DataTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::string DataTable::units(const std::string& column) const { return units_[index_of(column)]; }

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
  const auto in_quotes = [this](const Mark& mark) {
    return shows_ ? fmt::format("\"{}\"", shown(mark.text)) : "a number";
  };
  if (point_)
    fail(row, column,
         fmt::format("decimal points and decimal commas in one table: {} in line {}, {} in line {}",
                     in_quotes(*point_), point_->line, in_quotes(*comma_), comma_->line),
         "write decimal points, and nothing between thousands");
  if (!sure_comma_)
    fail(row, column, fmt::format("{} may have a decimal comma or thousands", in_quotes(*comma_)),
         "write decimal points, and nothing between thousands");
}

std::optional<double> DataTable::number(const std::string& text) const {
  auto value = finite_number(text);
  if (!value && comma_) value = number_with_comma(text);
  if (value && std::ranges::find(missing_, *value) != missing_.end()) return std::nullopt;
  return value;
}

/// The reason and what helps.
std::pair<std::string, std::string> DataTable::why_no_number(const std::string& text) const {
  if (!shows_ && !is_gap(text))
    return {fmt::format("{}: this field holds no number", no_numbers), what_a_table_is};
  if (finite_number(text))
    return {fmt::format("\"{}\" stands for a value that is not known, by the file's own header",
                        shown(text)),
            how_to_write_number("")};
  return {fmt::format("\"{}\" is not a finite number", shown(text)), how_to_write_number(text)};
}

std::vector<double> DataTable::numbers(const std::string& column) const {
  const std::size_t c = index_of(column);
  check_decimal_marks(c, column);
  std::vector<double> out;
  std::vector<Diagnostic> found;
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    const Cell& cell = cells_[row][c];
    const auto value = number(cell.text);
    if (!value) {
      auto [reason, suggestion] = why_no_number(cell.text);
      found.push_back({name_, line_[row], cell.column, std::move(reason), std::move(suggestion)});
    }
    out.push_back(value.value_or(0));
  }
  if (!shows_ && !found.empty()) found.resize(1);  // of a file that is no table one is enough
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
