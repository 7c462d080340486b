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

namespace photic {

/// The selection of some of N lanes.
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
  friend WidePack operator-(const WidePack& a, const WidePack& b) {
    return {a.first - b.first, a.second - b.second};
  }
  friend WidePack operator*(const WidePack& a, const WidePack& b) {
    return {a.first * b.first, a.second * b.second};
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

}  // namespace photic
