// The echoes as a table for the terminal.
#pragma once

#include <string>

#include "tally/result.hpp"

namespace photic::io {

/// For each telescope a table: gates down, channels across, each with its echo and relative error,
/// '*' where it has not converged. Below: why, how many gates converged, the environments
/// and sensitivities (io/environment_table.hpp, io/sensitivity_table.hpp), what the run took,
/// warnings. When there are more gates than `max_rows`, every second, third … is shown. Ends with a
/// newline.
std::string echo_table(const tally::Result& result, std::size_t max_rows = 26);

}  // namespace photic::io
