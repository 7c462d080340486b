// Lanes, compiled once for each instruction set, as PHOTIC_ISA (cmake/photic.cmake).
#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/pack.hpp"
#include "estimator/air_alone.hpp"
#include "estimator/analog/analog.hpp"
#include "estimator/bidirectional/bidirectional.hpp"
#include "estimator/forward/beside_walks.hpp"
#include "estimator/forward/surface_echo.hpp"
#include "lanes/lane_ledger.hpp"
#include "schedule/engines.hpp"
#include "schedule/pool.hpp"
#include "surface/oil.hpp"

namespace photic::schedule {
namespace {

using Lanes = Pack<float, native::float_lanes>;

/// What each thread needs and is large: used again from batch to batch.
template <class Tools>
class Spares {
 public:
  /// Calls use(tools) with some that nobody else uses, made by make() if there are none.
  template <class Make, class Use>
  void lend(Make make, Use use) {
    auto tools = take();
    if (!tools) tools = make();
    use(*tools);
    const std::scoped_lock lock(mutex_);
    spare_.push_back(std::move(tools));
  }

 private:
  std::unique_ptr<Tools> take() {
    const std::scoped_lock lock(mutex_);
    if (spare_.empty()) return nullptr;
    auto tools = std::move(spare_.back());
    spare_.pop_back();
    return tools;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Tools>> spare_;
};

/// Forward histories of a world.
class Pools {
 public:
  void run(const estimator::World<Lanes>& world, std::uint64_t first, std::uint64_t count,
           tally::BatchTally& tally) {
    pools_.lend([&] { return std::make_unique<Pool<Lanes>>(world); },
                [&](auto& pool) { pool.run(first, count, tally, [](const auto&...) {}); });
  }

 private:
  Spares<Pool<Lanes>> pools_;
};

/// Sets of walks of a world.
class SetsOfWalks {
 public:
  void run(const estimator::World<Lanes>& world, std::uint64_t first, std::uint64_t count,
           tally::BatchTally& tally) {
    walks_.lend([&] { return std::make_unique<Walks>(world, at_once(world)); },
                [&](auto& walks) { walks.run(first, count, tally); });
  }

 private:
  using Walks = estimator::Bidirectional<Lanes, lanes::LaneLedger<Lanes>>;
  /// So many that few packs are partly empty, and all stay in the second cache; fewer where many
  /// environments would take more memory than that.
  static std::size_t at_once(const estimator::World<Lanes>& world) {
    constexpr std::size_t wanted = 250;
    constexpr std::size_t bytes = 16'000'000;
    const std::size_t size = estimator::Walks<Lanes>::size(world.sea.environments);
    const std::size_t fit = size > 0 ? std::min(wanted, bytes / size) : wanted;
    return std::max<std::size_t>(1, fit / world.walks);
  }

  Spares<Walks> walks_;
};

/// Light that stays in the air.
template <class Histories>
class AirLanes {
 public:
  explicit AirLanes(const estimator::Model& model) {
    if (model.air) air_.emplace(model);
  }
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) {
    if (!air_) return;
    air_->follow(tally, [&](const auto& world) { histories_.run(world, first, count, tally); });
  }

 private:
  std::optional<estimator::AirAlone<Lanes>> air_;
  Histories histories_;
};

class ForwardLanes final : public Simulator {
 public:
  explicit ForwardLanes(const estimator::Model& model)
      : world_(estimator::make_world<Lanes>(model)), air_(model) {}

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    pools_.run(world_, first, count, tally);
    air_.run(first, count, tally);
  }

  estimator::World<Lanes> world_;
  mutable Pools pools_;
  mutable AirLanes<Pools> air_;
};

class BidirectionalLanes final : public Simulator {
 public:
  explicit BidirectionalLanes(const estimator::Model& model)
      : world_(estimator::make_world<Lanes>(model)), air_(model) {
    if (surface::film_shines(world_.sea)) beside_walks_.emplace(model, world_);
  }

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    walks_.run(world_, first, count, tally);
    air_.run(first, count, tally);
    if (!beside_walks_)
      return estimator::surface_echo<lanes::LaneLedger<Lanes>>(world_, first, count, tally);
    beside_walks_->follow(tally, [&] { pools_.run(beside_walks_->world(), first, count, tally); });
  }

  estimator::World<Lanes> world_;
  mutable SetsOfWalks walks_;
  mutable AirLanes<SetsOfWalks> air_;
  std::optional<estimator::BesideWalks<Lanes>> beside_walks_;  ///< where a film shines
  mutable Pools pools_;                                        ///< of them
};

class AnalogLanes final : public Simulator {
 public:
  explicit AnalogLanes(const estimator::Model& model)
      : world_(estimator::make_world<Lanes>(model)) {}

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    estimator::Analog<Lanes, lanes::LaneLedger<Lanes>>(world_).run(first, count, tally,
                                                                   [](const auto&...) {});
  }

  estimator::World<Lanes> world_;
};

}  // namespace

namespace PHOTIC_ISA {
std::unique_ptr<Simulator> make_lane_simulator(const estimator::Model& model);
std::unique_ptr<Simulator> make_lane_simulator(const estimator::Model& model) {
  switch (model.scene.simulation.estimator) {
    case scene::Estimator::bidirectional:
      return std::make_unique<BidirectionalLanes>(model);
    case scene::Estimator::analog:
      return std::make_unique<AnalogLanes>(model);
    case scene::Estimator::automatic:  // left open: as forward
    case scene::Estimator::forward:
      break;
  }
  return std::make_unique<ForwardLanes>(model);
}
}  // namespace PHOTIC_ISA

}  // namespace photic::schedule
