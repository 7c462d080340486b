// Tables in CSV files, read strictly: Photic's own data and those of users.
//
// Lines that begin with "#" are comments; those of the form "# KEY: text" can be asked for. The
// first other line names the columns, separated by commas, semicolons or tabs, which a line "sep=;"
// above may tell. Fields that hold the separator stand in double quotes, where a double quote is
// written twice (RFC 4180, but for lines that end inside quotes). Between semicolons and tabs
// numbers may have decimal commas, if all of the table do. Rows without any field are left out.
//
// Whatever is wrong is an InputError with file, line and column; what cannot be read in all lines,
// or in all cells of a column, is told at once: in one line where most of them have it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace photic::optics {

/// What a text file holds. Throws InputError if it cannot be read.
std::string read_text(const std::string& path);

class DataTable {
 public:
  static DataTable read(const std::string& path);
  static DataTable parse(const std::string& text, const std::string& name);

  struct Cell {
    std::string text;
    int column = 0;  ///< where it starts, from 1
    int line = 0;    ///< 0: that of its row
  };
  using Column = std::pair<std::string, std::vector<Cell>>;
  /// A table that is no text of its own: columns by their names, all equally long.
  static DataTable of_columns(const std::vector<Column>& columns, const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return cells_.size(); }

  /// The text of the first "# key: text"; an error if there is none.
  [[nodiscard]] const std::string& header(const std::string& key) const;
  /// The same as a finite number, not negative.
  [[nodiscard]] double number_in_header(const std::string& key) const;

  [[nodiscard]] bool has(const std::string& column) const;

  [[nodiscard]] std::vector<std::string> texts(const std::string& column) const;
  /// Finite numbers only.
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const;
  /// Finite numbers, none below 0.
  [[nodiscard]] std::vector<double> numbers_from_0(const std::string& column) const;
  /// Finite numbers, strictly ascending.
  [[nodiscard]] std::vector<double> ascending_numbers(const std::string& column) const;

  /// The line that names the columns; line and column of a cell (row from 0).
  [[nodiscard]] int column_line() const { return column_line_; }
  [[nodiscard]] std::pair<int, int> place(std::size_t row, const std::string& column) const {
    const Cell& cell = cells_.at(row)[index_of(column)];
    return {cell.line > 0 ? cell.line : line_.at(row), cell.column};
  }

  /// Replaces the text of a cell, which keeps its place.
  void put(std::size_t row, const std::string& column, std::string text) {
    cells_.at(row)[index_of(column)].text = std::move(text);
  }

  /// What is worth knowing of how it was read.
  void remark(std::string text) { remarks_.push_back(std::move(text)); }
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

  /// Throws the InputError for something wrong in a row (from 0) and column.
  [[noreturn]] void fail(std::size_t row, const std::string& column, const std::string& reason,
                         const std::string& suggestion = "") const;
  /// The same for something wrong with the line that names the columns.
  [[noreturn]] void fail_columns(const std::string& reason,
                                 const std::string& suggestion = "") const;

 private:
  struct Mark {
    std::string text;
    int line = 0;
  };
  struct Header {
    std::string text;
    int line = 0;
  };

  using Cells = std::vector<Cell>;
  struct Lines;

  void read_head(Lines& lines);
  void read_rows(Lines& lines);
  void add_comment(const std::string& content, int number);
  void add_row(Cells cells, int number);
  [[nodiscard]] std::string how_to_separate(const Cells& row) const;
  void leave_out_unnamed_columns();
  void look_for_decimal_marks();
  [[nodiscard]] Cells split(const std::string& line, int number) const;
  [[nodiscard]] std::string quoted_text(const std::string& line, std::size_t& at, int number) const;
  void check_decimal_marks(std::size_t index, const std::string& column) const;
  [[nodiscard]] std::size_t index_of(const std::string& column) const;
  [[nodiscard]] const Header& header_of(const std::string& key) const;
  [[noreturn]] void fail_at(int line, int column, const std::string& reason,
                            const std::string& suggestion = "") const;

  std::string name_;
  std::map<std::string, Header> headers_;
  std::vector<std::string> columns_;
  int column_line_ = 0;
  char separator_ = ',';
  std::vector<Cells> cells_;
  std::vector<int> line_;  ///< of each row
  std::vector<std::string> remarks_;
  /// The first number with a decimal point; with a decimal comma; with one that cannot separate
  /// thousands.
  std::optional<Mark> point_, comma_, sure_comma_;
};

}  // namespace photic::optics
