// Several photons at a time: N lanes of one number each, the lane type (core/lanes.hpp) over the
// vector extension of g++ and clang.
//
// Every operation gives a lane the bits that the scalar operation gives: a photon's history does
// not depend on its neighbours, nor on how many there are.
#pragma once

#include <array>
#include <cstring>
#include <type_traits>

#include "core/lanes.hpp"
#include "core/pack_native.hpp"
#include "core/random.hpp"

namespace photic {

/// Which of N lanes are meant.
template <int N>
struct PackMask {
  using Native = native::MaskBits<N>;
  Native value;

  PackMask() : PackMask(false) {}
  explicit PackMask(bool all) : value(native::same<N>(all)) {}
  static PackMask of(const Native& native) {
    PackMask out;
    out.value = native;
    return out;
  }
  /// Bit i of `bits` is lane i.
  static PackMask of_bits(std::uint32_t bits) { return of(native::mask_of_bits<N>(bits)); }
  [[nodiscard]] std::uint32_t bits() const { return native::bits<N>(value); }
  bool operator[](std::size_t i) const { return (bits() >> i & 1U) != 0; }
  void set(std::size_t i, bool one) {
    *this = of_bits(one ? bits() | 1U << i : bits() & ~(1U << i));
  }

  friend PackMask operator&(const PackMask& a, const PackMask& b) {
    return of(static_cast<Native>(a.value & b.value));
  }
  friend PackMask operator|(const PackMask& a, const PackMask& b) {
    return of(static_cast<Native>(a.value | b.value));
  }
  friend PackMask operator!(const PackMask& a) {
    return of(static_cast<Native>(a.value ^ native::same<N>(true)));
  }
  friend PackMask select(const PackMask& mask, const PackMask& yes, const PackMask& no) {
    return (mask & yes) | ((!mask) & no);
  }
  friend bool any(const PackMask& a) { return native::any<N>(a.value); }
  friend bool all(const PackMask& a) { return !any(!a); }
  friend std::uint32_t lane_bits(const PackMask& a) { return a.bits(); }
};

/// N lanes of E: float or double, or the integers that go with them.
template <class E, int N>
struct Pack {
  using Vector = native::Vector<E, N>;
  static constexpr int lanes = N;
  Vector v{};

  Pack() = default;
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit Pack(A all) : v(static_cast<E>(all) - Vector{}) {}
  static Pack of(const Vector& vector) {
    Pack out;
    out.v = vector;
    return out;
  }
  static Pack load(const E* from) {
    Pack out;
    std::memcpy(&out.v, from, sizeof out.v);
    return out;
  }
  void store(E* to) const { std::memcpy(to, &v, sizeof v); }

  /// The lanes of a mask one behind the other; up to N numbers are written.
  void store(const PackMask<N>& mask, E* to) const { native::compress<N, E>(mask.value, v, to); }

  /// The lanes of a mask from numbers one behind the other; up to N are read.
  void expand(const PackMask<N>& mask, const E* from) {
    v = native::expand<N, E>(mask.value, v, from);
  }

  E operator[](std::size_t i) const { return v[i]; }
  void set(std::size_t i, E value) { v[i] = value; }

  friend Pack operator+(const Pack& a, const Pack& b) { return of(a.v + b.v); }
  friend Pack operator-(const Pack& a, const Pack& b) { return of(a.v - b.v); }
  friend Pack operator*(const Pack& a, const Pack& b) { return of(a.v * b.v); }
  friend Pack operator/(const Pack& a, const Pack& b)
    requires std::is_floating_point_v<E>
  {
    return of(a.v / b.v);
  }
  friend Pack operator-(const Pack& a) { return of(-a.v); }

  friend PackMask<N> operator<(const Pack& a, const Pack& b) {
    return PackMask<N>::of(native::compare<native::less, N, E>(a.v, b.v));
  }
  friend PackMask<N> operator<=(const Pack& a, const Pack& b) {
    return PackMask<N>::of(native::compare<native::less_equal, N, E>(a.v, b.v));
  }
  friend PackMask<N> operator>(const Pack& a, const Pack& b) { return b < a; }
  friend PackMask<N> operator>=(const Pack& a, const Pack& b) { return b <= a; }
  friend PackMask<N> operator==(const Pack& a, const Pack& b) {
    return PackMask<N>::of(native::compare<native::equal, N, E>(a.v, b.v));
  }

  friend Pack operator>>(const Pack& a, int places)
    requires std::is_integral_v<E>
  {
    return of(a.v >> places);
  }
  friend Pack operator<<(const Pack& a, int places)
    requires std::is_integral_v<E>
  {
    return of(a.v << places);
  }
  friend Pack operator|(const Pack& a, const Pack& b)
    requires std::is_integral_v<E>
  {
    return of(a.v | b.v);
  }
  friend Pack operator&(const Pack& a, const Pack& b)
    requires std::is_integral_v<E>
  {
    return of(a.v & b.v);
  }
  friend Pack operator^(const Pack& a, const Pack& b)
    requires std::is_integral_v<E>
  {
    return of(a.v ^ b.v);
  }

