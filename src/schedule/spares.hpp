// Large objects that each thread needs: used again from batch to batch.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace photic::schedule {

template <class Tools>
class Spares {
 public:
  /// Calls use(tools) with some that nobody else uses, made by make() if there are none. If that
  /// throws, they are not used again.
  template <class Make, class Use>
  void lend(Make make, Use use) {
    auto tools = take();
    if (!tools) tools = make();
    use(*tools);
    const std::scoped_lock lock(mutex_);
    spare_.push_back(std::move(tools));
  }

 private:
  std::unique_ptr<Tools> take() {
    const std::scoped_lock lock(mutex_);
    if (spare_.empty()) return nullptr;
    auto tools = std::move(spare_.back());
    spare_.pop_back();
    return tools;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Tools>> spare_;
};

}  // namespace photic::schedule
