// Collisions forced on the way ahead: whatever the points are drawn from, times their weight they
// lie where photons collide.
#include "transport/forced.hpp"

#include <gtest/gtest.h>

#include "support/mean.hpp"
#include "support/random.hpp"
#include "support/z_test.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using V = Vec3<double>;

struct Case {
  std::string what;
  V direction;
  double depth;
  std::vector<Approach<double>> approaches;
};

std::vector<Case> cases() {
  const V down{0, 0, -1};
  const Approach<double> above{{0, 0, 0}, down, 0.9};
  const Approach<double> aside{{5, 0, 0}, normalised(V{-0.5, 0, -1}), 0.4};
  const Approach<double> submerged{{0, 1, -6}, {0, 0, 1}, 0.7};
  return {
      {"no telescope", {0, 0.6, 0.8}, 14, {}},
      {"away from the only telescope", {0, 0.6, -0.8}, 8, {above}},
      {"towards a telescope", {0, 0.6, 0.8}, 14, {above}},
      {"slowly towards a telescope", normalised(V{1, 0, 0.02}), 3, {above}},
      {"towards two telescopes", {0, 0, 1}, 20, {above, aside}},
      {"towards one of two telescopes", {0.6, 0, 0.8}, 14, {above, submerged}},
      {"down into the view of a telescope in the water", {0, 0.6, -0.8}, 2, {above, submerged}}};
}

// Weighted numbers of points within each metre against the share of light that collides there, and
// nothing where the ray has left the water. z-tests, 1 % for the family. Seen red: with one term of
// the density left out; with the speed along the axis left out of the density; with the weight not
// put to the density of collisions; with the approaches not counted.
TEST(ForcedCollision, TimesItsWeightLiesWherePhotonsCollide) {
  constexpr int samples = 200000;
  constexpr double bottom = 25;
  const auto sea = make_sea(bottom);
  test::Random random(91);
  test::ZFamily family(0.01);
  for (const Case& c : cases()) {
    const V start{0.3, -0.2, -c.depth};
    const double longest =
        (c.direction.z > 0 ? c.depth : bottom - c.depth) / std::abs(c.direction.z);
    const auto transmitted = [&](double s) {
      return std::exp(
          -optical_depth_between(sea, 0, start, start + std::min(s, longest) * c.direction));
    };
    const auto cells = static_cast<std::size_t>(std::min(15.0, std::ceil(longest)));
    std::vector<test::Mean> points(cells);
    for (int i = 0; i < samples; ++i) {
      Photon<double> photon;
      photon.position = start;
      photon.direction = c.direction;
      photon.layer = sea.layer_at(c.depth);
      photon.path = 7;
      const bool reached = force_collision(sea.view(), photon, c.approaches,
                                           {random.uniform(), random.uniform(), random.uniform()});
      double distance = 1e9;
      if (reached) {
        distance = length(photon.position - start);
        ASSERT_LT(length(photon.position - start - distance * c.direction), 1e-9);
        ASSERT_NEAR(photon.path, 7 + 1.3638 * distance, 1e-9);
        ASSERT_EQ(photon.layer, sea.layer_at(-photon.position.z));
        ASSERT_LE(distance, longest * (1 + 1e-12));
      } else {
        ASSERT_EQ(photon.weight, 0);
      }
      for (std::size_t k = 0; k < cells; ++k) {
        const double from = static_cast<double>(k);
        points[k].add(from <= distance && distance < from + 1 ? photon.weight : 0);
      }
    }
    for (std::size_t k = 0; k < cells; ++k) {
      const double from = static_cast<double>(k);
      family.add(points[k].value(), transmitted(from) - transmitted(from + 1), points[k].error(),
                 c.what + ", metre " + std::to_string(k));
    }
  }
  family.judge();
}

// What it is for: near the entry, where only a thousandth of the light from below collides, a third
// of the points lie.
TEST(ForcedCollision, ReachesTheEntryOfATelescope) {
  const auto sea = make_sea(25);
  test::Random random(92);
  const V start{0, 0, -20};
  int near = 0;
  for (int i = 0; i < 10000; ++i) {
    Photon<double> photon;
    photon.position = start;
    photon.direction = {0, 0, 1};
    photon.layer = 2;
    const bool reached = force_collision(sea.view(), photon, {{{0, 0, 0}, {0, 0, -1}, 0.9}},
                                         {random.uniform(), random.uniform(), random.uniform()});
    near += reached && photon.position.z > -1.5;
  }
  EXPECT_GT(near, 3300);
}

}  // namespace
}  // namespace photic::transport
