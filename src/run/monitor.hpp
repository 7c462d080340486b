// A run as others see it while it is at work, and their way to end it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

#include "tally/result.hpp"

namespace photic::run {

enum class Phase {
  preparing,  ///< the model is made
  choosing,   ///< pilots compare estimators
  running,
  ended,  ///< with a result or without
};

/// The progress of a run, as of its last batch end.
struct Progress {
  Phase phase = Phase::preparing;
  std::size_t pilots_done = 0;
  std::size_t pilots = 0;  ///< known so far, those done included: others may follow from these
  std::uint64_t photons = 0;
  std::uint64_t photons_before = 0;  ///< of them, from earlier sittings
  std::optional<std::uint64_t> photons_asked;
  double elapsed_s = 0;  ///< in this sitting, since the first batch began
  std::optional<double> max_time_s;
  // These are counted a few times a second.
  std::size_t gates_converged = 0;  ///< over all telescopes and channels
  std::size_t gates = 0;            ///< those that light can reach
  double worst_error = 0;           ///< the largest relative error of these
  std::optional<double> target;     ///< its aim
};

/// Watches one run. Used by several threads: the run never waits for those who look.
class Monitor {
 public:
  /// Asks the run to end soon.
  void stop() noexcept { stop_.request_stop(); }
  [[nodiscard]] bool stopped() const noexcept { return stop_.stop_requested(); }
  /// Looked at by those who work for the run.
  [[nodiscard]] std::stop_token token() const noexcept { return stop_.get_token(); }

  [[nodiscard]] Progress progress() const;
  /// The result so far, partial and stopped by "checkpoint", made by the thread that asks; with the
  /// state that a run can go on from, if asked. None before the first batch end, nor once the run
  /// has ended.
  [[nodiscard]] std::optional<tally::Result> so_far(bool with_state = false) const;

  // For the run itself.

  /// Calls change(progress).
  template <class Change>
  void update(Change change) {
    const std::scoped_lock lock(progress_mutex_);
    change(progress_);
  }
  /// Makes a result of a copy of all that a run has so far.
  using Builder = std::function<tally::Result(bool with_state)>;
  /// `copy` makes that copy, of what the run has when it is called; an empty one if it has nothing.
  void show(std::function<Builder()> copy);
  /// After this no copy is made, nor is one being made.
  void hide() { show(nullptr); }

 private:
  std::stop_source stop_;
  mutable std::mutex progress_mutex_, copy_mutex_;
  Progress progress_;
  std::function<Builder()> copy_;
};

}  // namespace photic::run
