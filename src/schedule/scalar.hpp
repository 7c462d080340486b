// The scalar engine: one photon after the other.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "estimator/air_alone.hpp"
#include "estimator/analog/analog.hpp"
#include "estimator/bidirectional/bidirectional.hpp"
#include "estimator/forward/beside_walks.hpp"
#include "estimator/forward/history.hpp"
#include "estimator/forward/surface_echo.hpp"
#include "estimator/model.hpp"
#include "schedule/simulator.hpp"
#include "surface/oil.hpp"

namespace photic::schedule {

/// In the arithmetic of T.
template <class T>
class ScalarSimulator final : public Simulator {
 public:
  explicit ScalarSimulator(estimator::World<T> world) : world_(std::move(world)) {
    expect(!needs_histories(), "histories beside walks have a world of their own");
  }
  explicit ScalarSimulator(const estimator::Model& model)
      : world_(estimator::make_world<T>(model)) {
    if (needs_histories()) beside_walks_.emplace(model, world_);
    if (model.air) air_.emplace(model);
  }

 private:
  [[nodiscard]] bool needs_histories() const {
    return world_.estimator == scene::Estimator::bidirectional && surface::film_shines(world_.sea);
  }

  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    follow_into_water(first, count, tally);
    if (!air_) return;
    air_->follow(tally, [&](const estimator::World<T>& world) {
      if (world.estimator == scene::Estimator::bidirectional)
        return walks(world, first, count, tally);
      forward(world, first, count, tally);
    });
  }
  void follow_into_water(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const {
    switch (world_.estimator) {
      case scene::Estimator::automatic:  // left open: as forward
      case scene::Estimator::forward:
        return forward(world_, first, count, tally);
      case scene::Estimator::bidirectional:
        walks(world_, first, count, tally);
        if (!beside_walks_)
          return estimator::surface_echo<tally::Ledger>(world_, first, count, tally);
        return beside_walks_->follow(tally,
                                     [&] { forward(beside_walks_->world(), first, count, tally); });
      case scene::Estimator::analog:
        return estimator::Analog<T, tally::Ledger>(world_).run(first, count, tally,
                                                               [](const auto&...) {});
    }
  }

  static void walks(const estimator::World<T>& world, std::uint64_t first, std::uint64_t count,
                    tally::BatchTally& tally) {
    estimator::Bidirectional<T, tally::Ledger>(world, 1).run(first, count, tally);
  }
  static void forward(const estimator::World<T>& world, std::uint64_t first, std::uint64_t count,
                      tally::BatchTally& tally) {
    estimator::Travellers<T> photon(world);
    estimator::PathRatios<T> paths(world.sea.environments, 1);
    photon.ratios.paths = &paths;
    std::vector<estimator::Travellers<T>> copies;
    estimator::Estimates<T> estimates(world);
    const estimator::Draws<T> draws = draws_of_laser(world, first);
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(count); ++n) {
      if (world.all_events)
        follow<estimator::AllEvents>(world, draws, n, photon, copies, estimates, tally,
                                     [](const auto&) {});
      else
        follow<estimator::PlainEvents>(world, draws, n, photon, copies, estimates, tally,
                                       [](const auto&) {});
    }
  }

  estimator::World<T> world_;
  std::optional<estimator::BesideWalks<T>> beside_walks_;  ///< where a film shines
  std::optional<estimator::AirAlone<T>> air_;              ///< unless the air is clear
};

}  // namespace photic::schedule
