// The random numbers of a walk of the bidirectional estimator: Philox, or for a walk's first events
// points that a whole batch spreads evenly.
#pragma once

#include <array>
#include <cstdint>

#include "core/random.hpp"
#include "core/sobol.hpp"
#include "engine/world.hpp"

namespace photic::engine {

/// Blocks from here on hold the keys that scramble the points of a batch; walks draw below.
inline constexpr std::uint32_t key_blocks = std::uint32_t{1} << 31;

/// The uniforms of one walk.
template <class T>
struct Draws {
  const World<T>& world;
  std::uint64_t photon;
  std::uint32_t first_block;  ///< of Philox, for this walk
  std::uint32_t first_slot;   ///< 0: the laser's, 1: a telescope's

  [[nodiscard]] std::array<T, 4> operator()(std::int32_t event, std::uint32_t block) const {
    if (world.points.dimensions() == 0 || static_cast<std::uint32_t>(event) >= quasi_random_events)
      return uniforms(RandomPlace<T>{world.seed, photon, event}, first_block + block);
    const auto keys = philox_words<std::uint64_t>(
        world.seed, photon / batch_photons, to_counter<T>(event), key_blocks + first_block + block);
    const std::size_t first =
        4 * (static_cast<std::size_t>(event) * quasi_random_blocks + first_slot + block);
    std::array<T, 4> u;
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] = uniform_from<T>(scrambled(world.points.word(photon % batch_photons, first + i),
                                       static_cast<std::uint32_t>(keys[i])));
    return u;
  }
};

}  // namespace photic::engine
