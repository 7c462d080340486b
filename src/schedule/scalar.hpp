// The scalar engine: one photon after the other.
#pragma once

#include <utility>
#include <vector>

#include "estimator/bidirectional/bidirectional.hpp"
#include "estimator/forward/history.hpp"
#include "estimator/problem.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

/// In the arithmetic of T.
template <class T>
class ScalarSimulator final : public Simulator {
 public:
  explicit ScalarSimulator(estimator::World<T> world) : world_(std::move(world)) {}
  explicit ScalarSimulator(const estimator::Problem& problem)
      : world_(estimator::make_world<T>(problem.scene, problem.medium, problem.gates)) {}

  void simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    if (world_.walks == 0) {
      estimator::Travellers<T> photon(world_);
      transport::PathRatios<T> kept(world_.sea.environments, 1);
      photon.ratios.kept = &kept;
      std::vector<estimator::Travellers<T>> copies;
      estimator::Estimates<T> estimates(world_);
      const estimator::Draws<T> draws = estimator::draws_of_laser(world_, first);
      for (std::int32_t n = 0; n < static_cast<std::int32_t>(count); ++n) {
        if (world_.special)
          estimator::follow<true>(world_, draws, n, photon, copies, estimates, tally,
                                  [](const auto&) {});
        else
          estimator::follow<false>(world_, draws, n, photon, copies, estimates, tally,
                                   [](const auto&) {});
      }
      return;
    }
    estimator::Bidirectional<T, tally::Ledger>(world_, 1).run(first, count, tally);
  }

 private:
  estimator::World<T> world_;
};

}  // namespace photic::schedule
