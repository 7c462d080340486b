// The echoes of environments as a table for the terminal.
#pragma once

#include <cstddef>
#include <string>

#include "io/table.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// Each environment's echo over the scene's with the standard error of that, as columns_table.hpp
/// has it.
std::string environment_table(const tally::Result& result, std::size_t step,
                              const TableLayout& layout);

}  // namespace photic::io
