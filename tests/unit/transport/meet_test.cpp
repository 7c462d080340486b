// Where rays of both walks meet.
#include "transport/meet.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/refracted_rays.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

// Seen red: with half the density; without the sign above the level.
TEST(MeetingGrid, NumbersPointsAsDenselyAsItSays) {
  Random random(501);
  for (int i = 0; i < 1000; ++i) {
    const MeetingGrid<double> grid{random.chance(0.3) ? 0 : random.between(0, 20),
                                   random.scale(1, 100), random.scale(1, 1000)};
    EXPECT_NEAR(grid.number(grid.level + grid.range), grid.points, 1e-12 * grid.points);
    const double depth = grid.level + random.between(-1, 2) * grid.range;
    const double number = grid.number(depth);
    ASSERT_EQ(number > 0, depth > grid.level);
    ASSERT_NEAR(grid.depth(number), depth, 1e-12 * (grid.range + grid.level));
    const double step = 1e-3 * std::abs(depth - grid.level);
    const auto slope = derivative([&](double z) { return grid.number(z); }, depth, step);
    ASSERT_NEAR(grid.density(depth), slope, 1e-9 * slope);
  }
}

struct Pair {
  Ray<double> laser, back;
};
/// Two rays that have come close to each other at some depth, mostly both up or both down.
Pair random_pair(const instrument::Telescope<double>& telescope, Random& random) {
  const V close{random.between(-1, 1), random.between(-1, 1), -random.between(15, 25)};
  V beside = 2 * telescope.lens_radius * random.uniform() * random.direction();
  beside.z = 0;
  Pair pair;
  pair.laser.direction = random.direction();
  pair.back.direction = random.chance(0.1) ? pair.laser.direction : random.direction();
  if (random.chance(0.8))
    pair.back.direction.z = std::copysign(pair.back.direction.z, pair.laser.direction.z);
  pair.laser.position = close - random.between(-1, 15) * pair.laser.direction;
  pair.back.position = close + beside - random.between(-1, 15) * pair.back.direction;
  return pair;
}

/// Whether light turns back up or down where rays meet at a depth if the telescope's walk is
/// shifted so that it still comes through the lens' rim; and where it does.
bool can_meet(const Pair& pair, const instrument::Telescope<double>& telescope,
              const instrument::PlanePoint<double>& lens, double depth,
              instrument::PlanePoint<double>& shifted) {
  const auto reach = [depth](const Ray<double>& r) {
    return (-depth - r.position.z) / r.direction.z;
  };
  const V shift = pair.laser.position + reach(pair.laser) * pair.laser.direction -
                  pair.back.position - reach(pair.back) * pair.back.direction;
  shifted = {lens.x + dot(shift, telescope.across), lens.y + dot(shift, telescope.up)};
  return pair.laser.direction.z * pair.back.direction.z > 0 && reach(pair.laser) > 0 &&
         reach(pair.back) > 0 && std::hypot(shifted.x, shifted.y) < telescope.lens_radius;
}

// Seen red: with rays that go different ways; with rays beyond the upper one's beginning; with
// depths above the lower; with the middle mirrored in the surface; with one division by the square
// missing; with the lens' rim asked of parallel rays.
TEST(Chord, HoldsTheDepthsAtWhichRaysCanMeet) {
  Random random(502);
  constexpr double deepest = 40;
  int exists = 0, inside = 0, outside = 0, parallel = 0;
  for (int n = 0; n < 20000; ++n) {
    auto scene = instrument::random_telescope(random);
    scene.direction = {0, 0, random.chance(0.5) ? 1.0 : -1.0};
    const auto telescope = instrument::make_telescope<double>(scene);
    const auto lens = lens_point(telescope, random.uniform(), random.uniform());
    const Pair pair = random_pair(telescope, random);
    const auto c = chord(pair.laser, pair.back, telescope, lens, deepest);
    exists += c.exists;
    parallel += c.exists && pair.laser.direction == pair.back.direction;
    for (int i = 0; i < 20; ++i) {
      const double length = c.to - c.from;
      const double depth = c.exists && i % 2 == 0 ? c.from + random.between(-0.2, 1.2) * length
                                                  : random.between(0, deepest);
      if (depth < 0 || depth > deepest) continue;
      if (std::abs(depth - c.from) < 1e-8 || std::abs(depth - c.to) < 1e-8) continue;
      instrument::PlanePoint<double> shifted{};
      const bool meets = can_meet(pair, telescope, lens, depth, shifted);
      ASSERT_EQ(meets, c.exists && depth > c.from && depth < c.to) << n << " " << depth;
      if (!meets) {
        ++outside;
        continue;
      }
      ++inside;
      ASSERT_NEAR(c.lens.x + depth * c.per_depth.x, shifted.x, 1e-7);
      ASSERT_NEAR(c.lens.y + depth * c.per_depth.y, shifted.y, 1e-7);
    }
  }
  EXPECT_GT(exists, 2000);
  EXPECT_GT(parallel, 100);
  EXPECT_GT(inside, 10000);
  EXPECT_GT(outside, 10000);
}

}  // namespace
}  // namespace photic::transport
