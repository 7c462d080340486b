// The places of a tally's cells as words for tables.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/text_columns.hpp"
#include "tally/tally_grid.hpp"

namespace photic::io {

/// A column for each coordinate: "depth [m]" above points, or intervals; every `step`-th cell.
std::vector<TextColumn> place_columns(const tally::Dimension& dimension, std::size_t step);

/// The columns of the terminal that it takes.
std::size_t place_width_of(const TextColumn& column);

/// "depth 5 m", "radius 0 to 2 m", or the cell's name.
std::string place_text(const tally::Dimension& dimension, std::size_t cell);

/// "depth 0 to 20 m": from the first edge to the last.
std::string extent_text(const tally::Dimension& dimension);

}  // namespace photic::io
