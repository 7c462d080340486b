#include "photic/progress.hpp"

#include "photic/output.hpp"
#include "photic/terminal.hpp"
#include "session/progress_line.hpp"

namespace photic::app {
namespace {

constexpr const char* wipe_line = "\r\033[K";

}  // namespace

void ProgressBar::draw(const run::Progress& progress) {
  const std::scoped_lock lock(mutex_);
  // A last column left free keeps terminals from wrapping.
  print_error(wipe_line + session::progress_line(progress, columns(Stream::error, 80) - 1));
  drawn_ = true;
}

void ProgressBar::print_above(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  wipe_drawn();
  print_warning(line + '\n');
}

void ProgressBar::wipe() {
  const std::scoped_lock lock(mutex_);
  wipe_drawn();
}

void ProgressBar::wipe_drawn() {
  if (drawn_) print_error(wipe_line);
  drawn_ = false;
}

}  // namespace photic::app
