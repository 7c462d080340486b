// The group `continuation` of a result file: the state that a longer run goes on from.
#pragma once

#include <vector>

#include "io/netcdf_image.hpp"
#include "tally/grid.hpp"
#include "tally/state.hpp"

namespace photic::io {

/// Adds the group to a file that has the result's axes as its dimensions, those of grids among
/// them.
void add_state(NetcdfImage& file, const tally::TotalsState& state,
               const std::vector<tally::Grid>& grids);

}  // namespace photic::io
