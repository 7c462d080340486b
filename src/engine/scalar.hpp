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
      for (std::uint64_t i = first; i < first + count; ++i) {
        if (world_.special)
          follow_specially(world_, i, photon, copies, estimates, tally);
        else
          follow(world_, i, photon, estimates, tally);
      }
      return;
    }
    Bidirectional<T, tally::Ledger>(world_, 1).run(first, count, tally);
  }

 private:
  World<T> world_;
};

}  // namespace photic::engine
