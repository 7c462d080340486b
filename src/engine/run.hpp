// Scene -> Result: the driver of a simulation.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "scene/scene.hpp"
#include "tally/result.hpp"

namespace photic::engine {

/// How far a run is, told at batch ends.
struct Progress {
  std::uint64_t photons = 0;
  std::optional<std::uint64_t> photons_asked;
  double elapsed_s = 0;
  std::optional<double> max_time_s;
  std::size_t gates_converged = 0;  ///< over all telescopes and channels
  std::size_t gates = 0;            ///< those that light can reach
};

struct RunOptions {
  int threads = 0;  ///< 0: all cores
  std::function<void(const Progress&)>
      progress;  ///< called a few times a second from one thread at a time
  const std::atomic<bool>* interrupt = nullptr;  ///< set to end the run at the next batch end
};

/// Runs the scene to its photons, target or time limit. The result depends on the scene alone, not
/// on the threads (max_time_s and interrupts decide only after which batch it ends). Throws
/// InputError for optics without data at a wavelength, EnvironmentError for missing data files.
tally::Result run(const scene::Scene& scene, const RunOptions& options = {});

}  // namespace photic::engine
