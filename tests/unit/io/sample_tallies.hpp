// Quantities beside echoes, made up by hand: for tests of what is written, never of physics.
#pragma once

#include <vector>

#include "tally/result.hpp"
#include "tally/shape.hpp"

namespace photic::test {

/// All kinds: irradiances at 8 levels of which one is in the air, boundaries of two layers of water
/// and one of air, radiances, and two maps of the fluence. All have a strength of 50 W, or of
/// 50 W m-2.
std::vector<tally::TallyGrid> sample_tally_grids();

/// Estimates on these, and their state if the result has one. Deep cells have not converged, and
/// some have seen no light.
void add_sample_tallies(tally::Result& result);

/// A result without telescopes.
tally::Result sample_tallies_alone();

/// The extents of its tallies.
tally::Shape sample_shape_of_tallies_alone();

}  // namespace photic::test
