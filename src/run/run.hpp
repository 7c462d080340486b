// Scene -> Result: the driver of a simulation.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "optics/library.hpp"
#include "run/monitor.hpp"
#include "run/permits.hpp"
#include "scene/scene.hpp"
#include "schedule/engines.hpp"
#include "tally/result.hpp"

namespace photic::run {

/// The state at the end of an earlier run of the same scene.
struct Start {
  tally::TotalsState state;  ///< as Result::state has it
  double wall_time_s = 0;    ///< that it took so far
  std::string file;          ///< its name in messages
};

struct RunOptions {
  int threads = 0;             ///< 0: all cores
  std::optional<Isa> lanes;    ///< the instruction set of the lane engine; none: the scalar engine
  Monitor* monitor = nullptr;  ///< of others, who watch the run and may stop it
  std::shared_ptr<Permits> permits;  ///< for its batches and its pilots'; none: no limit
  std::optional<Start> start;        ///< to go on from; the scene asks for more photons

  [[nodiscard]] std::stop_token stop() const {
    return monitor != nullptr ? monitor->token() : std::stop_token();
  }
};

/// Thrown by run() if it is stopped before it has simulated anything: while its model is made,
/// while pilots compare estimators (half of them would choose otherwise), or in the first batch of
/// all sittings.
struct StoppedBeforeFirstBatch : std::exception {
  [[nodiscard]] const char* what() const noexcept override {
    return "stopped before the end of the first batch";
  }
};

/// Runs the scene to its photons, target or time limit. The result depends on the scene alone, not
/// on the threads (max_time_s and stops decide only after which batch it ends). Throws
/// StoppedBeforeFirstBatch, InputError for optics without data at a wavelength and for what lanes
/// cannot do here, EnvironmentError for missing data files.
tally::Result run(const scene::Scene& scene, const optics::Library& library,
                  const RunOptions& options = {});

}  // namespace photic::run
