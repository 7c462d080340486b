#include "run/permits.hpp"

#include "core/error.hpp"
#include "core/stop.hpp"

namespace photic::run {

Permits::Permits(int count) : free_(count) { expect(count > 0, "someone may simulate"); }

void Permits::take(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  const std::uint64_t mine = asked_++;
  waiting_.insert(mine);
  const bool granted =
      changed_.wait(lock, stop, [&] { return free_ > 0 && *waiting_.begin() == mine; });
  waiting_.erase(mine);
  if (granted) --free_;
  changed_.notify_all();  // another one is the first to wait
  if (!granted) throw_stopped();
}

void Permits::give_back() {
  const std::scoped_lock lock(mutex_);
  ++free_;
  changed_.notify_all();
}

}  // namespace photic::run
