// Many photons on their way at once, walked a pack at a time.
//
// Photons live in the slots of a pool. A sweep takes every pack of slots through one event; then
// the slots of those who have ended are given to new photons, so that packs stay full. Slots are
// filled and packs are scored in an order that follows from the photons alone.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "core/flatten.hpp"
#include "core/pack.hpp"
#include "engine/history.hpp"
#include "engine/lane_ledger.hpp"
#include "engine/simulator.hpp"

namespace photic::engine {

/// One member of the photons of a pool, slot by slot, and of the copies that wait for one.
template <class E, std::size_t slots>
struct alignas(64) Column {
  std::array<E, slots> slot{};
  std::vector<E> waiting;
};

template <class T>
class Pool {
 public:
  /// Such that all of it stays in the first cache, and few packs are partly empty.
  static constexpr std::size_t slots = 256;
  static constexpr std::size_t width = lanes_of<T>;

  explicit Pool(const World<T>& world)
      : world_(world),
        lens_(world.telescopes.size()),
        ratios_(world.sea.environments, slots),
        travellers_(world),
        newborn_(world),
        estimates_(world) {
    travellers_.lens.resize(world.single_rays ? lens_.size() : 0);
    travellers_.ratios.kept = &ratios_;
  }

  /// Follows photons `first` … `first + count - 1` to their ends. `witness` is told of the packs
  /// before and after each event.
  template <class Witness>
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Witness witness) {
    next_ = first;
    last_ = first + count;
    born_ = width;
    used_ = 0;
    if (world_.special)
      run<true>(tally, witness);
    else
      run<false>(tally, witness);
    tally.ledger = tally.ledger + total(ledger_);
    ledger_ = {};
  }

 private:
  template <bool special, class Witness>
  PHOTIC_APART PHOTIC_FLATTEN void run(tally::BatchTally& tally, Witness& witness) {
    while (used_ < slots && emerge()) settle(used_++);
    while (used_ > 0) {
      for (std::size_t k = 0; k < used_; k += width) {
        load(k);
        const Mask<T> before = first_lanes<T>(used_ - k);
        const Mask<T> on =
            next_event<special>(world_, travellers_, before, ledger_, tally, estimates_);
        witness(travellers_, before, on);
        store(k);
        on_[k / width] = lane_bits(on);
        if constexpr (special) keep_copies(k, on);
      }
      replace();
      while (special && used_ < slots && revive(used_)) ++used_;
    }
    close_rooms(world_, estimates_, tally);
  }

  /// Calls f(a member of the travellers, its column) for every member that a slot keeps.
  template <class F>
  void columns(Travellers<T>& t, F f) {
    f(t.photon.position.x, x_);
    f(t.photon.position.y, y_);
    f(t.photon.position.z, z_);
    f(t.photon.direction.x, u_);
    f(t.photon.direction.y, v_);
    f(t.photon.direction.z, w_);
    f(t.photon.weight, weight_);
    f(t.photon.analog_weight, analog_weight_);
    f(t.photon.path, path_);
    f(t.photon.line, line_);
    f(t.photon.layer, layer_);
    f(t.photon.order, order_);
    f(t.place.photon, number_);
    f(t.place.event, event_);
    if (world_.sea.bands > 0) f(t.hue, hue_);
    for (std::size_t i = 0; i < t.lens.size(); ++i) {
      f(t.lens[i].x, lens_[i][0]);
      f(t.lens[i].y, lens_[i][1]);
    }
  }
  void load(std::size_t k) {
    columns(travellers_, [k](auto& member, const auto& column) {
      member = std::decay_t<decltype(member)>::load(column.slot.data() + k);
    });
    travellers_.ratios.first = k;
  }
  void store(std::size_t k) {
    columns(travellers_,
            [k](const auto& member, auto& column) { member.store(column.slot.data() + k); });
  }

