// Packs of lanes, whole: their type, their way to memory and back, functions and random numbers.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "core/pack_memory.hpp"
#include "core/pack_type.hpp"
#include "core/random.hpp"

namespace photic {

namespace native {
/// The bits of a pack's lanes, as integers as wide as they are.
template <class E, int N>
Vector<Bits<E>, N> bits_of(const Pack<E, N>& x) {
  return (Vector<Bits<E>, N>)x.v;
}
template <class E, int N>
Pack<E, N> of_bits(const Vector<Bits<E>, N>& bits) {
  return Pack<E, N>::of((Vector<E, N>)bits);
}
template <class E>
inline constexpr Bits<E> sign_bit = std::numeric_limits<Bits<E>>::min();
template <class E>
inline constexpr int mantissa_bits = std::numeric_limits<E>::digits - 1;
template <class E>
inline constexpr int exponent_bias = std::numeric_limits<E>::max_exponent - 1;
}  // namespace native

template <std::floating_point E, int N>
Pack<E, N> sqrt(const Pack<E, N>& x) {
  return Pack<E, N>::of(native::square_root<N, E>(x.v));
}
template <std::floating_point E, int N>
Pack<E, N> abs(const Pack<E, N>& x) {
  return native::of_bits<E, N>(native::bits_of(x) & ~native::sign_bit<E>);
}
template <std::floating_point E, int N>
Pack<E, N> copysign(const Pack<E, N>& x, const Pack<E, N>& sign) {
  return native::of_bits<E, N>((native::bits_of(x) & ~native::sign_bit<E>) |
                               (native::bits_of(sign) & native::sign_bit<E>));
}

template <class T>
  requires is_pack<T>
T to_real(const Index<T>& i) {
  return T::of(__builtin_convertvector(i.v, typename T::Vector));
}
template <std::floating_point E, int N>
Pack<std::int32_t, N> floor_index(const Pack<E, N>& x) {
  return Pack<std::int32_t, N>::of(__builtin_convertvector(x.v, native::Vector<std::int32_t, N>));
}

template <int N>
WidePack<double, N> to_double(const Pack<float, N>& x) {
  const auto part = [&x](bool upper) {
    return Pack<double, N / 2>::of(native::wide_half<N>(x.v, upper));
  };
  return {part(false), part(true)};
}

template <int N>
WidePack<double, N> smaller(const WidePack<double, N>& a, const WidePack<double, N>& b) {
  using Half = typename WidePack<double, N>::Half;
  return {Half::of(a.first.v < b.first.v ? a.first.v : b.first.v),
          Half::of(a.second.v < b.second.v ? a.second.v : b.second.v)};
}
template <int N>
WidePack<double, N> larger(const WidePack<double, N>& a, const WidePack<double, N>& b) {
  using Half = typename WidePack<double, N>::Half;
  return {Half::of(a.first.v > b.first.v ? a.first.v : b.first.v),
          Half::of(a.second.v > b.second.v ? a.second.v : b.second.v)};
}
template <int N>
Pack<std::int32_t, N> floor_index(const WidePack<double, N>& x) {
  using Ints = native::Vector<std::int32_t, N / 2>;
  return Pack<std::int32_t, N>::of(native::joined<N>(__builtin_convertvector(x.first.v, Ints),
                                                     __builtin_convertvector(x.second.v, Ints)));
}

template <std::floating_point E, int N>
OctaveCell<Pack<E, N>> octave_cell(const Pack<E, N>& x, int bits) {
  using native::exponent_bias;
  using native::mantissa_bits;
  using Wide = native::Vector<native::Bits<E>, N>;
  const Wide u = native::bits_of(x);
  const int drop = mantissa_bits<E> - bits;
  const Wide cell = (u >> drop) - (native::Bits<E>{exponent_bias<E>} << bits);
  const Wide rest = u & ((native::Bits<E>{1} << drop) - 1);
  const auto unit = std::bit_cast<E>(native::Bits<E>{exponent_bias<E> - drop} << mantissa_bits<E>);
  return {Pack<std::int32_t, N>::of(__builtin_convertvector(cell, native::Vector<std::int32_t, N>)),
          Pack<E, N>::of(__builtin_convertvector(rest, native::Vector<E, N>) * unit)};
}
template <class T>
  requires is_pack<T>
T octave_edge(const Index<T>& cell, int bits) {
  using E = Element<T>;
  constexpr int bias = native::exponent_bias<E>;
  const auto wide = __builtin_convertvector(cell.v + (std::int32_t{bias} << bits),
                                            native::Vector<native::Bits<E>, T::lanes>);
  return native::of_bits<E, T::lanes>(wide << (native::mantissa_bits<E> - bits));
}

// Random numbers in lanes (core/random.hpp).

template <int N>
WidePack<std::uint64_t, N> multiply_low(const WidePack<std::uint64_t, N>& a, std::uint32_t b) {
  using Half = Pack<std::uint64_t, N / 2>;
  return {Half::of(native::multiply_low<N / 2>(a.first.v, b)),
          Half::of(native::multiply_low<N / 2>(a.second.v, b))};
}
template <class T>
  requires is_pack<T>
Counter<T> to_counter(const Index<T>& i) {
  constexpr int lanes = T::lanes / 2;
  using Half = Pack<std::uint64_t, lanes>;
  const auto part = [&i](bool upper) {
    return Half::of(__builtin_convertvector(native::half<T::lanes, std::int32_t>(i.v, upper),
                                            typename Half::Vector));
  };
  return {part(false), part(true)};
}
/// The lower and the upper words of counters, and back.
template <class T>
  requires is_pack<T>
std::array<Index<T>, 2> words_of(const Counter<T>& counter) {
  const auto lower = [](const Counter<T>& c) {
    return Index<T>::of(native::low_words<T::lanes>(c.first.v, c.second.v));
  };
  return {lower(counter), lower(counter >> 32)};
}
template <class T>
  requires is_pack<T>
Counter<T> counter_of(const Index<T>& lower, const Index<T>& upper) {
  using Half = typename Counter<T>::Half;
  const auto words = native::in_turn<T::lanes>(lower.v, upper.v);
  return {Half::of(words[0]), Half::of(words[1])};
}
template <class T>
  requires is_pack<T>
T uniform_from_word(const Word<T>& word) {
  if constexpr (sizeof(Element<T>) == 4) {
    const auto part = word >> 9;
    return uniform_from_part<T>(to_real<T>(Index<T>::of((typename Index<T>::Vector)part.v)));
  } else {
    return uniform_from_part<T>(T::of(__builtin_convertvector(word.v, typename T::Vector)));
  }
}
template <class T>
  requires is_pack<T>
T uniform_from(const Counter<T>& word) {
  const auto low = native::low_words<T::lanes>(word.first.v, word.second.v);
  return uniform_from_word<T>(Word<T>::of((typename Word<T>::Vector)low));
}

}  // namespace photic
