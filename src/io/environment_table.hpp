// The echoes of environments as a table for the terminal.
#pragma once

#include <cstddef>
#include <string>

#include "tally/result.hpp"

namespace photic::io {

/// For each telescope and channel a table: every `step`-th gate down, environments across, each
/// with its echo over the scene's and the standard error of that, '*' where either echo has not
/// converged. Below: why environments have not, and how many of their gates have. Environments
/// beyond the first six are counted only. Empty if there are none.
std::string environment_table(const tally::Result& result, std::size_t step);

}  // namespace photic::io
