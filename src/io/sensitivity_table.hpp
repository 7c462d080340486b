// The derivatives of echoes as a table for the terminal.
#pragma once

#include <cstddef>
#include <string>

#include "io/table.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// The logarithmic sensitivity to each parameter with its standard error, as columns_table.hpp has
/// it.
std::string sensitivity_table(const tally::Result& result, std::size_t step,
                              const TableLayout& layout);

}  // namespace photic::io