  friend Pack select(const PackMask<N>& mask, const Pack& yes, const Pack& no) {
    return of(native::blend<N, E>(mask.value, yes.v, no.v));
  }
  friend std::array<E, N> each_lane(const Pack& a) {
    std::array<E, N> out;
    a.store(out.data());
    return out;
  }
};

template <class T>
inline constexpr bool is_pack = false;
template <class E, int N>
inline constexpr bool is_pack<Pack<E, N>> = true;

/// N lanes of 64 bits in two vectors: as many as fit into the registers that N floats fill.
template <class E, int N>
struct WidePack {
  using Half = Pack<E, N / 2>;
  Half first, second;

  WidePack() = default;
  WidePack(const Half& f, const Half& s) : first(f), second(s) {}
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit WidePack(A all) : first(all), second(all) {}
  static WidePack load(const E* from) { return {Half::load(from), Half::load(from + N / 2)}; }
  void store(E* to) const {
    first.store(to);
    second.store(to + N / 2);
  }
  E operator[](std::size_t i) const { return i < N / 2 ? first[i] : second[i - N / 2]; }
  void set(std::size_t i, E value) {
    i < N / 2 ? first.set(i, value) : second.set(i - N / 2, value);
  }

  friend WidePack operator+(const WidePack& a, const WidePack& b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend WidePack operator^(const WidePack& a, const WidePack& b) {
    return {a.first ^ b.first, a.second ^ b.second};
  }
  friend WidePack operator>>(const WidePack& a, int places) {
    return {a.first >> places, a.second >> places};
  }
  friend std::array<E, N> each_lane(const WidePack& a) {
    std::array<E, N> out;
    a.store(out.data());
    return out;
  }
};

template <std::floating_point E, int N>
struct LaneTraits<Pack<E, N>> {
  using Element = E;
  using Mask = PackMask<N>;
  using Index = Pack<std::int32_t, N>;
  using Word = Pack<std::uint32_t, N>;
  using Counter = WidePack<std::uint64_t, N>;
  static constexpr int lanes = N;
};

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
    return Pack<double, N / 2>::of(
        __builtin_convertvector(native::half<N, float>(x.v, upper), native::Vector<double, N / 2>));
  };
  return {part(false), part(true)};
}

template <class T, class Stored>
  requires is_pack<T>
T gather(const Stored* data, const Index<T>& i) {
  if constexpr (std::is_same_v<Stored, Element<T>> && sizeof(Stored) == 4) {
    return T::of(native::gather<T::lanes>(data, i.v));
  } else {
    T out;
    for (std::size_t k = 0; k < T::lanes; ++k) out.set(k, static_cast<Element<T>>(data[i[k]]));
    return out;
  }
}
template <class T>
  requires is_pack<T>
T gather(const Table& table, const Index<T>& i) {
  if constexpr (sizeof(Element<T>) == 4) {
    return gather<T>(table.rounded, i);
  } else {
    return gather<T>(table.exact, i);
  }
}
template <class T>
  requires is_pack<T>
T gather(const ShortTable& table, const Index<T>& i) {
  if constexpr (sizeof(Element<T>) == 4) {
    return T::of(native::gather_short<T::lanes>(table.rounded, table.size, i.v));
  } else {
    return gather<T>(table.exact, i);
  }
}
template <class T>
  requires is_pack<T>
T gather(const Table64& table, const Index<T>& i) {
  if constexpr (sizeof(Element<T>) == 4) {
    return T::of(native::gather_64<T::lanes>(table.view().rounded, i.v));
  } else {
    return gather<T>(table.view().exact, i);
  }
}
template <class T>
  requires is_pack<T>
Index<T> gather_index(const std::int32_t* data, const Index<T>& i) {
  return Index<T>::of(native::gather<T::lanes>(data, i.v));
}
template <class T>
  requires is_pack<T>
Index<T> gather_index(const IndexTable& table, const Index<T>& i) {
  return Index<T>::of(native::gather_short<T::lanes>(table.data, table.size, i.v));
}

template <class T>
  requires is_pack<T>
Mask<T> mask_of_bits(std::uint32_t bits) {
  return Mask<T>::of_bits(bits);
}
template <class T>
  requires is_pack<T>
Index<T> lane_numbers() {
  Index<T> out;
  for (std::size_t i = 0; i < T::lanes; ++i) out.set(i, static_cast<std::int32_t>(i));
  return out;
}

/// Lane j of row i becomes lane i of row j.
template <class E, int N, std::size_t rows>
void transpose(std::array<Pack<E, N>, rows>& row) {
  static_assert(rows == N);
  native::transpose<N>(row);
}
template <class E, int N>
Pack<E, N> permute(const Pack<E, N>& from, const Pack<std::int32_t, N>& lane) {
  return Pack<E, N>::of(native::permute<N, E>(from.v, lane.v));
}

/// Up to N numbers are written.
template <class E, int N>
void compress(const PackMask<N>& mask, const Pack<E, N>& lanes, E* to) {
  native::compress<N, E>(mask.value, lanes.v, to);
}
/// Up to N are read.
template <class E, int N>
void expand(const PackMask<N>& mask, const E* from, Pack<E, N>& lanes) {
  lanes.v = native::expand<N, E>(mask.value, lanes.v, from);
}

template <class T>
  requires is_pack<T>
Word<T> gather_word(const std::uint32_t* data, const Index<T>& i) {
  return Word<T>::of(native::gather<T::lanes>(data, i.v));
}
template <class E, int N>
void scatter(const PackMask<N>& mask, const Pack<std::int32_t, N>& i, const Pack<E, N>& value,
             E* to) {
  native::scatter<N, E>(mask.value, i.v, value.v, to);
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
