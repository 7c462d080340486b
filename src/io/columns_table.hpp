// Tables for the terminal that have a column for each environment or parameter.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/echo_rows.hpp"
#include "io/table.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// The contents of the columns.
struct Columns {
  std::string title;                  ///< a sentence
  std::vector<std::string> meanings;  ///< of the columns, which are called A, B, C …
  /// The rows of a column.
  std::function<std::vector<EchoRow>(std::size_t)> rows;
  /// The text for a gate, given its row of the scene and that of the column.
  std::function<std::string(const EchoRow&, const EchoRow&)> text;
};

/// A legend: what each column means, and how many of its gates have converged. Below, for each
/// telescope and channel, a table: every `step`-th gate down, columns across, '*' where the
/// column's row or the scene's has not converged; then why those have not. Columns that do not fit
/// beside each other stand below if the layout asks for all, else they are only counted. Empty if
/// there are none.
std::string columns_table(const tally::Result& result, const Columns& columns, std::size_t step,
                          const TableLayout& layout);

/// "A" … "Z", "AA", "AB" …, as spreadsheets call columns, from 0.
std::string column_letters(std::size_t column);

/// "0.8123±0.0012": two digits of the error, as many as it deserves; smaller ones are written as
/// 1e-4. "-" for what is not a number.
std::string with_error(double value, double error);

}  // namespace photic::io
