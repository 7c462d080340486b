// Simulators of the bidirectional estimator, and of analog photons. Ledger: of one photon, or of
// lanes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "estimator/air.hpp"
#include "estimator/analog/analog.hpp"
#include "estimator/bidirectional/bidirectional.hpp"
#include "estimator/make_world.hpp"
#include "schedule/simulator.hpp"
#include "schedule/spares.hpp"

namespace photic::schedule {

/// Sets of walks of a world.
template <class T, class Ledger>
class SetsOfWalks {
 public:
  void run(const estimator::World<T>& world, std::uint64_t first, std::uint64_t count,
           tally::BatchTally& tally) {
    walks_.lend([&] { return std::make_unique<Walks>(world, at_once(world)); },
                [&](auto& walks) { walks.run(first, count, tally); });
  }

 private:
  using Walks = estimator::Bidirectional<T, Ledger>;
  /// So many that few packs are partly empty, and all stay in the second cache; fewer where many
  /// environments would take more memory than that. One photon at a time has no packs.
  static std::size_t at_once(const estimator::World<T>& world) {
    if (lanes_of<T> == 1) return 1;
    constexpr std::size_t wanted = 250;
    constexpr std::size_t bytes = 16'000'000;
    const std::size_t size = estimator::Walks<T>::size(world.sea);
    const std::size_t fit = size > 0 ? std::min(wanted, bytes / size) : wanted;
    return std::max<std::size_t>(1, fit / world.walks);
  }

  Spares<Walks> walks_;
};

/// The bidirectional estimator. Its ledger is that of the walks in the water, which the laser's
/// light is in.
template <class T, class Ledger>
class BidirectionalSimulator final : public Simulator {
 public:
  BidirectionalSimulator(const estimator::Model& model, BesideWalks beside)
      : world_(estimator::make_world<T>(model)), beside_(std::move(beside)) {
    if (model.air) air_.emplace(model, world_);
  }
  BidirectionalSimulator(estimator::World<T> world, BesideWalks beside)
      : world_(std::move(world)), beside_(std::move(beside)) {}

  void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    walks_.run(world_, first, count, tally);
    const tally::Ledger of_water = tally.ledger;
    if (beside_.in_water) beside_.in_water->add(first, count, tally);
    if (air_) walks_in_air_.run(air_->air(), first, count, tally);
    if (beside_.in_air) beside_.in_air->add(first, count, tally);
    tally.ledger = of_water;
  }

 private:
  estimator::World<T> world_;
  std::optional<estimator::AirWorld<T>> air_;  ///< unless the air is clear
  BesideWalks beside_;
  mutable SetsOfWalks<T, Ledger> walks_, walks_in_air_;
};

template <class T, class Ledger>
class AnalogSimulator final : public Simulator {
 public:
  explicit AnalogSimulator(const estimator::Model& model)
      : world_(estimator::make_world<T>(model)) {
    if (model.air) air_.emplace(model, world_);
  }
  explicit AnalogSimulator(estimator::World<T> world) : world_(std::move(world)) {}

  void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    using Analog = estimator::Analog<T, Ledger>;
    (air_ ? Analog(world_, air_->air()) : Analog(world_))
        .run(first, count, tally, [](const auto&...) {});
  }

 private:
  estimator::World<T> world_;
  std::optional<estimator::AirWorld<T>> air_;  ///< unless the air is clear
};

}  // namespace photic::schedule
