// Scene -> Result: the driver of a simulation.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>

#include "scene/scene.hpp"
#include "schedule/engines.hpp"
#include "tally/result.hpp"

namespace photic::run {

/// The progress of a run, reported at batch ends.
struct Progress {
  std::uint64_t photons = 0;
  std::uint64_t photons_before = 0;  ///< of them, from earlier sittings
  std::optional<std::uint64_t> photons_asked;
  double elapsed_s = 0;  ///< in this sitting
  std::optional<double> max_time_s;
  std::size_t gates_converged = 0;  ///< over all telescopes and channels
  std::size_t gates = 0;            ///< those that light can reach
  double worst_error = 0;           ///< the largest relative error of these
  std::optional<double> target;     ///< its aim
};

/// The state at the end of an earlier run of the same scene.
struct Start {
  tally::TotalsState state;  ///< as Result::state has it
  double wall_time_s = 0;    ///< that it took so far
  std::string file;          ///< its name in messages
};

/// The result so far, handed out now and then in case the run does not live to its end.
struct Checkpoints {
  std::function<void(const tally::Result&)> write;  ///< called as `progress` is
  double first_s = 60;                              ///< after the start of this sitting
  double every_s = 30;                              ///< after the end of the last one
};

struct RunOptions {
  int threads = 0;           ///< 0: all cores
  std::optional<Isa> lanes;  ///< the instruction set of the lane engine; none: the scalar engine
  std::function<void(const Progress&)>
      progress;  ///< called a few times a second from one thread at a time
  const std::atomic<bool>* interrupt = nullptr;  ///< set to end the run at the next batch end
  std::optional<Start> start;                    ///< to go on from; the scene asks for more photons
  Checkpoints checkpoints;
};

/// Thrown by run() if it is interrupted while pilots compare estimators: half of them would choose
/// otherwise, and nothing has been simulated yet.
struct InterruptedPilots : std::exception {
  [[nodiscard]] const char* what() const noexcept override {
    return "interrupted while estimators were compared";
  }
};

/// Runs the scene to its photons, target or time limit. The result depends on the scene alone, not
/// on the threads (max_time_s and interrupts decide only after which batch it ends). Throws
/// InputError for optics without data at a wavelength and for what lanes cannot do here,
/// EnvironmentError for missing data files.
tally::Result run(const scene::Scene& scene, const RunOptions& options = {});

}  // namespace photic::run
