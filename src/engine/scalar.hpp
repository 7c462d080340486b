// The scalar engine: one photon after the other.
#pragma once

#include <utility>
#include <vector>

#include "engine/bidirectional.hpp"
#include "engine/history.hpp"
#include "engine/problem.hpp"
#include "engine/simulator.hpp"

namespace photic::engine {

/// In the arithmetic of T.
template <class T>
class ScalarSimulator final : public Simulator {
 public:
  explicit ScalarSimulator(World<T> world) : world_(std::move(world)) {}
  explicit ScalarSimulator(const Problem& problem)
      : world_(make_world<T>(problem.scene, problem.medium, problem.gates)) {}

  void simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    if (world_.walks == 0) {
      Travellers<T> photon(world_);
      transport::PathRatios<T> kept(world_.sea.environments, 1);
      photon.ratios.kept = &kept;
      std::vector<Travellers<T>> copies;
      Estimates<T> estimates(world_);
      const Draws<T> draws = draws_of_laser(world_, first);
      for (std::int32_t n = 0; n < static_cast<std::int32_t>(count); ++n) {
        if (world_.special)
          follow<true>(world_, draws, n, photon, copies, estimates, tally, [](const auto&) {});
        else
          follow<false>(world_, draws, n, photon, copies, estimates, tally, [](const auto&) {});
      }
      return;
    }
    Bidirectional<T, tally::Ledger>(world_, 1).run(first, count, tally);
  }

 private:
  World<T> world_;
};

}  // namespace photic::engine
