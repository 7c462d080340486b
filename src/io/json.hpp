// The echoes as JSON, for programs that run Photic.
#pragma once

#include <string>

#include "tally/result.hpp"

namespace photic::io {

/// The run, its warnings, and under "echoes" one object for each telescope, channel and gate with
/// the fields of the CSV (io/csv.hpp); under "tallies" one for each quantity beside echoes,
/// with its cells; what is not a number is null. Ends with a newline.
std::string echo_json(const tally::Result& result);

}  // namespace photic::io
