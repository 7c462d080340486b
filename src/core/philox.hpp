// Philox4x32-10, a generator of random words by counter (Salmon et al., SC'11, 2011). Counter:
// photon low, photon high, event, block; key: the seed.
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <array>
#include <cstdint>

#include "core/lanes.hpp"

namespace photic {

/// Two words side by side in a register, each in the lower half of 64 bits.
// NOLINTNEXTLINE(modernize-use-using): an alias takes no such attribute
typedef std::uint64_t TwoWords __attribute__((vector_size(16)));

/// A seed as the rounds of Philox want it.
class RandomKey {
 public:
  static constexpr int rounds = 10;

  constexpr RandomKey(std::uint64_t seed) {  // NOLINT(*-explicit-*): the seed is the key
    // Constants of the authors' Philox4x32: steps of the key between rounds.
    constexpr std::uint32_t step0 = 0x9e3779b9, step1 = 0xbb67ae85;
    auto low = static_cast<std::uint32_t>(seed), high = static_cast<std::uint32_t>(seed >> 32);
    for (auto& round : round_) {
      round = TwoWords{low, high};
      low += step0;
      high += step1;
    }
  }
  /// The words of a round.
  [[nodiscard]] const TwoWords& round(int i) const { return round_[static_cast<std::size_t>(i)]; }

 private:
  std::array<TwoWords, rounds> round_{};
};

/// Two words of a block, each in the lower half of a W; the upper halves are scratch.
template <class W>
struct WordPair {
  W first, second;

  [[nodiscard]] WordPair times(std::uint32_t a, std::uint32_t b) const {
    return {multiply_low(first, a), multiply_low(second, b)};
  }
  [[nodiscard]] WordPair swapped() const { return {second, first}; }
  [[nodiscard]] WordPair upper_halves() const { return {first >> 32, second >> 32}; }
  WordPair operator^(const WordPair& b) const { return {first ^ b.first, second ^ b.second}; }
  WordPair operator^(const TwoWords& b) const { return {first ^ W(b[0]), second ^ W(b[1])}; }
};

/// The words of one photon, side by side in a register: a round is five instructions.
template <>
struct WordPair<std::uint64_t> {
  TwoWords v;

  WordPair(const TwoWords& words) : v(words) {}  // NOLINT(*-explicit-*): one is the other
  WordPair(std::uint64_t a, std::uint64_t b) : v{a, b} {}

  [[nodiscard]] WordPair times(std::uint32_t a, std::uint32_t b) const {
    const TwoWords factors{a, b};
#if defined(__SSE2__)
    return (TwoWords)_mm_mul_epu32((__m128i)v, (__m128i)factors);
#else
    return (v & 0xffffffff) * factors;
#endif
  }
  [[nodiscard]] WordPair swapped() const { return __builtin_shufflevector(v, v, 1, 0); }
  [[nodiscard]] WordPair upper_halves() const { return v >> 32; }
  WordPair operator^(const WordPair& b) const { return v ^ b.v; }
};

/// The words 0 and 2, and 1 and 3, of a block.
template <class W>
struct PhiloxBlock {
  WordPair<W> even, odd;
};

template <class W>
PhiloxBlock<W> philox(const RandomKey& key, const W& photon, const W& event, std::uint32_t block) {
  // Constants of the authors' Philox4x32: multipliers.
  constexpr std::uint32_t multiplier0 = 0xd2511f53, multiplier1 = 0xcd9e8d57;
  WordPair<W> even{photon, event}, odd{photon >> 32, W(block)};
  unrolled<RandomKey::rounds>([&](auto i) {
    const WordPair<W> products = even.times(multiplier0, multiplier1).swapped();
    even = products.upper_halves() ^ odd ^ key.round(i);
    odd = products;
  });
  return {even, odd};
}

/// The four words of one photon.
inline std::array<std::uint32_t, 4> philox_words(const RandomKey& key, std::uint64_t photon,
                                                 std::uint32_t event, std::uint32_t block) {
  const auto words = philox<std::uint64_t>(key, photon, event, block);
  const auto word = [](std::uint64_t lane) { return static_cast<std::uint32_t>(lane); };
  return {word(words.even.v[0]), word(words.odd.v[0]), word(words.even.v[1]), word(words.odd.v[1])};
}

}  // namespace photic
