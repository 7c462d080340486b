// Histories of the forward estimator in lanes.
#pragma once

#include <cstdint>
#include <memory>

#include "schedule/pool.hpp"
#include "schedule/spares.hpp"

namespace photic::schedule {

/// The pools of one world, which is always the same.
template <class T>
class Pools {
 public:
  using Number = T;
  using Ledger = lanes::LaneLedger<T>;
  using Passed = typename Pool<T>::Passed;
  using World = estimator::World<T>;

  void run(const World& world, std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) {
    lend(world, [&](auto& pool) { pool.run(first, count, tally, [](const auto&...) {}); });
  }
  /// Photons that leave the world's medium are added to `passed`.
  void run(const World& world, std::uint64_t first, std::uint64_t count, tally::BatchTally& tally,
           Passed& passed) {
    lend(world, [&](auto& pool) {
      pool.leave_to(passed);
      pool.run(first, count, tally, [](const auto&...) {});
    });
  }
  /// Photons that have come from the other medium.
  void run(const World& world, Passed& arrivals, tally::BatchTally& tally, Passed& passed) {
    lend(world, [&](auto& pool) {
      pool.leave_to(passed);
      pool.run(arrivals, tally);
    });
  }

 private:
  template <class Use>
  void lend(const World& world, Use use) {
    pools_.lend([&] { return std::make_unique<Pool<T>>(world); }, use);
  }

  Spares<Pool<T>> pools_;
};

}  // namespace photic::schedule
