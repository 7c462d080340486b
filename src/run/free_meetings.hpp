// The rate at which rays of free walks meet, where a scene does not set it.
#pragma once

#include <optional>

#include "estimator/model.hpp"
#include "run/run.hpp"

namespace photic::run {

/// Per metre of depth, by walks of telescopes and of the laser.
struct FreeMeetings {
  double telescope = 0, laser = 0;
};

/// The rates with which either kind makes some tens of samples in each set of walks, by a pilot run
/// of a few walks of the bidirectional estimator; none: no such walk can be free. Throws what run()
/// throws.
std::optional<FreeMeetings> usual_free_meetings(const estimator::Model& model,
                                                const scene::Simulation& bidirectional,
                                                const RunOptions& options);

}  // namespace photic::run
