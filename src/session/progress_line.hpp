// The progress of a run as one line.
#pragma once

#include <string>

#include "run/monitor.hpp"

namespace photic::session {

/// "[######    ]  58 %   4 s left  210/300 gates  worst gate 12 % (target 2.0 %)  91.2 k/s  5.81 M
/// photons": what fits in `width` columns.
std::string progress_line(const run::Progress& progress, int width);

}  // namespace photic::session
