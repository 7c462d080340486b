// The scalar engine: one photon after the other, in the arithmetic of T.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "core/stop.hpp"
#include "estimator/forward/history.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

/// Histories of the forward estimator.
template <class T>
class HistoriesOneByOne final : public SetSimulator {
 public:
  explicit HistoriesOneByOne(estimator::World<T> world) : world_(std::move(world)) {}

  [[nodiscard]] std::unique_ptr<Arrivals> no_arrivals() const override {
    return std::make_unique<List>(world_);
  }
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Arrivals* passed,
           const std::stop_token& stop) const override {
    follow(stop, tally, passed, first, count);
  }
  void run(Arrivals& arrivals, tally::BatchTally& tally, Arrivals* passed,
           const std::stop_token& stop) const override {
    follow(stop, tally, passed, static_cast<List&>(arrivals).photons);
  }

 private:
  struct List final : Arrivals {
    explicit List(const estimator::World<T>& world) : photons(world) {}
    [[nodiscard]] bool empty() const override { return photons.photons.empty(); }

    estimator::Passed<T> photons;
  };

  /// `from`: as follow_in() takes it.
  template <class... From>
  void follow(const std::stop_token& stop, tally::BatchTally& tally, Arrivals* passed,
              From&&... from) const {
    List none(world_);
    estimator::follow_in(world_, tally,
                         (passed != nullptr ? static_cast<List&>(*passed) : none).photons,
                         BreakOff(stop), std::forward<From>(from)...);
  }

  estimator::World<T> world_;
};

}  // namespace photic::schedule
