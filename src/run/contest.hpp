// Pilot runs in stages: all that contend begin with few photons, and those that stay go on.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "estimator/model.hpp"
#include "run/pilots.hpp"
#include "run/run.hpp"

namespace photic::run {

/// An estimator with its settings.
struct Contender {
  std::string name;
  scene::Simulation simulation;
};

/// The standing of one of them.
struct Standing {
  double times_the_work = 1;    ///< against the best one of the last stage that it was in
  std::uint64_t photons = 0;    ///< that it was tried with
  std::size_t rows_unseen = 0;  ///< channels of telescopes that the best one saw light in
  bool given_up_early = false;  ///< others went on
};

/// A setting to be tried with the best contender.
struct Setting {
  std::string name;
  bool of_walks = true;  ///< of the bidirectional estimator alone
  std::function<void(scene::Simulation&)> apply;
};

/// The fate of a setting.
struct Tried {
  std::string name;
  double times_the_work = 1;  ///< against the best so far without it
  bool taken = false;
};

struct Outcome {
  std::optional<std::size_t> best;  ///< none: no pilot saw any light
  scene::Simulation simulation;     ///< of the best, with the settings that were taken
  Aim aim = Aim::all_gates;
  std::size_t gates = 0;           ///< that were compared in the last stage
  std::vector<Standing> standing;  ///< of every contender
  std::vector<Tried> tried;        ///< one after another
  double operations = 0;           ///< that all pilots took, by prices.hpp
};

/// Lets them contend for a simulation of a model whose estimator is open, and then tries the
/// settings one after another, each with the best so far. Pilots have random numbers of their own.
/// They are judged by variances and counted operations, never by a clock, and take at most a tenth
/// of the operations that the simulation is expected to take, but for a first stage; `max_time_s`
/// is not looked at. Throws Stopped, and what run() throws.
Outcome contend(const estimator::Model& model, const std::vector<Contender>& contenders,
                const std::vector<Setting>& settings, const RunOptions& options);

/// Scores of the first pilot of a bidirectional estimator, and the sets of walks that made them.
struct PilotScores {
  double scores = 0, sets = 0;
};
PilotScores scores_of_first_pilot(const estimator::Model& model,
                                  const scene::Simulation& simulation, const RunOptions& options);

}  // namespace photic::run
