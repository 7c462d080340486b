// Tables for the terminal that have a column for each environment or parameter.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/echo_rows.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// What stands in the columns.
struct Columns {
  std::string title;               ///< one line
  std::string noun;                ///< what a column is of: "environment"
  std::vector<std::string> names;  ///< of the columns
  /// The rows of a column.
  std::function<std::vector<EchoRow>(std::size_t)> rows;
  /// What is told of a gate, given its row of the scene and that of the column.
  std::function<std::string(const EchoRow&, const EchoRow&)> text;
};

/// For each telescope and channel a table: every `step`-th gate down, columns across, '*' where the
/// column's row or the scene's has not converged. Below: why those of columns have not, and how
/// many of their gates have. Columns beyond the first six are counted only. Empty if there are
/// none.
std::string columns_table(const tally::Result& result, const Columns& columns, std::size_t step);

/// "0.8123±0.0012": two digits of the error, as many as it deserves; smaller ones are told as 1e-4.
/// "-" for what is not a number.
std::string with_error(double value, double error);

}  // namespace photic::io
