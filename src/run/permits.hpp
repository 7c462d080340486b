// A limit to the batches that all runs of a process simulate at once.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <stop_token>

namespace photic::run {

/// Permits to simulate a batch, shared by runs. First come, first served: no run waits for ever.
class Permits {
 public:
  explicit Permits(int count);

  /// Waits for a permit. Throws Stopped if the run that asks for it is stopped meanwhile.
  void take(const std::stop_token& stop);
  void give_back();

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  int free_;
  std::uint64_t asked_ = 0;
  std::set<std::uint64_t> waiting_;  ///< in the order they have come
};

/// A permit that is given back at the end of its life. Whoever has it waits for nothing.
class Permit {
 public:
  /// Waits for it; without `permits` there is no limit.
  Permit(Permits* permits, const std::stop_token& stop) : permits_(permits) {
    if (permits_ != nullptr) permits_->take(stop);
  }
  Permit(const Permit&) = delete;
  Permit& operator=(const Permit&) = delete;
  ~Permit() {
    if (permits_ != nullptr) permits_->give_back();
  }

 private:
  Permits* permits_;
};

}  // namespace photic::run
