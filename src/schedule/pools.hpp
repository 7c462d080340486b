// Histories of the forward estimator in lanes.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "core/stop.hpp"
#include "schedule/pool.hpp"
#include "schedule/spares.hpp"

namespace photic::schedule {

template <class T>
class Pools final : public SetSimulator {
 public:
  explicit Pools(estimator::World<T> world) : world_(std::move(world)) {}

  [[nodiscard]] std::unique_ptr<Arrivals> no_arrivals() const override {
    return std::make_unique<Passed>(world_);
  }
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Arrivals* passed,
           const std::stop_token& stop) const override {
    lend(passed, [&](auto& pool) { pool.run(first, count, tally, BreakOff(stop)); });
  }
  void run(Arrivals& arrivals, tally::BatchTally& tally, Arrivals* passed,
           const std::stop_token& stop) const override {
    lend(passed,
         [&](auto& pool) { pool.run(static_cast<Passed&>(arrivals), tally, BreakOff(stop)); });
  }

 private:
  using Passed = typename Pool<T>::Passed;

  template <class Use>
  void lend(Arrivals* passed, Use use) const {
    pools_.lend([&] { return std::make_unique<Pool<T>>(world_); },
                [&](auto& pool) {
                  pool.leave_to(static_cast<Passed*>(passed));
                  use(pool);
                });
  }

  estimator::World<T> world_;
  mutable Spares<Pool<T>> pools_;
};

}  // namespace photic::schedule
