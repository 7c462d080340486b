// The progress bar on a terminal.
#pragma once

#include <string>

#include "engine/run.hpp"

namespace photic::app {

/// "[######    ]  58 %  5.8e+06 photons  1.2e+06/s  gates converged 210/300  4 s left", `width`
/// columns at most.
std::string progress_line(const engine::Progress& progress, int width);

/// Draws the line again at every call, on standard error; wipes it before a message and when the
/// run is over.
class ProgressBar {
 public:
  ProgressBar() = default;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar() { wipe(); }

  void draw(const engine::Progress& progress);
  void wipe();

 private:
  bool drawn_ = false;
};

/// Standard error is a terminal.
bool has_terminal();

}  // namespace photic::app
