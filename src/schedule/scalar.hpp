// The scalar engine: one photon after the other.
#pragma once

#include <utility>
#include <vector>

#include "estimator/analog/analog.hpp"
#include "estimator/bidirectional/bidirectional.hpp"
#include "estimator/forward/history.hpp"
#include "estimator/forward/surface_echo.hpp"
#include "estimator/model.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

/// In the arithmetic of T.
template <class T>
class ScalarSimulator final : public Simulator {
 public:
  explicit ScalarSimulator(estimator::World<T> world) : world_(std::move(world)) {}
  explicit ScalarSimulator(const estimator::Model& model)
      : world_(estimator::make_world<T>(model)) {}

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    switch (world_.estimator) {
      case scene::Estimator::automatic:  // left open: as forward
      case scene::Estimator::forward:
        return forward(first, count, tally);
      case scene::Estimator::bidirectional:
        estimator::Bidirectional<T, tally::Ledger>(world_, 1).run(first, count, tally);
        return estimator::surface_echo<tally::Ledger>(world_, first, count, tally);
      case scene::Estimator::analog:
        return estimator::Analog<T, tally::Ledger>(world_).run(first, count, tally,
                                                               [](const auto&...) {});
    }
  }

  void forward(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const {
    estimator::Travellers<T> photon(world_);
    estimator::PathRatios<T> paths(world_.sea.environments, 1);
    photon.ratios.paths = &paths;
    std::vector<estimator::Travellers<T>> copies;
    estimator::Estimates<T> estimates(world_);
    const estimator::Draws<T> draws = draws_of_laser(world_, first);
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(count); ++n) {
      if (world_.all_events)
        follow<estimator::AllEvents>(world_, draws, n, photon, copies, estimates, tally,
                                     [](const auto&) {});
      else
        follow<estimator::PlainEvents>(world_, draws, n, photon, copies, estimates, tally,
                                       [](const auto&) {});
    }
  }

  estimator::World<T> world_;
};

}  // namespace photic::schedule
