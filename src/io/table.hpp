// The echoes and tallies as tables for the terminal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include "tally/result.hpp"

namespace photic::io {

inline constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

/// The part of a result that a table shows.
struct TableLayout {
  std::size_t max_rows = 26;  ///< above 0; of more gates or levels every second, third … is shown
  std::size_t width = 100;    ///< of lines, in columns; at least 40 are used
  bool all_columns = false;   ///< environments and parameters that do not fit stand below

  /// Of so many rows every so many-th is shown.
  [[nodiscard]] std::size_t step(std::size_t rows) const {
    return std::max<std::size_t>(1, rows / max_rows + (rows % max_rows == 0 ? 0 : 1));
  }
};

/// For each telescope a table: gates down, channels across, each with its echo and relative error,
/// '*' where it has not converged. Below: why, the environments and sensitivities
/// (io/columns_table.hpp), the quantities beside echoes (io/tally_table.hpp), the summary. Ends
/// with a newline.
std::string echo_table(const tally::Result& result, const TableLayout& layout = {});

/// The number of gates that converged, what the run took and was made by, why it stopped, warnings.
std::string run_summary(const tally::Result& result, std::size_t width);

}  // namespace photic::io
