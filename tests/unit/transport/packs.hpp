// Four scalar states as one of four lanes, and back: what the comparisons of lanes with scalars
// share.
#pragma once

#include <gtest/gtest.h>

#include <bit>

#include "support/lanes4.hpp"
#include "support/random.hpp"
#include "transport/photon.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {

using test::Index4;
using test::lanes;
using test::Lanes4;
using test::Mask4;

/// Groups of four random states: 10,000 states.
inline constexpr int groups = 2500;

template <class E>
using Four = std::array<E, lanes>;

/// Four of what `make` makes.
template <class F>
auto four(F make) {
  return Four<decltype(make())>{make(), make(), make(), make()};
}

template <class E>
Pack<E, lanes> pack(const Four<E>& values) {
  return Pack<E, lanes>::load(values.data());
}
inline Mask4 pack(const Four<bool>& values) {
  Mask4 out;
  for (std::size_t i = 0; i < lanes; ++i) out.set(i, values[i]);
  return out;
}
/// One member of four states.
template <class S, class Member>
auto pack(const Four<S>& states, Member member) {
  return pack(Four<std::decay_t<decltype(member(states[0]))>>{
      member(states[0]), member(states[1]), member(states[2]), member(states[3])});
}
inline Vec3<Lanes4> pack(const Four<Vec3<double>>& values) {
  using V = Vec3<double>;
  return {pack(values, [](const V& v) { return v.x; }),
          pack(values, [](const V& v) { return v.y; }),
          pack(values, [](const V& v) { return v.z; })};
}
inline Photon<Lanes4> pack(const Four<Photon<double>>& values) {
  using P = Photon<double>;
  Photon<Lanes4> out;
  out.weight = pack(values, [](const P& p) { return p.weight; });
  out.analog_weight = pack(values, [](const P& p) { return p.analog_weight; });
  out.path = pack(values, [](const P& p) { return p.path; });
  out.line = pack(values, [](const P& p) { return p.line; });
  out.layer = pack(values, [](const P& p) { return p.layer; });
  out.order = pack(values, [](const P& p) { return p.order; });
  out.position = pack(Four<Vec3<double>>{values[0].position, values[1].position, values[2].position,
                                         values[3].position});
  out.direction = pack(Four<Vec3<double>>{values[0].direction, values[1].direction,
                                          values[2].direction, values[3].direction});
  return out;
}

/// Equal to the last bit: neither rounding nor the sign of a zero may differ.
inline void expect_same(double lane, double scalar, const char* what) {
  ASSERT_EQ(std::bit_cast<std::uint64_t>(lane), std::bit_cast<std::uint64_t>(scalar))
      << what << ": " << lane << " and " << scalar;
}
inline void expect_same(std::int32_t lane, std::int32_t scalar, const char* what) {
  ASSERT_EQ(lane, scalar) << what;
}
inline void expect_same(bool lane, bool scalar, const char* what) {
  ASSERT_EQ(lane, scalar) << what;
}

inline void expect_same(const Vec3<Lanes4>& packed, std::size_t i, const Vec3<double>& scalar,
                        const char* what) {
  expect_same(packed.x[i], scalar.x, what);
  expect_same(packed.y[i], scalar.y, what);
  expect_same(packed.z[i], scalar.z, what);
}
inline void expect_same(const Photon<Lanes4>& packed, std::size_t i, const Photon<double>& scalar) {
  expect_same(packed.position, i, scalar.position, "position");
  expect_same(packed.direction, i, scalar.direction, "direction");
  expect_same(packed.weight[i], scalar.weight, "weight");
  expect_same(packed.analog_weight[i], scalar.analog_weight, "analog weight");
  expect_same(packed.path[i], scalar.path, "path");
  expect_same(packed.line[i], scalar.line, "line");
  expect_same(packed.layer[i], scalar.layer, "layer");
  expect_same(packed.order[i], scalar.order, "order");
}

/// Four uniforms in (0, 1), one for each lane.
inline Four<double> uniforms4(test::Random& random) {
  return {random.uniform(), random.uniform(), random.uniform(), random.uniform()};
}

/// A photon somewhere in the sea, of any line and direction: also straight up, down and level, and
/// on the surface.
inline Photon<double> random_photon(const Sea& sea, test::Random& random) {
  Photon<double> photon;
  photon.line = random.below(3);
  photon.layer = random.below(3);
  const auto layer = static_cast<std::size_t>(photon.layer);
  const double bottom = std::min(sea.top[layer + 1], 40.0);
  const double depth = random.chance(0.1) ? sea.top[layer] : random.between(sea.top[layer], bottom);
  photon.position = {random.between(-20, 20), random.between(-20, 20), -depth};
  photon.direction = random.direction();
  if (random.chance(0.1)) photon.direction = {0, 0, 1};
  if (random.chance(0.1)) photon.direction = {0, 0, -1};
  if (random.chance(0.1))
    photon.direction = normalised(Vec3<double>{random.between(-1, 1), random.uniform(), 0});
  photon.weight = random.uniform();
  photon.analog_weight = random.scale(1e-5, 1);
  photon.path = random.between(12, 100);
  photon.order = random.below(20);
  return photon;
}

}  // namespace photic::transport
