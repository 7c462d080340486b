// The simulator of the surface's own echo beside walks. Ledger: of one photon, or of lanes.
#pragma once

#include <cstdint>
#include <utility>

#include "core/stop.hpp"
#include "estimator/forward/surface_echo.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

template <class T, class Ledger>
class SurfaceEchoSimulator final : public SetSimulator {
 public:
  explicit SurfaceEchoSimulator(estimator::World<T> world) : world_(std::move(world)) {}

  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Arrivals* /*passed*/,
           const std::stop_token& stop) const override {
    estimator::surface_echo<Ledger>(world_, first, count, tally, BreakOff(stop));
  }

 private:
  estimator::World<T> world_;
};

}  // namespace photic::schedule
