// The random numbers of photons and of the bidirectional estimator's walks: Philox, or for the
// first events points that a whole batch spreads evenly.
#pragma once

#include <array>
#include <cstdint>

#include "core/random.hpp"
#include "core/sobol.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/world.hpp"

namespace photic::estimator {

/// The uniforms of a batch's photons, or walks from the laser or from one of the telescopes.
template <class T>
class Draws {
 public:
  /// `batch`: number of its first photon. `first_block`: of Philox, for these walks; `first_slot`:
  /// 0 for the laser's, 1 for a telescope's.
  Draws(const RandomNumbers& random, std::uint64_t batch, std::uint32_t first_block,
        std::uint32_t first_slot)
      : random_(random), batch_(batch), first_block_(first_block), first_slot_(first_slot) {
    for (std::uint32_t i = 0; spread() && i < quasi_random_dimensions; i += 4) {
      const std::uint32_t event = i / 4 / quasi_random_blocks, slot = i / 4 % quasi_random_blocks;
      if (slot < first_slot) continue;
      const auto words = philox_words(random.key, batch / random.batch_photons, event,
                                      key_blocks[first_block + (slot - first_slot)]);
      std::ranges::copy(words, &keys_[i]);
    }
  }

  /// The number of the batch's photon n.
  [[nodiscard]] Counter<T> photon(const Index<T>& n) const {
    return Counter<T>(batch_) + to_counter<T>(n);
  }

  /// The numbers of an event of the batch's photon n, or of the walk that goes with it.
  [[nodiscard]] std::array<T, 4> operator()(const Index<T>& n, const Index<T>& event,
                                            std::uint32_t block) const {
    const Mask<T> early = event < Index<T>(spread_events(block));
    if (all(early)) return from_points(n, event, block);
    auto u = independent(n, event, block);
    if (!any(early)) return u;
    const auto v = from_points(n, select(early, event, Index<T>(0)), block);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = select(early, v[i], u[i]);
    return u;
  }
  /// The numbers of the same event of the batch's photons n, n + 1, … in the lanes.
  [[nodiscard]] std::array<T, 4> together(std::int32_t n, std::int32_t event,
                                          std::uint32_t block) const {
    if (event >= spread_events(block))
      return independent(Index<T>(n) + lane_numbers<T>(), Index<T>(event), block);
    const auto first = static_cast<std::size_t>(first_coordinate(event, block));
    std::array<T, 4> u;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const auto word = load_words<T>(random_.points.coordinate(first + i) + n);
      u[i] = uniform_from_word<T>(scrambled(word, Word<T>(keys_[first + i])));
    }
    return u;
  }

 private:
  [[nodiscard]] bool spread() const { return random_.points.dimensions() > 0; }
  /// So many events have their numbers of a block from points.
  [[nodiscard]] std::int32_t spread_events(std::uint32_t block) const {
    return spread() && first_slot_ + block < quasi_random_blocks ? quasi_random_events : 0;
  }
  [[nodiscard]] std::array<T, 4> independent(const Index<T>& n, const Index<T>& event,
                                             std::uint32_t block) const {
    return uniforms<T>(random_.key, photon(n), event, first_block_ + block);
  }
  [[nodiscard]] std::array<T, 4> from_points(const Index<T>& n, const Index<T>& event,
                                             std::uint32_t block) const {
    const Index<T> first = first_coordinate(event, block);
    std::array<T, 4> u;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const Index<T> d = first + Index<T>(i);
      const Index<T> place = d * Index<T>(random_.points.points()) + n;
      u[i] = uniform_from_word<T>(scrambled(gather_word<T>(random_.points.coordinate(0), place),
                                            gather_word<T>(keys_.data(), d)));
    }
    return u;
  }
  /// The first coordinate of an event's block.
  template <class I>
  [[nodiscard]] I first_coordinate(const I& event, std::uint32_t block) const {
    return I(4) * (event * I(quasi_random_blocks) + I(first_slot_ + block));
  }

  const RandomNumbers& random_;
  std::uint64_t batch_;
  std::uint32_t first_block_, first_slot_;
  std::array<std::uint32_t, quasi_random_dimensions> keys_{};  ///< of each coordinate
};

/// The draws of photons and the laser's walks; a telescope's have the blocks above.
template <class T>
Draws<T> draws_of_laser(const RandomNumbers& random, std::uint64_t batch) {
  return {random, batch, 0, 0};
}
template <class T>
Draws<T> draws_of(const RandomNumbers& random, const Receiver<T>& receiver, std::uint64_t batch) {
  return {random, batch, walk_blocks[4 + 4 * static_cast<std::uint32_t>(receiver.number)], 1};
}

}  // namespace photic::estimator
