// The scalar engine: one photon after the other.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "estimator/air.hpp"
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
    if (model.air) air_.emplace(model, world_);
  }

 private:
  using World = estimator::World<T>;
  using Passed = estimator::Passed<T>;

  [[nodiscard]] bool needs_histories() const {
    return world_.estimator == scene::Estimator::bidirectional && surface::film_shines(world_.sea);
  }

  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    switch (world_.estimator) {
      case scene::Estimator::automatic:  // left open: as forward
      case scene::Estimator::forward:
        if (air_) return in_both_media(world_, world_, air_->air(), first, count, tally);
        return forward(world_, first, count, tally);
      case scene::Estimator::bidirectional:
        return bidirectional(first, count, tally);
      case scene::Estimator::analog:
        using Analog = estimator::Analog<T, tally::Ledger>;
        return (air_ ? Analog(world_, air_->air()) : Analog(world_))
            .run(first, count, tally, [](const auto&...) {});
    }
  }

  void bidirectional(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const {
    walks(world_, first, count, tally);
    if (beside_walks_)
      return beside_walks_->follow(tally,
                                   [&] { forward(beside_walks_->world(), first, count, tally); });
    estimator::surface_echo<tally::Ledger>(world_, first, count, tally);
    if (!air_) return;
    const tally::Ledger of_water = tally.ledger;
    walks(air_->air(), first, count, tally);
    const auto& beside = air_->beside_walks();
    in_both_media(beside.setting_out, beside.water, beside.air, first, count, tally);
    tally.ledger = of_water;
  }
  static void walks(const World& world, std::uint64_t first, std::uint64_t count,
                    tally::BatchTally& tally) {
    estimator::Bidirectional<T, tally::Ledger>(world, 1).run(first, count, tally);
  }

  /// Histories of light that may go from one medium to the other. The ledger's accounts are those
  /// of light that sets out in the water.
  static void in_both_media(const World& setting_out, const World& water, const World& air,
                            std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) {
    Passed to_air(water), to_water(air);
    forward(setting_out, first, count, tally, to_air);
    const tally::Ledger of_water = tally.ledger;
    forward(air, first, count, tally, to_water);
    while (!to_air.photons.empty() || !to_water.photons.empty()) {
      go_on(air, to_air, to_water, tally);
      go_on(water, to_water, to_air, tally);
    }
    tally.ledger = of_water;
  }
  static void forward(const World& world, std::uint64_t first, std::uint64_t count,
                      tally::BatchTally& tally) {
    Passed none(world);
    forward(world, first, count, tally, none);
  }
  static void forward(const World& world, std::uint64_t first, std::uint64_t count,
                      tally::BatchTally& tally, Passed& passed) {
    estimator::Travellers<T> photon(world);
    estimator::PathRatios<T> paths(world.sea.environments, 1);
    photon.ratios.paths = &paths;
    std::vector<estimator::Travellers<T>> copies;
    estimator::Estimates<T> estimates(world);
    const estimator::Draws<T> draws = draws_of_laser(world, first);
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(count); ++n) {
      if (world.all_events)
        follow<estimator::AllEvents>(world, draws, n, photon, copies, passed, estimates, tally,
                                     [](const auto&) {});
      else
        follow<estimator::PlainEvents>(world, draws, n, photon, copies, passed, estimates, tally,
                                       [](const auto&) {});
    }
  }
  static void go_on(const World& world, Passed& arrivals, Passed& passed,
                    tally::BatchTally& tally) {
    estimator::PathRatios<T> paths(world.sea.environments, 1);
    std::vector<estimator::Travellers<T>> copies;
    estimator::Estimates<T> estimates(world);
    if (world.all_events)
      follow<estimator::AllEvents>(world, arrivals, paths, copies, passed, estimates, tally);
    else
      follow<estimator::PlainEvents>(world, arrivals, paths, copies, passed, estimates, tally);
  }

  World world_;
  std::optional<estimator::BesideWalks<T>> beside_walks_;  ///< where a film shines
  std::optional<estimator::AirWorlds<T>> air_;             ///< unless the air is clear
};

}  // namespace photic::schedule
