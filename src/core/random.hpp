// Random numbers by counter: what a photon draws depends on its number alone, never on who walks
// it.
//
// Philox4x32-10 (Salmon et al., SC'11, 2011) from Random123. Counter: photon low, photon high,
// event, block; key: the seed.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <concepts>
#include <cstdint>

#include "core/lanes.hpp"

namespace photic {

/// Where in the stream a photon stands.
template <class T>
struct RandomPlace {
  std::uint64_t seed = 0;
  Counter<T> photon{};
  Index<T> event{};  ///< counts the photon's events: emission is 0
};

/// The four words of one block.
inline std::array<std::uint32_t, 4> philox_words(std::uint64_t seed, std::uint64_t photon,
                                                 std::uint32_t event, std::uint32_t block) {
  const auto low = [](std::uint64_t u) { return static_cast<std::uint32_t>(u); };
  const auto high = [](std::uint64_t u) { return static_cast<std::uint32_t>(u >> 32); };
  const r123::Philox4x32::ctr_type counter = {{low(photon), high(photon), event, block}};
  const r123::Philox4x32::key_type key = {{low(seed), high(seed)}};
  const auto words = r123::Philox4x32{}(counter, key);
  return {words[0], words[1], words[2], words[3]};
}

/// A word as a number in (0, 1), never 0 nor 1: the middle of its cell.
template <std::floating_point T>
constexpr T uniform_from(std::uint32_t word) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return (static_cast<T>(word >> 9) + T(0.5)) * T(1.0 / (1 << 23));
  } else {
    return (static_cast<T>(word) + T(0.5)) * T(1.0 / 4294967296.0);
  }
}

/// Four uniforms of one event of one photon; an event that needs more asks for another block.
template <std::floating_point T>
std::array<T, 4> uniforms(const RandomPlace<T>& place, std::uint32_t block) {
  const auto w =
      philox_words(place.seed, place.photon, static_cast<std::uint32_t>(place.event), block);
  return {uniform_from<T>(w[0]), uniform_from<T>(w[1]), uniform_from<T>(w[2]),
          uniform_from<T>(w[3])};
}

}  // namespace photic
