// Many photons on their way at once, in packs.
//
// All packs go through a stage of an event before any goes through the next one: each stage is a
// small loop, whose registers are its own. Then the lanes of photons that have ended are given to
// others, so that packs stay full. The photons that get lanes, and the order in which packs are
// scored, follow from the photons alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/flatten.hpp"
#include "core/pack.hpp"
#include "estimator/forward/history.hpp"
#include "lanes/lane_ledger.hpp"
#include "schedule/reserve.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

template <class T>
class Pool {
 public:
  /// Photons on their way from one medium to the other.
  struct Passed final : Arrivals {
    explicit Passed(const estimator::World<T>& world)
        : photons(Carried{}), ratios(world.slabs.environments, 0) {}
    [[nodiscard]] bool empty() const override { return photons.size() == 0; }

    Reserve<T> photons;
    estimator::PathRatios<T> ratios;  ///< of each, in environments
  };
  static constexpr std::size_t width = lanes_of<T>;
  /// The number of slots, so that all of them stay in the first cache, and few packs are partly
  /// empty.
  static constexpr std::size_t slots = 128;
  static constexpr std::size_t packs = slots / width;

  explicit Pool(const estimator::World<T>& world)
      : world_(world),
        ratios_(world.slabs.environments, 2 * slots),
        lens_(2 * packs * estimator::lens_points(world)),
        pack_(packs, estimator::ForwardTracks<T>(world, {})),
        reserve_(carried_in(world)),
        newborn_(pack_),
        estimates_(world) {
    for (std::size_t k = 0; k < packs; ++k) {
      pack_[k].ratios.paths = newborn_[k].ratios.paths = &ratios_;
      pack_[k].ratios.first = k * width;
      newborn_[k].ratios.first = slots + k * width;
      pack_[k].lens = lens_of(k);
      newborn_[k].lens = lens_of(packs + k);
    }
  }

