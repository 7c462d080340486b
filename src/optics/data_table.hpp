// Tables of text, read strictly: Photic's own data and those of users.
//
// Lines that begin with "#" or "!" are comments; those of the form "# KEY: text" can be asked for.
// Fields stand between commas, semicolons, tabs or blanks, which a line "sep=;" above may name, and
// the names of columns where table_head.hpp says. Fields that hold the separator stand in double
// quotes, where a double quote is written twice (RFC 4180, but for lines that end inside quotes).
// Numbers may have decimal commas, but not between commas, if all of the table do. Rows without any
// field are left out.
//
// Whatever is wrong is an InputError with file, line and column; what cannot be read in all lines,
// or in all cells of a column, is reported at once: in one line where most of them have it. It
// quotes fields and names only of tables of which some row holds numbers alone: others may be no
// tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "optics/table_fields.hpp"

namespace photic::optics {

/// Returns whether the name belongs to a folder, a pipe or a device, links followed: reading some
/// of these has no end.
bool is_no_regular_file(const std::string& path);
inline constexpr const char* files_are_regular = "folders, pipes and devices are not read";

/// Returns the text in a file. Throws InputError if it is not a regular file or cannot be read.
std::string read_text(const std::string& path);

/// A column of a file, by its name there or by its number, from 1.
struct ColumnInFile {
  std::string name;
  std::int64_t number = 0;

  [[nodiscard]] bool given() const { return number > 0 || !name.empty(); }
};

struct TableHead;

class DataTable {
 public:
  static DataTable read(const std::string& path);
  static DataTable parse(const std::string& text, const std::string& name);

  using Cell = TableCell;
  using Column = std::pair<std::string, std::vector<Cell>>;
  struct Header {
    std::string text;
    int line = 0;
  };
  using Headers = std::map<std::string, Header>;
  /// A table that is no text of its own: columns by their names, all equally long.
  static DataTable of_columns(const std::vector<Column>& columns, const std::string& name,
                              Headers headers = {});

  /// The table of these columns alone, which it calls so: those that the file calls otherwise, and
  /// those that it calls so itself.
  [[nodiscard]] DataTable with(
      const std::vector<std::pair<std::string, ColumnInFile>>& columns) const;
  /// Returns the name of a column in the file, or "column 2".
  [[nodiscard]] std::string name_of_column(const ColumnInFile& column) const;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Empty ones where no names stand anywhere.
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return cells_.size(); }
  /// Returns whether messages may quote the file.
  [[nodiscard]] bool may_be_quoted() const { return shows_; }
  /// "there are, between blanks: a, b", or another hint for a missing column.
  [[nodiscard]] std::string what_there_is() const;
  /// "no column "x"", or that the file is no table.
  [[nodiscard]] std::string lack_of(const std::string& column) const;

  [[nodiscard]] bool has_header(const std::string& key) const { return headers_.contains(key); }
  /// The text of the first "# key: text"; an error if there is none.
  [[nodiscard]] const std::string& header(const std::string& key) const;
  /// The same as a finite number, not negative.
  [[nodiscard]] double number_in_header(const std::string& key) const;

  [[nodiscard]] bool has(const std::string& column) const;
  /// The unit of a column in the header of a SeaBASS file; empty for other files.
  [[nodiscard]] std::string units(const std::string& column) const;

  [[nodiscard]] std::vector<std::string> texts(const std::string& column) const;
  /// Finite numbers only.
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const;
  /// Finite numbers, none below 0.
  [[nodiscard]] std::vector<double> numbers_from_0(const std::string& column) const;
  /// Finite numbers, strictly ascending.
  [[nodiscard]] std::vector<double> ascending_numbers(const std::string& column) const;

  /// The line that names the columns, or else that of the first row; line and column of a cell (row
  /// from 0).
  [[nodiscard]] int column_line() const { return column_line_; }
  [[nodiscard]] std::pair<int, int> place(std::size_t row, const std::string& column) const {
    const Cell& cell = cells_.at(row)[index_of(column)];
    return {cell.line > 0 ? cell.line : line_.at(row), cell.column};
  }

  /// Replaces the text of a cell, which keeps its place.
  void put(std::size_t row, const std::string& column, std::string text) {
    cells_.at(row)[index_of(column)].text = std::move(text);
  }

  /// Remarks on how the file was read.
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

  using Cells = TableCells;

  void read_lines(const std::vector<std::string>& lines, const TableHead& head);
  void add_comment(const std::string& content, int number);
  void add_row(Cells cells, int number);
  [[nodiscard]] std::string how_to_separate(const Cells& row) const;
  void leave_out_unnamed_columns();
  void look_for_numbers();
  void check_decimal_marks(std::size_t index, const std::string& column) const;
  [[nodiscard]] std::optional<double> number(const std::string& text) const;
  [[nodiscard]] std::pair<std::string, std::string> why_no_number(const std::string& text) const;
  [[nodiscard]] std::size_t index_of(const std::string& column) const;
  [[nodiscard]] std::size_t index_of(const ColumnInFile& column) const;
  [[nodiscard]] const Header& header_of(const std::string& key) const;
  [[noreturn]] void fail_at(int line, int column, const std::string& reason,
                            const std::string& suggestion = "") const;

  std::string name_;
  Headers headers_;
  std::vector<std::string> columns_;
  std::vector<std::string> listed_;  ///< the columns of the file
  std::vector<std::string> units_;   ///< of each column
  int column_line_ = 0;
  char separator_ = comma;
  bool has_names_ = true;
  bool shows_ = true;            ///< its contents in messages
  bool whole_numbers_ = false;   ///< no names, and commas between whole numbers
  std::vector<double> missing_;  ///< they stand for values that are not known
  std::vector<Cells> cells_;
  std::vector<int> line_;  ///< of each row
  std::vector<std::string> remarks_;
  /// The first number with a decimal point; with a decimal comma; with one that cannot separate
  /// thousands.
  std::optional<Mark> point_, comma_, sure_comma_;
};

}  // namespace photic::optics
