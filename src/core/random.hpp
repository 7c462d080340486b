// Random numbers by counter: a photon's draws depend on its number alone, neither on the thread
// that walks it nor on the photons beside it.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>

#include "core/lanes.hpp"
#include "core/philox.hpp"

namespace photic {

/// The place of a photon in the stream.
template <class T>
struct RandomPlace {
  RandomKey key;
  Counter<T> photon{};
  Index<T> event{};  ///< counts the photon's events: emission is 0
};

template <std::floating_point T>
constexpr std::uint64_t to_counter(std::int32_t i) {
  return static_cast<std::uint32_t>(i);
}

/// The upper 23 or all 32 bits of a word as a number in (0, 1), never 0 nor 1: the middle of its
/// cell. V may be several numbers like T.
template <class T, class V>
constexpr V uniform_from_part(const V& part) {
  constexpr bool is_float = sizeof(Element<T>) == sizeof(float);
  return (part + T(0.5)) * T(is_float ? 0x1p-23 : 0x1p-32);
}
template <std::floating_point T>
constexpr T uniform_from_word(std::uint32_t word) {
  return uniform_from_part<T>(static_cast<T>(sizeof(T) == sizeof(float) ? word >> 9 : word));
}
template <std::floating_point T>
constexpr T uniform_from(std::uint64_t word) {
  return uniform_from_word<T>(static_cast<std::uint32_t>(word));
}

/// The rest of an even u after the choice u < share: even again, whatever was chosen.
template <class T>
T left_of_choice(const T& u, const T& share) {
  const Mask<T> chosen = u < share;
  return select(chosen, u, u - share) / select(chosen, share, T(1) - share);
}

/// The numbers of two words.
template <class T>
std::array<T, 2> uniforms_from(const WordPair<Counter<T>>& words) {
  if constexpr (lanes_of<T> > 1) {
    return {uniform_from<T>(words.first), uniform_from<T>(words.second)};
  } else if constexpr (std::same_as<T, float>) {
    return {uniform_from<T>(words.v[0]), uniform_from<T>(words.v[1])};
  } else {
    // NOLINTNEXTLINE(modernize-use-using): an alias takes no such attribute
    typedef double Vector __attribute__((vector_size(16)));
    const auto offset = std::bit_cast<std::uint64_t>(0x1p52);  // its lowest bit counts as one
    const auto parts = (Vector)((words.v & 0xffffffff) | offset) - 0x1p52;
    const Vector u = uniform_from_part<double>(parts);
    return {u[0], u[1]};
  }
}

/// Four uniforms of one event of one photon; an event that needs more asks for another block.
template <class T>
std::array<T, 4> uniforms(const RandomKey& key, const Counter<T>& photon, const Index<T>& event,
                          std::uint32_t block) {
  const auto words = philox<Counter<T>>(key, photon, to_counter<T>(event), block);
  const auto [u0, u2] = uniforms_from<T>(words.even);
  const auto [u1, u3] = uniforms_from<T>(words.odd);
  return {u0, u1, u2, u3};
}
template <class T>
std::array<T, 4> uniforms(const RandomPlace<T>& place, std::uint32_t block) {
  return uniforms<T>(place.key, place.photon, place.event, block);
}

/// Words of two places, whose rounds of Philox take turns: each has to wait for the one before.
template <class W>
struct Twins {
  W a, b;
  Twins(const W& one, const W& other) : a(one), b(other) {}
  explicit Twins(std::uint64_t both) : a(both), b(both) {}

  friend Twins operator^(const Twins& x, const Twins& y) { return {x.a ^ y.a, x.b ^ y.b}; }
  friend Twins operator>>(const Twins& x, int places) { return {x.a >> places, x.b >> places}; }
  friend Twins multiply_low(const Twins& x, std::uint32_t by) {
    return {multiply_low(x.a, by), multiply_low(x.b, by)};
  }
};
/// The same of two places, with the key of the first, at once.
template <class T>
std::array<std::array<T, 4>, 2> uniforms(const RandomPlace<T>& a, const RandomPlace<T>& b,
                                         std::uint32_t block) {
  const auto [even, odd] = philox<Twins<Counter<T>>>(
      a.key, {a.photon, b.photon}, {to_counter<T>(a.event), to_counter<T>(b.event)}, block);
  return {{{uniform_from<T>(even.first.a), uniform_from<T>(odd.first.a),
            uniform_from<T>(even.second.a), uniform_from<T>(odd.second.a)},
           {uniform_from<T>(even.first.b), uniform_from<T>(odd.first.b),
            uniform_from<T>(even.second.b), uniform_from<T>(odd.second.b)}}};
}

}  // namespace photic
