// Four doubles that walk together: the lane type of the tests, written to be obvious rather than
// fast.
//
// It has what core/lanes.hpp asks of a lane type and nothing more (no branch on a value, no
// implicit conversion), so that code which compiles with it is ready for any pack of photons.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/lanes.hpp"
#include "core/random.hpp"

namespace photic::test {

inline constexpr std::size_t lanes = 4;

template <class E>
struct Pack4 {
  std::array<E, lanes> lane{};

  Pack4() = default;
  explicit Pack4(E all) { lane.fill(all); }

  E& operator[](std::size_t i) { return lane[i]; }
  const E& operator[](std::size_t i) const { return lane[i]; }
};

using Lanes4 = Pack4<double>;
using Index4 = Pack4<std::int32_t>;
using Counter4 = Pack4<std::uint64_t>;
using Mask4 = Pack4<bool>;

/// f of each lane of one, two or three packs.
template <class F, class E, class... More>
auto lane_by_lane(F f, const Pack4<E>& first, const Pack4<More>&... more) {
  Pack4<std::decay_t<decltype(f(first[0], more[0]...))>> out;
  for (std::size_t i = 0; i < lanes; ++i) out[i] = f(first[i], more[i]...);
  return out;
}

template <class E>
concept Number = std::is_same_v<E, double> || std::is_same_v<E, std::int32_t>;

template <Number E>
Pack4<E> operator+(const Pack4<E>& a, const Pack4<E>& b) {
  return lane_by_lane([](E x, E y) { return x + y; }, a, b);
}
template <Number E>
Pack4<E> operator-(const Pack4<E>& a, const Pack4<E>& b) {
  return lane_by_lane([](E x, E y) { return x - y; }, a, b);
}
template <Number E>
Pack4<E> operator*(const Pack4<E>& a, const Pack4<E>& b) {
  return lane_by_lane([](E x, E y) { return x * y; }, a, b);
}
template <Number E>
Pack4<E> operator-(const Pack4<E>& a) {
  return lane_by_lane([](E x) { return -x; }, a);
}
inline Lanes4 operator/(const Lanes4& a, const Lanes4& b) {
  return lane_by_lane([](double x, double y) { return x / y; }, a, b);
}

template <Number E>
Mask4 operator<(const Pack4<E>& a, const Pack4<E>& b) {
  return lane_by_lane([](E x, E y) { return x < y; }, a, b);
}
template <Number E>
Mask4 operator<=(const Pack4<E>& a, const Pack4<E>& b) {
  return lane_by_lane([](E x, E y) { return x <= y; }, a, b);
}
template <Number E>
Mask4 operator>(const Pack4<E>& a, const Pack4<E>& b) {
  return b < a;
}
template <Number E>
Mask4 operator>=(const Pack4<E>& a, const Pack4<E>& b) {
  return b <= a;
}
template <Number E>
Mask4 operator==(const Pack4<E>& a, const Pack4<E>& b) {
  return lane_by_lane([](E x, E y) { return x == y; }, a, b);
}

inline Index4 operator>>(const Index4& a, int bits) {
  return lane_by_lane([bits](std::int32_t x) { return x >> bits; }, a);
}
inline Index4 operator&(const Index4& a, const Index4& b) {
  return lane_by_lane([](std::int32_t x, std::int32_t y) { return x & y; }, a, b);
}

inline Mask4 operator&(const Mask4& a, const Mask4& b) {
  return lane_by_lane([](bool x, bool y) { return x && y; }, a, b);
}
inline Mask4 operator|(const Mask4& a, const Mask4& b) {
  return lane_by_lane([](bool x, bool y) { return x || y; }, a, b);
}
inline Mask4 operator!(const Mask4& a) {
  return lane_by_lane([](bool x) { return !x; }, a);
}
inline bool any(const Mask4& mask) { return mask[0] || mask[1] || mask[2] || mask[3]; }
inline bool all(const Mask4& mask) { return mask[0] && mask[1] && mask[2] && mask[3]; }

template <class E>
Pack4<E> select(const Mask4& mask, const Pack4<E>& yes, const Pack4<E>& no) {
  return lane_by_lane([](bool m, E y, E n) { return m ? y : n; }, mask, yes, no);
}

inline Lanes4 sqrt(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::sqrt(v); }, x);
}
inline Lanes4 exp(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::exp(v); }, x);
}
inline Lanes4 log(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::log(v); }, x);
}
inline Lanes4 sin(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::sin(v); }, x);
}
inline Lanes4 cos(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::cos(v); }, x);
}
inline Lanes4 acos(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::acos(v); }, x);
}
inline Lanes4 abs(const Lanes4& x) {
  return lane_by_lane([](double v) { return std::abs(v); }, x);
}
inline Lanes4 copysign(const Lanes4& x, const Lanes4& sign) {
  return lane_by_lane([](double v, double s) { return std::copysign(v, s); }, x, sign);
}

// Found by the unqualified calls through the namespace of their integer lanes.
template <class T, class Stored>
  requires std::same_as<T, Lanes4>
Lanes4 gather(const Stored* data, const Index4& i) {
  return lane_by_lane([data](std::int32_t k) { return static_cast<double>(data[k]); }, i);
}
template <class T>
  requires std::same_as<T, Lanes4>
Index4 gather_index(const std::int32_t* data, const Index4& i) {
  return lane_by_lane([data](std::int32_t k) { return data[k]; }, i);
}
template <class T>
  requires std::same_as<T, Lanes4>
Lanes4 to_real(const Index4& i) {
  return lane_by_lane([](std::int32_t k) { return static_cast<double>(k); }, i);
}
inline Index4 floor_index(const Lanes4& x) {
  return lane_by_lane([](double v) { return photic::floor_index(v); }, x);
}

}  // namespace photic::test

namespace photic {

template <>
struct LaneTraits<test::Lanes4> {
  using Element = double;
  using Mask = test::Mask4;
  using Index = test::Index4;
  using Counter = test::Counter4;
};

}  // namespace photic

namespace photic::test {

inline OctaveCell<Lanes4> octave_cell(const Lanes4& x, int bits) {
  OctaveCell<Lanes4> out;
  for (std::size_t i = 0; i < lanes; ++i) {
    const auto one = photic::octave_cell(x[i], bits);
    out.cell[i] = one.cell;
    out.fraction[i] = one.fraction;
  }
  return out;
}
template <class T>
  requires std::same_as<T, Lanes4>
Lanes4 octave_edge(const Index4& cell, int bits) {
  return lane_by_lane([bits](std::int32_t k) { return photic::octave_edge<double>(k, bits); },
                      cell);
}

inline std::array<Lanes4, 4> uniforms(const RandomPlace<Lanes4>& place, std::uint32_t block) {
  std::array<Lanes4, 4> out;
  for (std::size_t i = 0; i < lanes; ++i) {
    const auto one =
        photic::uniforms(RandomPlace<double>{place.seed, place.photon[i], place.event[i]}, block);
    for (std::size_t k = 0; k < one.size(); ++k) out[k][i] = one[k];
  }
  return out;
}

}  // namespace photic::test
