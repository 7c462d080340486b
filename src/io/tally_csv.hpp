// The quantities tallied beside echoes as comma-separated values.
#pragma once

#include <string>
#include <vector>

#include "tally/result.hpp"

namespace photic::io {

/// Lines that start with '#': the quantities, and what their columns hold.
std::string about_tallies(const tally::Result& result);

/// The columns that echoes do not have: the quantity, the places of all quantities' cells
/// (io/tally_rows.hpp), the value and its units.
std::vector<std::string> tally_columns(const tally::Result& result);

/// A cell.
struct TallyLine {
  std::string quality;              ///< "standard_error,relative_error,converged,reasons"
  std::vector<std::string> fields;  ///< of tally_columns; empty where its quantity has none
};
std::vector<TallyLine> tally_lines(const tally::Result& result);

/// The whole table of a result without echoes, below the lines about the run.
std::string tally_csv(const tally::Result& result);

}  // namespace photic::io
