// A result made up by hand, that looks like a ship lidar's: for tests of what is written, never of
// physics.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tally/result.hpp"
#include "tally/shape.hpp"

namespace photic::test {

/// Two telescopes, three channels, 100 gates of 0.5 m, orders 1 … 6 and above. Deep gates are not
/// converged, the deepest have seen nothing; one diagnostic is NaN.
tally::Result sample_result();

/// The same with environments of more and more algae: each absorbs 0.02/m more than the one before;
/// and with derivatives with respect to parameters.
tally::Result sample_result_in(const std::vector<std::string>& environments,
                               const std::vector<std::string>& parameters = {});

/// The extents of its tallies, which keep groups of batches.
tally::Shape sample_shape(std::size_t environments = 0, std::size_t parameters = 0);

/// How messages about a file that is no result end.
inline constexpr const char* wanted_result =
    " (a result is what `photic run SCENE -o out.nc` writes)";

}  // namespace photic::test
