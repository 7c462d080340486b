// Collisions forced on the way ahead: whatever the points are drawn from, times their weight they
// lie where photons collide.
#include "estimator/forward/forced.hpp"

#include <gtest/gtest.h>

#include "support/mean.hpp"
#include "support/random.hpp"
#include "support/z_test.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using V = Vec3<double>;

struct FlightCase {
  std::string what;
  V direction;
  double depth;
  std::vector<estimator::ViewCone<double>> views;
};

std::vector<FlightCase> flight_cases() {
  const V down{0, 0, -1};
  const estimator::ViewCone<double> above{{0, 0, 0}, down, 0.9, 0.4, 0.01};
  const estimator::ViewCone<double> wide{{0, 0, 0}, down, 0.3, 1.0, 0.7};
  const estimator::ViewCone<double> aside{{5, 0, 0}, normalised(V{-0.5, 0, -1}), 0.4, 0.5, 0.0};
  const estimator::ViewCone<double> submerged{{0, 1, -6}, {0, 0, 1}, 0.7, 0.2, 0.02};
  const V out_of_view{0.8, 0, 0.6};
  return {
      {"no telescope", {0, 0.6, 0.8}, 14, {}},
      {"past the view of the only telescope", out_of_view, 8, {above}},
      {"up a view", {0, 0, 1}, 14, {above}},
      {"down a view", {0, 0, -1}, 2, {above}},
      {"nearly along the axis", normalised(V{0.005, 0, 1}), 14, {above}},
      {"level through a view", normalised(V{-1, 0.3, 0}), 3, {above}},
      {"nearly level through a wide view", normalised(V{1, 0, 0.02}), 3, {wide}},
      {"upwards through a wide view", normalised(V{0.5, 0.1, 1}), 12, {wide}},
      {"downwards through a wide view", normalised(V{0.5, 0.1, -1}), 4, {wide}},
      {"up two views", {0, 0, 1}, 20, {above, wide}},
      {"up one view and past another", {0, 0, 1}, 14, {above, aside}},
      {"through two of three views", normalised(V{-0.2, 0.1, 1}), 10, {wide, aside, submerged}},
      {"up into the view of a telescope in the water", normalised(V{0, 0.2, 1}), 14, {submerged}}};
}

// Weighted numbers of points within each metre against the share of light that collides there, and
// nothing where the ray has left the water. z-tests, 1 % for the family. Seen red: with the free
// flights left out of the density; with the views not counted in it; with the stretch's share of
// the whole left out; with the weight not put to the density of collisions.
TEST(ForcedCollision, TimesItsWeightLiesWherePhotonsCollide) {
  constexpr int samples = 200000;
  constexpr double bottom = 25;
  const auto sea = make_sea(bottom);
  test::Random random(91);
  test::ZFamily family(0.01);
  for (const FlightCase& c : flight_cases()) {
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
      const bool reached =
          estimator::force_collision(sea.view(), photon, c.views,
                                     {random.uniform(), random.uniform(), random.uniform()})
              .reached;
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
// of the points lie; and half of those of a ray that crosses a narrow view lie in it.
TEST(ForcedCollision, ReachesTheViewOfATelescope) {
  const auto sea = make_sea(25);
  const estimator::ViewCone<double> view{{0, 0, 0}, {0, 0, -1}, 0.9, 0.3, 0.01};
  test::Random random(92);
  const auto count = [&](const V& start, const V& direction, const auto& is_there) {
    int there = 0;
    for (int i = 0; i < 10000; ++i) {
      Photon<double> photon;
      photon.position = start;
      photon.direction = normalised(direction);
      photon.layer = sea.layer_at(-start.z);
      const bool reached =
          estimator::force_collision(sea.view(), photon, {view},
                                     {random.uniform(), random.uniform(), random.uniform()})
              .reached;
      there += reached && is_there(photon.position);
    }
    return there;
  };
  EXPECT_GT(count({0, 0, -20}, {0, 0, 1}, [](const V& p) { return p.z > -1.5; }), 3300);
  const auto inside = [](const V& p) { return std::hypot(p.x, p.y) < 0.3 - 0.01 * p.z; };
  EXPECT_GT(count({-8, 0.1, -2}, {1, 0, 0}, inside), 4800);
  EXPECT_GT(count({-8, 0.1, -9}, {1, 0, 1}, inside), 4800);
  EXPECT_LT(count({-8, 3, -2}, {1, 0, 0}, inside), 1);
}

}  // namespace
}  // namespace photic::transport
