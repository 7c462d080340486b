// The group `continuation` of a result file: the state that a longer run goes on from.
#pragma once

#include "io/netcdf_image.hpp"
#include "tally/state.hpp"

namespace photic::io {

/// Adds the group to a file that has the result's axes as its dimensions.
void add_state(NetcdfImage& file, const tally::TotalsState& state);

}  // namespace photic::io