  /// Keeps the copies of photons that were split, each with random numbers of its own.
  void keep_copies(std::size_t k, const Mask<T>& on) {
    const auto copies = each_lane(travellers_.copies);
    for_each_lane(on, [&](int lane) {
      const std::size_t slot = k + static_cast<std::size_t>(lane);
      for (std::int32_t i = 0; i < copies[slot - k]; ++i) {
        columns(travellers_,
                [slot](const auto&, auto& column) { column.waiting.push_back(column.slot[slot]); });
        if (world_.compares)
          ratios_.copy(world_.sea.environments, slot, slots + number_.waiting.size() - 1);
        number_.waiting.back() = copy_number(world_.key, number_.slot[slot], event_.slot[slot], i);
      }
    });
  }
  /// Gives a slot to a copy that waits, if one does.
  bool revive(std::size_t slot) {
    if (number_.waiting.empty()) [[likely]]
      return false;
    if (world_.compares)
      ratios_.copy(world_.sea.environments, slots + number_.waiting.size() - 1, slot);
    columns(travellers_, [slot](const auto&, auto& column) {
      column.slot[slot] = column.waiting.back();
      column.waiting.pop_back();
    });
    return true;
  }

  /// Whether there is another photon that has reached the water: lane `born_` of the newborn.
  bool emerge() {
    for (;;) {
      for (++born_; born_ < width; ++born_) {
        if ((entered_ >> born_ & 1U) != 0) return true;
      }
      if (next_ >= last_) return false;
      const Counter<T> number = Counter<T>(next_) + to_counter<T>(lane_numbers<T>());
      const Mask<T> exist = first_lanes<T>(last_ - next_);
      entered_ = lane_bits(set_out(world_, number, exist, newborn_, ledger_));
      next_ += width;
      born_ = static_cast<std::size_t>(-1);
    }
  }
  /// Gives a slot to the newborn photon.
  void settle(std::size_t slot) {
    columns(newborn_, [&](const auto& member, auto& column) { column.slot[slot] = member[born_]; });
    if (world_.compares) [[unlikely]]
      ratios_.of(slot).begin(world_.sea.environments);
  }
  /// Gives the slots of those who have ended to copies that wait, to new photons, or to the last
  /// ones.
  void replace() {
    const auto ended = [this](std::size_t slot) {
      return (on_[slot / width] >> slot % width & 1U) == 0;
    };
    for (std::size_t k = 0; k < used_; k += width) {
      auto gone = ~on_[k / width];
      if (width < 32) gone &= (1U << width) - 1U;
      for (; gone != 0; gone &= gone - 1) {
        const std::size_t slot = k + static_cast<std::size_t>(std::countr_zero(gone));
        if (slot >= used_) return;
        if (revive(slot)) continue;
        if (emerge()) {
          settle(slot);
          continue;
        }
        while (used_ > slot && ended(used_ - 1)) --used_;
        if (used_ <= slot) return;
        columns(travellers_,
                [&](const auto&, auto& column) { column.slot[slot] = column.slot[used_ - 1]; });
        if (world_.compares) [[unlikely]]
          ratios_.copy(world_.sea.environments, used_ - 1, slot);
        --used_;
      }
    }
  }

  template <class E>
  using ColumnOf = Column<E, slots>;
  using Real = ColumnOf<Element<T>>;
  using Integer = ColumnOf<std::int32_t>;

  const World<T>& world_;
  Real x_, y_, z_, u_, v_, w_, weight_, analog_weight_, path_;
  Integer line_, layer_, order_, event_, hue_;
  ColumnOf<std::uint64_t> number_;
  std::vector<std::array<Real, 2>> lens_;  ///< of each telescope
  transport::PathRatios<T> ratios_;  ///< of each slot and the copies that wait, in environments
  std::array<std::uint32_t, slots / width> on_{};  ///< who goes on, one bit for each lane
  std::size_t used_ = 0;

  Travellers<T> travellers_, newborn_;
  std::uint32_t entered_ = 0;
  std::size_t born_ = 0;
  std::uint64_t next_ = 0, last_ = 0;
  LaneLedger<T> ledger_;
  Estimates<T> estimates_;
};

}  // namespace photic::engine
