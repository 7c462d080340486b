// Simulators of the bidirectional estimator's walks, and of analog photons. Ledger: of one photon,
// or of lanes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/stop.hpp"
#include "estimator/analog/analog.hpp"
#include "estimator/bidirectional/bidirectional.hpp"
#include "schedule/simulator.hpp"
#include "schedule/spares.hpp"

namespace photic::schedule {

template <class T, class Ledger>
class WalksSimulator final : public SetSimulator {
 public:
  explicit WalksSimulator(estimator::World<T> world) : world_(std::move(world)) {}

  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Arrivals* /*passed*/,
           const std::stop_token& stop) const override {
    walks_.lend([&] { return std::make_unique<Walks>(world_, at_once(world_)); },
                [&](auto& walks) { walks.run(first, count, tally, BreakOff(stop)); });
  }

 private:
  using Walks = estimator::Bidirectional<T, Ledger>;
  /// So many that few packs are partly empty, and all stay in the second cache; fewer where many
  /// environments would take more memory than that. One photon at a time has no packs.
  static std::size_t at_once(const estimator::World<T>& world) {
    if (lanes_of<T> == 1) return 1;
    constexpr std::size_t wanted = 250;
    constexpr std::size_t bytes = 16'000'000;
    const std::size_t size = estimator::Walks<T>::size(world.slabs);
    const std::size_t fit = size > 0 ? std::min(wanted, bytes / size) : wanted;
    return std::max<std::size_t>(1, fit / world.walks.laser_walks);
  }

  estimator::World<T> world_;
  mutable Spares<Walks> walks_;
};

template <class T, class Ledger>
class AnalogSimulator final : public SetSimulator {
 public:
  explicit AnalogSimulator(estimator::World<T> world) : world_(std::move(world)) {}

  [[nodiscard]] std::unique_ptr<Arrivals> no_arrivals() const override {
    return std::make_unique<List>();
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
    [[nodiscard]] bool empty() const override { return photons.empty(); }

    estimator::AnalogPassed<T> photons;
  };

  template <class... From>
  void follow(const std::stop_token& stop, tally::BatchTally& tally, Arrivals* passed,
              From&&... from) const {
    List none;
    auto& photons = (passed != nullptr ? static_cast<List&>(*passed) : none).photons;
    estimator::Analog<T, Ledger>(world_, tally, photons).run(from..., BreakOff(stop));
  }

  estimator::World<T> world_;
};

}  // namespace photic::schedule
