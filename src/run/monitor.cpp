#include "run/monitor.hpp"

#include <utility>

namespace photic::run {

Progress Monitor::progress() const {
  const std::scoped_lock lock(progress_mutex_);
  return progress_;
}

std::optional<tally::Result> Monitor::so_far(bool with_state) const {
  Builder build;
  {
    const std::scoped_lock lock(copy_mutex_);
    if (copy_) build = copy_();
  }
  return build ? std::optional(build(with_state)) : std::nullopt;
}

void Monitor::show(std::function<Builder()> copy) {
  const std::scoped_lock lock(copy_mutex_);
  copy_ = std::move(copy);
}

}  // namespace photic::run
