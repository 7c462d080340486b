// The axes of a result in its file: telescopes and channels, gates, and those of grids.
#pragma once

#include "io/dataset.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// Adds the dimensions that all results have, and what belongs to telescopes and channels.
void add_axes(Dataset& dataset, const tally::Result& result);
/// Adds times, and depths or ranges, with their bounds (CF-1.10, section 7.1).
void add_gates(Dataset& dataset, const tally::Result& result);
/// Adds the axes of all grids, each once.
void add_axes_of_grids(Dataset& dataset, const tally::Result& result);

}  // namespace photic::io
