// Lanes, compiled once for each instruction set, as PHOTIC_ISA (cmake/photic.cmake).
#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/pack.hpp"
#include "estimator/air.hpp"
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
  using Passed = Pool<Lanes>::Passed;

  void run(const estimator::World<Lanes>& world, std::uint64_t first, std::uint64_t count,
           tally::BatchTally& tally) {
    lend(world, [&](auto& pool) { pool.run(first, count, tally, [](const auto&...) {}); });
  }
  /// Who leaves the world's medium is told to `passed`.
  void run(const estimator::World<Lanes>& world, std::uint64_t first, std::uint64_t count,
           tally::BatchTally& tally, Passed& passed) {
    lend(world, [&](auto& pool) {
      pool.leave_to(passed);
      pool.run(first, count, tally, [](const auto&...) {});
    });
  }
  /// Of those who have come from the other medium.
  void run(const estimator::World<Lanes>& world, Passed& arrivals, tally::BatchTally& tally,
           Passed& passed) {
    lend(world, [&](auto& pool) {
      pool.leave_to(passed);
      pool.run(arrivals, tally);
    });
  }

 private:
  template <class Use>
  void lend(const estimator::World<Lanes>& world, Use use) {
    pools_.lend([&] { return std::make_unique<Pool<Lanes>>(world); }, use);
  }

  Spares<Pool<Lanes>> pools_;
};

/// Histories of light that may go from one medium to the other.
class BothMedia {
 public:
  /// The ledger's accounts are those of light that sets out in the water.
  void run(const estimator::World<Lanes>& setting_out, const estimator::World<Lanes>& water,
           const estimator::World<Lanes>& air, std::uint64_t first, std::uint64_t count,
           tally::BatchTally& tally) {
    Pools::Passed to_air(water), to_water(air);
    setting_out_.run(setting_out, first, count, tally, to_air);
    const tally::Ledger of_water = tally.ledger;
    air_.run(air, first, count, tally, to_water);
    while (to_air.photons.size() > 0 || to_water.photons.size() > 0) {
      air_.run(air, to_air, tally, to_water);
      water_.run(water, to_water, tally, to_air);
    }
    tally.ledger = of_water;
  }

 private:
  Pools setting_out_, water_, air_;
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

class ForwardLanes final : public Simulator {
 public:
  explicit ForwardLanes(const estimator::Model& model)
      : world_(estimator::make_world<Lanes>(model)) {
    if (model.air) air_.emplace(model, world_);
  }

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    if (air_) return both_media_.run(world_, world_, air_->air(), first, count, tally);
    pools_.run(world_, first, count, tally);
  }

  estimator::World<Lanes> world_;
  mutable Pools pools_;
  std::optional<estimator::AirWorlds<Lanes>> air_;  ///< unless the air is clear
  mutable BothMedia both_media_;
};

class BidirectionalLanes final : public Simulator {
 public:
  explicit BidirectionalLanes(const estimator::Model& model)
      : world_(estimator::make_world<Lanes>(model)) {
    if (surface::film_shines(world_.sea)) beside_walks_.emplace(model, world_);
    if (model.air) air_.emplace(model, world_);
  }

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    walks_.run(world_, first, count, tally);
    if (beside_walks_)
      return beside_walks_->follow(
          tally, [&] { pools_.run(beside_walks_->world(), first, count, tally); });
    estimator::surface_echo<lanes::LaneLedger<Lanes>>(world_, first, count, tally);
    if (!air_) return;
    const tally::Ledger of_water = tally.ledger;
    walks_in_air_.run(air_->air(), first, count, tally);
    const auto& beside = air_->beside_walks();
    both_media_.run(beside.setting_out, beside.water, beside.air, first, count, tally);
    tally.ledger = of_water;
  }

  estimator::World<Lanes> world_;
  mutable SetsOfWalks walks_, walks_in_air_;
  std::optional<estimator::BesideWalks<Lanes>> beside_walks_;  ///< where a film shines
  mutable Pools pools_;                                        ///< of them
  std::optional<estimator::AirWorlds<Lanes>> air_;             ///< unless the air is clear
  mutable BothMedia both_media_;                               ///< beside walks
};

class AnalogLanes final : public Simulator {
 public:
  explicit AnalogLanes(const estimator::Model& model)
      : world_(estimator::make_world<Lanes>(model)) {
    if (model.air) air_.emplace(model, world_);
  }

 private:
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    using Analog = estimator::Analog<Lanes, lanes::LaneLedger<Lanes>>;
    (air_ ? Analog(world_, air_->air()) : Analog(world_))
        .run(first, count, tally, [](const auto&...) {});
  }

  estimator::World<Lanes> world_;
  std::optional<estimator::AirWorlds<Lanes>> air_;  ///< unless the air is clear
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
