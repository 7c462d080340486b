// The quantities tallied beside echoes, in a result's file.
#pragma once

#include "io/dataset.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// Adds the strength of the source, the dimensions of all tallies with their coordinates, each
/// once, and the quantities with their errors and flags. The file has the dimension `bnds`.
void add_tallies(Dataset& dataset, const tally::Result& result);

}  // namespace photic::io
