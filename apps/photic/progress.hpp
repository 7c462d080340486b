// The progress bar on a terminal.
#pragma once

#include <mutex>
#include <string>

#include "run/monitor.hpp"

namespace photic::app {

/// Draws the line again at every call, on standard error; wipes it before a message and when the
/// run is over. May be used by several threads.
class ProgressBar {
 public:
  ProgressBar() = default;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar() { wipe(); }

  void draw(const run::Progress& progress);
  /// Prints a line that stays, and should be seen.
  void print_above(const std::string& line);
  void wipe();

 private:
  void wipe_drawn();

  std::mutex mutex_;
  bool drawn_ = false;
};

}  // namespace photic::app
