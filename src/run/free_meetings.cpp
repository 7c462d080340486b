#include "run/free_meetings.hpp"

#include <algorithm>

#include "estimator/strategies.hpp"
#include "run/contest.hpp"

namespace photic::run {
namespace {

/// In a set of walks each kind makes so many samples (docs/decisions/0042).
constexpr double samples_in_set = 25;
/// Per metre: more is never worth the while.
constexpr double max_meetings = 2.5;

}  // namespace

std::optional<FreeMeetings> usual_free_meetings(const estimator::Model& model,
                                                const scene::Simulation& bidirectional,
                                                const RunOptions& options) {
  const auto strategies = estimator::make_strategies(model.scene, model.medium);
  if (!strategies.free_telescope.used && !strategies.free_laser.used) return std::nullopt;
  const auto scores_with = [&](double telescope, double laser) {
    scene::Simulation s = bidirectional;
    s.free_telescope_meetings = telescope;
    s.free_laser_meetings = laser;
    return scores_of_first_pilot(model, s, options);
  };
  const auto none = scores_with(0, 0);
  const auto per_metre = [&](bool used, double telescope, double laser) {
    if (!used) return 0.0;
    const auto [scores, sets] = scores_with(telescope, laser);
    const double in_set = (scores - none.scores) / sets;
    return in_set > samples_in_set / max_meetings ? samples_in_set / in_set : max_meetings;
  };
  return FreeMeetings{per_metre(strategies.free_telescope.used, 1, 0),
                      per_metre(strategies.free_laser.used, 0, 1)};
}

}  // namespace photic::run
