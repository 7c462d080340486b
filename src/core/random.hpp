// Random numbers by counter: what a photon draws depends on its number alone, never on who walks
// it, nor on who walks beside it.
//
// Philox4x32-10 (Salmon et al., SC'11, 2011). Counter: photon low, photon high, event, block; key:
// the seed.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>

#include "core/lanes.hpp"

namespace photic {

/// A seed as the rounds of Philox want it.
class RandomKey {
 public:
  static constexpr int rounds = 10;

  constexpr RandomKey(std::uint64_t seed) {  // NOLINT(*-explicit-*): the seed is the key
    // Constants of the authors' Philox4x32: steps of the key between rounds.
    constexpr std::uint32_t step0 = 0x9e3779b9, step1 = 0xbb67ae85;
    auto low = static_cast<std::uint32_t>(seed), high = static_cast<std::uint32_t>(seed >> 32);
    for (auto& round : round_) {
      round = {low, high};
      low += step0;
      high += step1;
    }
  }
  /// The two words of a round, each in the lower half of a lane.
  [[nodiscard]] constexpr const std::array<std::uint64_t, 2>& round(int i) const {
    return round_[static_cast<std::size_t>(i)];
  }

 private:
  std::array<std::array<std::uint64_t, 2>, rounds> round_{};
};

/// Where in the stream a photon stands.
template <class T>
struct RandomPlace {
  RandomKey key;
  Counter<T> photon{};
  Index<T> event{};  ///< counts the photon's events: emission is 0
};

/// The lower half of a word times a number of 32 bits.
constexpr std::uint64_t multiply_low(std::uint64_t word, std::uint32_t by) {
  return (word & 0xffffffff) * by;
}
template <std::floating_point T>
constexpr std::uint64_t to_counter(std::int32_t i) {
  return static_cast<std::uint32_t>(i);
}

/// The four words of one block, each in the lower half of a W; the upper halves are scratch.
template <class W>
std::array<W, 4> philox_words(const RandomKey& key, const W& photon, const W& event,
                              std::uint32_t block) {
  // Constants of the authors' Philox4x32: multipliers.
  constexpr std::uint32_t multiplier0 = 0xd2511f53, multiplier1 = 0xcd9e8d57;
  std::array<W, 4> word{photon, photon >> 32, event, W(block)};
  for (int i = 0; i < RandomKey::rounds; ++i) {
    const auto& [key0, key1] = key.round(i);
    const W product0 = multiply_low(word[0], multiplier0);
    const W product1 = multiply_low(word[2], multiplier1);
    word = {(product1 >> 32) ^ word[1] ^ W(key0), product1, (product0 >> 32) ^ word[3] ^ W(key1),
            product0};
  }
  return word;
}

/// The upper 23 or all 32 bits of a word as a number in (0, 1), never 0 nor 1: the middle of its
/// cell.
template <class T>
constexpr T uniform_from_part(const T& part) {
  constexpr bool is_float = sizeof(Element<T>) == sizeof(float);
  return (part + T(0.5)) * T(is_float ? 0x1p-23 : 0x1p-32);
}
template <std::floating_point T>
constexpr T uniform_from_word(std::uint32_t word) {
  return uniform_from_part(static_cast<T>(sizeof(T) == sizeof(float) ? word >> 9 : word));
}
template <std::floating_point T>
constexpr T uniform_from(std::uint64_t word) {
  return uniform_from_word<T>(static_cast<std::uint32_t>(word));
}

/// Four uniforms of one event of one photon; an event that needs more asks for another block.
template <class T>
std::array<T, 4> uniforms(const RandomKey& key, const Counter<T>& photon, const Index<T>& event,
                          std::uint32_t block) {
  const auto w = philox_words<Counter<T>>(key, photon, to_counter<T>(event), block);
  return {uniform_from<T>(w[0]), uniform_from<T>(w[1]), uniform_from<T>(w[2]),
          uniform_from<T>(w[3])};
}
template <class T>
std::array<T, 4> uniforms(const RandomPlace<T>& place, std::uint32_t block) {
  return uniforms<T>(place.key, place.photon, place.event, block);
}

}  // namespace photic
