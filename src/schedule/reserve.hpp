// Photons that wait for a lane: new ones, copies, and those that make room.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/pack.hpp"
#include "estimator/forward/estimate.hpp"

namespace photic::schedule {

/// The values that photons take along; the others are the same for all of them.
struct Carried {
  bool spectral_bin = true, touched = true, surface = true, choices = true, tools = true;
};
template <class T>
Carried carried_in(const estimator::World<T>& world) {
  return {world.slabs.bands > 0,
          world.slabs.bed_angles > 0 || world.slabs.kind == medium::MediumKind::air,
          !world.slabs.surface.one_direction_each, world.forward.makes_choices, world.all_events};
}

/// A stack of photons at the end of a flight, word by word in columns: the last to come goes first.
template <class T>
class Reserve {
 public:
  explicit Reserve(const Carried& carried) : carried_(carried) {}

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Adds the lanes of a mask, in their order.
  void push(const Mask<T>& mask, estimator::ForwardTracks<T>& from) {
    make_room(from);
    std::int32_t* end = word_.data() + size_;
    each_word(from, [&, column = column_](const Index<T>& word) {
      compress(mask, word, end);
      end += column;
      return word;
    });
    size_ += count(mask);
  }

  /// Gives the lanes of a mask to the photons that wait, as far as they go. Returns the lanes
  /// given.
  Mask<T> pop(const Mask<T>& free, estimator::ForwardTracks<T>& to) {
    const Mask<T> given = size_ >= count(free) ? free : first_of(free, size_);
    size_ -= count(given);
    const std::int32_t* first = word_.data() + size_;
    each_word(to, [&, column = column_](Index<T> word) {
      expand(given, first, word);
      first += column;
      return word;
    });
    return given;
  }

 private:
  /// word = f(word) for all that photons take along.
  template <class F>
  void each_word(estimator::ForwardTracks<T>& t, F f) {
    const auto member = [&]<class M>(M& m) { m = std::bit_cast<M>(f(std::bit_cast<Index<T>>(m))); };
    t.photon.each_member(member);
    member(t.place.event);
    if (carried_.spectral_bin) member(t.spectral_bin);
    if (carried_.touched) member(t.touched);
    for (auto& point : t.lens) member(point.x), member(point.y);
    for (std::size_t i = 1; i < t.u.size(); ++i) member(t.u[i]);
    if (carried_.surface)
      for (auto& number : t.surface) member(number);
    if (carried_.choices)
      for (auto& number : t.choices) member(number);
    if (carried_.tools) member(t.analog_before), member(t.importance_before);
    const Index<T> colliding = f(select(t.colliding, Index<T>(1), Index<T>(0)));
    t.colliding = colliding == Index<T>(1);
    const auto [lower, upper] = words_of<T>(t.place.photon);
    const Index<T> word = f(lower);
    t.place.photon = counter_of<T>(word, f(upper));
  }
  static Mask<T> first_of(const Mask<T>& mask, std::size_t n) {
    std::uint32_t first = 0, left = lane_bits(mask);
    for (; n > 0; --n, left &= left - 1) first |= left & -left;
    return mask_of_bits<T>(first);
  }
  /// For as many more as there are lanes; whole packs are read and written.
  void make_room(estimator::ForwardTracks<T>& like) {
    if (size_ + 2 * lanes_of<T> <= column_) return;
    const std::size_t longer = 2 * size_ + 8 * lanes_of<T>;
    std::size_t columns = 0;
    each_word(like, [&](const Index<T>& word) {
      ++columns;
      return word;
    });
    std::vector<std::int32_t> word(columns * longer);
    for (std::size_t k = 0; k * column_ < word_.size(); ++k)
      std::copy_n(word_.data() + k * column_, size_, word.data() + k * longer);
    column_ = longer;
    word_ = std::move(word);
  }

  Carried carried_;
  std::vector<std::int32_t> word_;  ///< [word][photon]
  std::size_t column_ = 0, size_ = 0;
};

}  // namespace photic::schedule
