// The progress bar on a terminal.
#pragma once

#include <string>

#include "run/run.hpp"

namespace photic::app {

/// "[######    ]  58 %   4 s left  210/300 gates  worst gate 12 % (target 2.0 %)  91.2 k/s  5.81 M
/// photons": what fits in `width` columns.
std::string progress_line(const run::Progress& progress, int width);

/// Draws the line again at every call, on standard error; wipes it before a message and when the
/// run is over.
class ProgressBar {
 public:
  ProgressBar() = default;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar() { wipe(); }

  void draw(const run::Progress& progress);
  void wipe();

 private:
  bool drawn_ = false;
};

}  // namespace photic::app
