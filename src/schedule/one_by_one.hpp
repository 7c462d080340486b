// The scalar engine: one photon after the other, in the arithmetic of T.
#pragma once

#include <cstdint>

#include "estimator/forward/history.hpp"

namespace photic::schedule {

/// Histories of the forward estimator.
template <class T>
struct HistoriesOneByOne {
  using Number = T;
  using Ledger = tally::Ledger;
  using Passed = estimator::Passed<T>;
  using World = estimator::World<T>;

  static void run(const World& world, std::uint64_t first, std::uint64_t count,
                  tally::BatchTally& tally) {
    Passed none(world);
    run(world, first, count, tally, none);
  }
  /// Photons that leave the world's medium are added to `passed`.
  static void run(const World& world, std::uint64_t first, std::uint64_t count,
                  tally::BatchTally& tally, Passed& passed) {
    estimator::follow_in(
        world, tally, passed, [](const auto&) {}, first, count);
  }
  /// Photons that have come from the other medium.
  static void run(const World& world, Passed& arrivals, tally::BatchTally& tally, Passed& passed) {
    estimator::follow_in(
        world, tally, passed, [](const auto&) {}, arrivals);
  }
};

}  // namespace photic::schedule
