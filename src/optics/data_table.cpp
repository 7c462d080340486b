#include "optics/data_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/error.hpp"

namespace photic::optics {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// What several actions refuse, told together, unless it is so much that the file is another one.
class Problems {
 public:
  [[nodiscard]] bool enough() const { return found_.size() >= 20; }
  template <class Action>
  void collect(const Action& action) {
    try {
      action();
    } catch (const InputError& error) {
      for (const Diagnostic& d : error.diagnostics()) found_.push_back(d);
    }
  }
  void raise() const {
    if (!found_.empty()) throw InputError(found_);
  }

 private:
  std::vector<Diagnostic> found_;
};

/// Of a whole text.
std::optional<double> finite_number(const std::string& text) {
  double value = 0;
  const auto end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

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

DataTable DataTable::parse(const std::string& text, const std::string& name) {
  DataTable table;
  table.name_ = name;
  std::istringstream lines(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  std::string line;
  int number = 0;
  Problems problems;
  while (!problems.enough() && std::getline(lines, line)) {
    ++number;
    problems.collect([&] { table.add_line(line, number); });
    if (table.columns_.empty()) problems.raise();  // nothing can be said of the rest
  }
  problems.raise();
  if (table.cells_.empty()) table.fail_at(std::max(1, number), 1, "has no rows of data");
  return table;
}

void DataTable::add_line(const std::string& line, int number) {
  const std::string content = trimmed(line);
  if (content.empty()) return;
  if (content.front() == '#') {
    const auto colon = content.find(':');
    if (colon != std::string::npos) {
      headers_.emplace(trimmed(content.substr(1, colon - 1)),
                       Header{trimmed(content.substr(colon + 1)), number});
    }
    return;
  }
  std::vector<Cell> fields = split(line, number);
  if (columns_.empty()) {
    for (const Cell& field : fields) columns_.push_back(field.text);
    column_line_ = number;
    return;
  }
  if (fields.size() != columns_.size()) {
    fail_at(number, 1,
            fmt::format("{} fields where {} columns are named", fields.size(), columns_.size()),
            "a text with a comma needs double quotes");
  }
  cells_.push_back(std::move(fields));
  line_.push_back(number);
}

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

std::vector<DataTable::Cell> DataTable::split(const std::string& line, int number) const {
  std::vector<Cell> cells{{.text = "", .column = 1}};
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.push_back({.text = "", .column = static_cast<int>(i) + 2});
    } else {
      cells.back().text += line[i];
    }
  }
  if (quoted) fail_at(number, cells.back().column, "a double quote is not closed");
  for (Cell& cell : cells) cell.text = trimmed(cell.text);
  return cells;
}

std::size_t DataTable::index_of(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) {
    fail_columns(fmt::format("no column \"{}\"", column),
                 fmt::format("there are: {}", fmt::join(columns_, ", ")));
  }
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
  const auto value = finite_number(header.text);
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

std::vector<double> DataTable::numbers(const std::string& column) const {
  std::vector<double> out;
  Problems problems;
  for (const std::string& text : texts(column)) {
    const auto value = finite_number(text);
    if (!value) {
      if (problems.enough()) break;
      problems.collect(
          [&] { fail(out.size(), column, fmt::format("\"{}\" is not a finite number", text)); });
    }
    out.push_back(value.value_or(0));
  }
  problems.raise();
  return out;
}

std::vector<double> DataTable::numbers_from_0(const std::string& column) const {
  std::vector<double> out = numbers(column);
  Problems problems;
  for (std::size_t i = 0; i < out.size() && !problems.enough(); ++i) {
    if (out[i] < 0)
      problems.collect([&] { fail(i, column, fmt::format("{} {} is negative", column, out[i])); });
  }
  problems.raise();
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
