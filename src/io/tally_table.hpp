// The quantities tallied beside echoes as tables for the terminal.
#pragma once

#include <cstddef>
#include <string>

#include "io/table.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// Quantities on the same dimensions beside each other: levels or angles down; numbers, and cells
/// that have names, in a list of those that have light. Of a map only its extent, its largest value
/// and how much of it has converged. With a strength of the source in its units. Below: why cells
/// have not converged. Ends with an empty line; empty if there are no tallies.
std::string tally_table(const tally::Result& result, const TableLayout& layout);

/// "converged tallies: irradiance 38 of 40, boundaries 20 of 25 (5 without light) cells"; empty if
/// there are none.
std::string converged_tallies(const tally::Result& result, std::size_t width);

}  // namespace photic::io