  /// Follows photons `first` … `first + count - 1`, the first of a batch and up, to their ends.
  /// `witness` is called at the end of each event with each pack and the mask of the photons that
  /// were on their way before.
  template <class Witness>
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Witness witness) {
    draws_.emplace(estimator::draws_of_laser<T>(world_.random, first));
    next_ = 0;
    count_ = count;
    run(tally, witness);
  }
  /// Follows the photons that have come from the other medium.
  template <class Witness>
  void run(Passed& arrivals, tally::BatchTally& tally, Witness witness) {
    next_ = count_ = 0;
    arrivals_ = &arrivals;
    run(tally, witness);
    arrivals_ = nullptr;
  }
  /// Sets the list that takes the photons that go on to the other medium.
  void leave_to(Passed* passed) { passed_ = passed; }

 private:
  template <class Witness>
  void run(tally::BatchTally& tally, Witness witness) {
    if (world_.all_events)
      run<estimator::AllEvents>(tally, witness);
    else
      run<estimator::PlainEvents>(tally, witness);
    estimator::flush_queues(world_, estimates_, tally);
    tally.ledger += total(ledger_);
    ledger_ = {};
  }
  template <class Events, class Witness>
  void run(tally::BatchTally& tally, Witness& witness) {
    auto steps =
        steps_of<Events>(tally, [this](std::uint32_t block) { draw(on_the_way(), block); });
    for (fill<Events>(tally); used_ > 0; fill<Events>(tally)) {
      collide<Events>(steps, on_the_way());
      show(witness);
      if constexpr (Events::tools) keep_copies(tally);
      fly<Events>(steps, on_the_way());
    }
  }
  template <class Events>
  using Steps = estimator::ForwardSteps<Events, T, lanes::LaneLedger<T>>;
  template <class Events>
  Steps<Events> steps_of(tally::BatchTally& tally, std::function<void(std::uint32_t)> draw) {
    return {world_,
            ledger_,
            tally,
            estimates_,
            std::move(draw),
            [this](estimator::ForwardTracks<T>& gone, std::int32_t copy) {
              number_anew(gone, copy);
              leave(gone);
            }};
  }
  /// Packs that go through a stage together.
  struct Each {
    estimator::ForwardTracks<T>* pack;
    std::size_t count;

    template <class Stage>
    PHOTIC_APART PHOTIC_FLATTEN void operator()(Stage stage) const {
      for (std::size_t k = 0; k < count; ++k) stage(pack[k]);
    }
  };
  estimator::LensPoints<T> lens_of(std::size_t pack) {
    const std::size_t points = estimator::lens_points(world_);
    return estimator::LensPoints<T>(lens_).subspan(pack * points, points);
  }
  Each on_the_way() { return {pack_.data(), used_}; }
  // Each is compiled once: whoever it is called for.
  template <class Events>
  PHOTIC_APART static void fly(Steps<Events>& steps, const Each& each) {
    estimator::flights(steps, each);
  }
  template <class Events>
  PHOTIC_APART static void collide(Steps<Events>& steps, const Each& each) {
    estimator::collisions(steps, each);
  }
  /// They draw random numbers of their own.
  void number_anew(estimator::ForwardTracks<T>& copies, std::int32_t copy) const {
    for_each_lane(copies.on, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      copies.place.photon.set(i, estimator::copy_number(world_.random.key, copies.place.photon[i],
                                                        copies.place.event[i], copy));
    });
  }
  /// Draws a block of random numbers for packs, two at once.
  PHOTIC_APART PHOTIC_FLATTEN static void draw(const Each& each, std::uint32_t block) {
    auto [pack, count] = each;
    for (; count >= 2; count -= 2, pack += 2) {
      const auto [first, second] = uniforms(pack[0].place, pack[1].place, block);
      pack[0].numbers(block) = first;
      pack[1].numbers(block) = second;
    }
    if (count > 0) pack->numbers(block) = uniforms(pack->place, block);
  }
  template <class Witness>
  void show(Witness& witness) {
    for (std::size_t k = 0; k < used_; ++k) witness(pack_[k], before_[k]);
  }

  /// Gives the lanes of photons that have ended to those that wait, to new photons, or to the last
  /// ones.
  template <class Events>
  PHOTIC_APART void fill(tally::BatchTally& tally) {
    for (std::size_t k = 0; k < packs; ++k) {
      const Mask<T> free = !pack_[k].on;
      while (reserve_.size() < count(free) && fetch<Events>(k + 1, tally)) {
      }
      if (reserve_.size() > 0) refill(pack_[k], free);
      before_[k] = pack_[k].on;
      if (any(pack_[k].on)) used_ = std::max(used_, k + 1);
    }
    while (used_ > 0 && !any(pack_[used_ - 1].on)) --used_;
  }
  /// Has more photons wait: new ones, or else those of the last pack from number `first` on.
  /// Returns whether there were any.
  template <class Events>
  bool fetch(std::size_t first, tally::BatchTally& tally) {
    if (next_ < count_) {
      births<Events>(tally);
      return true;
    }
    if (arrivals_ != nullptr && arrivals_->photons.size() > 0) {
      arrive<Events>(tally);
      return true;
    }
    if (used_ <= first) return false;
    estimator::ForwardTracks<T>& last = pack_[--used_];
    wait(last);
    last.on = last.colliding = Mask<T>(false);
    return true;
  }
  /// The next photons of the batch, to where their first flight ends.
  template <class Events>
  PHOTIC_APART void births(tally::BatchTally& tally) {
    const auto first = static_cast<std::int32_t>(next_);
    const std::size_t born = std::min(packs, (count_ - next_ + width - 1) / width);
    const Each all{newborn_.data(), born};
    const auto number_of = [&](const estimator::ForwardTracks<T>& t) {
      return first +
             static_cast<std::int32_t>(width) * static_cast<std::int32_t>(&t - newborn_.data());
    };
    if (estimator::has_environments<Events>(world_)) {
      for (std::size_t i = 0; i < born * width; ++i)
        ratios_.of(newborn_.front().ratios.first + i).begin(world_.slabs.environments);
    }
    auto steps = steps_of<Events>(tally, [&](std::uint32_t block) {
      all([&](auto& t) { t.numbers(block) = draws_->together(number_of(t), 1, block); });
    });
    all([&](auto& t) {
      const std::int32_t n = number_of(t);
      estimator::birth<Events>(world_, *draws_, n,
                               first_lanes<T>(count_ - static_cast<std::uint64_t>(n)), t,
                               estimates_, tally, ledger_, steps.leave);
    });
    next_ += born * width;
    fly<Events>(steps, all);
    all([&](auto& t) { wait(t); });
  }
  /// Takes the next photons from the other medium to the end of their first flight here.
  template <class Events>
  PHOTIC_APART void arrive(tally::BatchTally& tally) {
    std::size_t came = 0;
    for (; came < packs && arrivals_->photons.size() > 0; ++came) arrive(newborn_[came]);
    const Each all{newborn_.data(), came};
    auto steps = steps_of<Events>(tally, [&](std::uint32_t block) { draw(all, block); });
    fly<Events>(steps, all);
    all([&](auto& t) { wait(t); });
  }
  void arrive(estimator::ForwardTracks<T>& pack) {
    pack.on = arrivals_->photons.pop(Mask<T>(true), pack);
    if (!world_.has_environments) [[likely]]
      return;
    std::size_t path = arrivals_->photons.size();
    for_each_lane(pack.on, [&](int lane) {
      ratios_.copy(world_.slabs.environments, arrivals_->ratios, path++,
                   pack.ratios.first + static_cast<std::size_t>(lane));
    });
  }
  /// Has photons that go on to the other medium wait to be followed there.
  void leave(estimator::ForwardTracks<T>& gone) {
    std::size_t path = passed_->photons.size();
    passed_->photons.push(gone.on, gone);
    if (!world_.has_environments) [[likely]]
      return;
    for_each_lane(gone.on, [&](int lane) {
      passed_->ratios.copy(world_.slabs.environments, ratios_,
                           gone.ratios.first + static_cast<std::size_t>(lane), path++);
    });
  }
  /// Has the photons on their way in a pack wait.
  void wait(estimator::ForwardTracks<T>& pack) {
    if (world_.has_environments) [[unlikely]]
      copy_ratios(pack.ratios.first, pack.on, false);
    reserve_.push(pack.on, pack);
  }
  PHOTIC_APART PHOTIC_FLATTEN void refill(estimator::ForwardTracks<T>& pack, const Mask<T>& free) {
    const Mask<T> given = reserve_.pop(free, pack);
    if (world_.has_environments) [[unlikely]]
      copy_ratios(pack.ratios.first, given, true);
    pack.on = pack.on | given;
  }

  /// The copies of photons that were split, each with random numbers of its own, fly and wait.
  void keep_copies(tally::BatchTally& tally) {
    for (std::size_t k = 0; k < used_; ++k) {
      const estimator::ForwardTracks<T>& pack = pack_[k];
      std::int32_t i = 0;
      for (Mask<T> more = pack.on & (pack.copies > Index<T>(i)); any(more);
           more = pack.on & (pack.copies > Index<T>(++i)))
        keep_copies(pack, more, i, tally);
    }
  }
  PHOTIC_APART void keep_copies(const estimator::ForwardTracks<T>& pack, const Mask<T>& mask,
                                std::int32_t number, tally::BatchTally& tally) {
    estimator::ForwardTracks<T>& copies = newborn_.front();
    copies.copy(pack);
    copies.on = mask;
    number_anew(copies, number);
    if (world_.has_environments)
      for_each_lane(mask, [&](int lane) {
        const auto i = static_cast<std::size_t>(lane);
        ratios_.copy(world_.slabs.environments, pack.ratios.first + i, copies.ratios.first + i);
      });
    const Each all{&copies, 1};
    auto steps =
        steps_of<estimator::AllEvents>(tally, [&](std::uint32_t block) { draw(all, block); });
    fly<estimator::AllEvents>(steps, all);
    wait(copies);
  }

  /// Copies the ratios of a mask's lanes, of a pack whose paths begin with `first`, to the photons
  /// that wait next, or back.
  PHOTIC_APART void copy_ratios(std::size_t first, const Mask<T>& mask, bool to_lanes) {
    std::size_t waiting = 2 * slots + reserve_.size();
    for_each_lane(mask, [&](int lane) {
      const std::size_t here = first + static_cast<std::size_t>(lane);
      ratios_.copy(world_.slabs.environments, to_lanes ? waiting : here, to_lanes ? here : waiting);
      ++waiting;
    });
  }

  const estimator::World<T>& world_;
  estimator::PathRatios<T> ratios_;  ///< of each slot and each waiting photon, in environments
  std::vector<instrument::PlanePoint<T>> lens_;  ///< [pack, then newborn][group]
  std::vector<estimator::ForwardTracks<T>> pack_;
  std::size_t used_ = 0;                 ///< of the packs, the first ones
  std::array<Mask<T>, packs> before_{};  ///< the photons on their way when an event began

  Reserve<T> reserve_;
  Passed* arrivals_ = nullptr;
  Passed* passed_ = nullptr;
  std::vector<estimator::ForwardTracks<T>> newborn_;  ///< on their first flight
  std::optional<estimator::Draws<T>> draws_;          ///< of the batch
  std::uint64_t next_ = 0, count_ = 0;                ///< its photons that have yet to set out
  lanes::LaneLedger<T> ledger_;
  estimator::Estimates<T> estimates_;
};

}  // namespace photic::schedule
