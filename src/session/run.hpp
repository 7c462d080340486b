// A simulation at work on threads of its own.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "run/monitor.hpp"
#include "run/run.hpp"
#include "scene/scene.hpp"
#include "session/context.hpp"
#include "tally/result.hpp"

namespace photic::session {

/// May be used by several threads.
class Run {
 public:
  /// Begins. The monitor and the permits of `options` are replaced.
  Run(const Context& context, scene::Scene scene, run::RunOptions options);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  /// Stops, and waits.
  ~Run();

  /// Asks the run to end soon, with what there is; only once it has ended this has no effect.
  void stop() noexcept;
  [[nodiscard]] run::Progress progress() const;
  /// The result so far; waits for the next batch end at most. None before the first batch end, and
  /// once the run has ended.
  [[nodiscard]] std::optional<tally::Result> so_far(bool with_state = false);
  /// Returns whether the run has ended within so much time.
  [[nodiscard]] bool wait_for(std::chrono::milliseconds time) const;
  /// Waits for the end, and hands out the result: once. Throws what ended the run.
  tally::Result result();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace photic::session
