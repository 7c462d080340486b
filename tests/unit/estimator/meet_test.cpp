// Where rays of both walks meet.
#include "estimator/bidirectional/meet.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/random.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/refracted_rays.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

// Seen red: with another share for paths of one vertex, of two, of more; with steps twice as long.
TEST(MeetingGrid, IsDenserForPathsOfMoreVertices) {
  const estimator::MeetingGrid<double> grid{8};
  const std::array<double, 6> density{1, 1, 2, 8, 8, 8};
  for (std::int32_t order = 1; order < 6; ++order) {
    const double expected = density[static_cast<std::size_t>(order)];
    EXPECT_EQ(grid.density(order), expected);
    EXPECT_EQ(grid.number(3, order), 3 * expected);
    EXPECT_EQ(grid.depth(3 * expected, order), 3);
  }
}

struct Pair {
  estimator::Ray<double> laser, back;
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
  // Those that go down may come from above the surface, as images do of what it reflects.
  const auto reach = [&](const V& direction) {
    return random.between(-1, direction.z < 0 && random.chance(0.3) ? 40 : 15);
  };
  pair.laser.position = close - reach(pair.laser.direction) * pair.laser.direction;
  pair.back.position = close + beside - reach(pair.back.direction) * pair.back.direction;
  pair.laser.path = random.between(0, 40);
  pair.back.path = random.between(0, 40);
  return pair;
}

const Sea sea = make_sea(40);
constexpr double deepest = 40;

estimator::DepthLine<double> line_of(const estimator::Ray<double>& ray) {
  return estimator::depth_line(sea.view(), ray, deepest);
}

/// How far a ray goes to a depth.
double reach(const estimator::Ray<double>& r, double depth) {
  return (-depth - r.position.z) / r.direction.z;
}

/// The walks' paths, if they meet at a depth.
double path_to(const Pair& pair, double depth) {
  return pair.laser.path + pair.back.path +
         sea.line[0].group_index * (reach(pair.laser, depth) + reach(pair.back, depth));
}

// Rays that go up, and as the surface reflects them. Seen red: with the path at the surface for
// that where the ray begins; with the image's path shrinking with depth.
TEST(DepthLines, AreTheRays) {
  Random random(505);
  const auto telescope = instrument::make_telescope<double>(instrument::random_telescope(random));
  int images = 0;
  for (int n = 0; n < 1000; ++n) {
    const estimator::Ray<double> ray = random_pair(telescope, random).laser;
    const bool rises = ray.direction.z > 0;
    images += rises;
    for (const bool mirrored : {false, true}) {
      if (mirrored && !rises) continue;
      const estimator::Ray<double> of = mirrored ? estimator::reflected(sea.view(), ray) : ray;
      const auto line = mirrored ? estimator::reflected(line_of(ray), deepest) : line_of(ray);
      const double depth = random.between(0, deepest);
      const V place = of.position + reach(of, depth) * of.direction;
      const double scale = 1 + std::abs(reach(of, depth));
      ASSERT_NEAR(line.x + depth * line.x_per_depth, place.x, 1e-11 * scale);
      ASSERT_NEAR(line.y + depth * line.y_per_depth, place.y, 1e-11 * scale);
      ASSERT_NEAR(line.path + depth * line.path_per_depth,
                  of.path + sea.line[0].group_index * reach(of, depth), 1e-11 * scale);
      ASSERT_EQ(depth > line.from && depth<line.to, reach(of, depth)> 0);
      ASSERT_EQ(line.start, ray.path);
      ASSERT_EQ(line.rise, of.direction.z);
    }
  }
  EXPECT_GT(images, 300);
}

/// Where the telescope's walk comes through the lens' plane if it is translated to meet the other
/// at a depth, and how much longer its way from there is.
instrument::LensTranslation<double> translated_to(const Pair& pair,
                                                  const instrument::Telescope<double>& telescope,
                                                  const estimator::AtLens<double>& start,
                                                  double depth) {
  V translation = pair.laser.position + reach(pair.laser, depth) * pair.laser.direction -
                  pair.back.position - reach(pair.back, depth) * pair.back.direction;
  translation.z = 0;  // but for rounding
  const V ray_through = in_space(telescope, start.lens) + translation;
  // Along the ray to the plane (x - centre) . axis = 0.
  const double along =
      dot(telescope.position - ray_through, telescope.axis) / dot(start.outward, telescope.axis);
  const V from_centre = ray_through + along * start.outward - telescope.position;
  return {{dot(from_centre, telescope.across), dot(from_centre, telescope.up)}, -along};
}

/// Whether light reverses up or down where rays meet at a depth if the telescope's walk is
/// translated so that it still comes through the lens' rim.
bool can_meet(const Pair& pair, const instrument::Telescope<double>& telescope,
              const instrument::PlanePoint<double>& translated, double depth) {
  return pair.laser.direction.z * pair.back.direction.z > 0 && reach(pair.laser, depth) > 0 &&
         reach(pair.back, depth) > 0 &&
         std::hypot(translated.x, translated.y) < telescope.lens_radius;
}

// Seen red: with images of the laser's rays that meet others above the surface; with rays that go
// different ways; with rays beyond the upper one's beginning; with
// depths above the lower; with the middle mirrored in the surface; with one division by the square
// missing; with the lens' rim asked of parallel rays; and of tilted lenses with the way as long as
// before, with its group index left out, with the translation taken for one within the lens' plane.
TEST(Chord, HoldsTheDepthsAtWhichRaysCanMeet) {
  Random random(502);
  int exists = 0, inside = 0, outside = 0, parallel = 0, late = 0, tilted = 0;
  for (int n = 0; n < 20000; ++n) {
    auto scene = instrument::random_telescope(random);
    if (random.chance(0.5)) scene.direction = {0, 0, random.chance(0.5) ? 1.0 : -1.0};
    const auto telescope = instrument::make_telescope<double>(scene);
    const auto slope = instrument::ring_point(0.0, 0.5, random.uniform(), random.uniform());
    const estimator::AtLens<double> start{lens_point(telescope, random.uniform(), random.uniform()),
                                          outward(telescope, slope), random.between(1, 1.4)};
    const Pair pair = random_pair(telescope, random);
    const double last_path = random.between(20, 160);
    const auto c =
        estimator::chord(line_of(pair.laser), line_of(pair.back), telescope, start, last_path);
    if (telescope.upright) {
      const auto of_upright = estimator::chord(line_of(pair.laser), line_of(pair.back), telescope,
                                               start.lens, last_path);
      ASSERT_EQ(of_upright.exists, c.exists) << n;
      ASSERT_EQ(of_upright.from, c.from) << n;
      ASSERT_EQ(of_upright.to, c.to) << n;
    }
    const bool may = estimator::reverses(pair.laser, pair.back);
    exists += may && c.exists;
    if (c.exists) {
      ASSERT_GE(c.from, 0) << n;
    }
    parallel += c.exists && pair.laser.direction == pair.back.direction;
    for (int i = 0; i < 20; ++i) {
      const double length = c.to - c.from;
      const double depth = c.exists && i % 2 == 0 ? c.from + random.between(-0.2, 1.2) * length
                                                  : random.between(0, deepest);
      if (depth < 0 || depth > deepest) continue;
      if (std::abs(depth - c.from) < 1e-8 || std::abs(depth - c.to) < 1e-8) continue;
      const auto [translated, longer] = translated_to(pair, telescope, start, depth);
      const bool can = can_meet(pair, telescope, translated, depth);
      const bool meets = can && path_to(pair, depth) + start.index * longer < last_path;
      late += can && !meets;
      ASSERT_EQ(meets, may && c.exists && depth > c.from && depth < c.to) << n << " " << depth;
      if (!meets) {
        ++outside;
        continue;
      }
      ++inside;
      ASSERT_NEAR(c.lens.at(depth).x, translated.x, 1e-7);
      ASSERT_NEAR(c.lens.at(depth).y, translated.y, 1e-7);
      const auto aside = translated + -1.0 * start.lens;
      if (std::abs(start.outward.z) >= instrument::flattest_translated) {
        ASSERT_NEAR(longer_by_translation(telescope, start.outward, aside), longer, 1e-7);
      }
      tilted += !telescope.upright;
    }
  }
  EXPECT_GT(exists, 2000);
  EXPECT_GT(parallel, 100);
  EXPECT_GT(late, 2000);
  EXPECT_GT(inside, 10000);
  EXPECT_GT(outside, 10000);
  EXPECT_GT(tilted, 3000);
}

/// How far a ray's place at a depth is from an axis, squared.
double off_axis(const estimator::Ray<double>& ray, const estimator::RotationAxis<double>& axis,
                double depth) {
  const V place = ray.position + (-depth - ray.position.z) / ray.direction.z * ray.direction;
  const double x = place.x - axis.x, y = place.y - axis.y;
  return x * x + y * y;
}

// Against a search in small steps; and the rotation brings the rays together. Seen red: with the
// depths above the one for those below it where paths shrink with depth.
TEST(EquidistantDepths, AreWhereBothRaysAreAsFarFromTheAxis) {
  Random random(503);
  constexpr int steps = 2000;
  int crossed = 0, twice = 0, none = 0;
  scene::Telescope scene = instrument::random_telescope(random);
  const auto telescope = instrument::make_telescope<double>(scene);
  for (int n = 0; n < 2000; ++n) {
    const Pair pair = random_pair(telescope, random);
    const estimator::RotationAxis<double> axis{true, random.between(-5, 5), random.between(-5, 5)};
    const double last_path = random.between(20, 160);
    const auto c =
        estimator::equidistant_depths(line_of(pair.laser), line_of(pair.back), axis, last_path);
    int found = 0, unsure = 0;
    const bool laser_down = pair.laser.direction.z < 0, back_down = pair.back.direction.z < 0;
    const double a = -pair.laser.position.z, b = -pair.back.position.z;
    const double from = std::max({0.0, laser_down ? a : 0, back_down ? b : 0});
    const double to = std::min(laser_down ? deepest : a, back_down ? deepest : b);
    const auto difference = [&](double depth) {
      return off_axis(pair.laser, axis, depth) - off_axis(pair.back, axis, depth);
    };
    for (int i = 0; to > from && i < steps; ++i) {
      const double upper = from + (to - from) * i / steps;
      const double lower = from + (to - from) * (i + 1) / steps;
      if (difference(upper) * difference(lower) >= 0) continue;
      const bool early = path_to(pair, upper) < last_path,
                 early_below = path_to(pair, lower) < last_path;
      if (early != early_below) ++unsure;
      if (!early || !early_below) continue;
      ++found;
      EXPECT_TRUE((c.exists[0] && c.depth[0] > upper - 1e-9 && c.depth[0] < lower + 1e-9) ||
                  (c.exists[1] && c.depth[1] > upper - 1e-9 && c.depth[1] < lower + 1e-9))
          << n << " " << upper;
    }
    const int counted = c.exists[0] + c.exists[1];
    // Two crossings may hide in one step.
    if (unsure == 0 && (counted != 2 || found != 0)) {
      ASSERT_EQ(counted, found) << n;
    }
    (counted == 0 ? none : counted == 1 ? crossed : twice) += 1;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!c.exists[i]) continue;
      EXPECT_LT(path_to(pair, c.depth[i]), last_path) << n;
      const auto rotation = estimator::rotation_to_meet(pair.laser, pair.back, axis, c.depth[i]);
      const auto at = [&](const estimator::Ray<double>& r) {
        return r.position + (-c.depth[i] - r.position.z) / r.direction.z * r.direction;
      };
      estimator::Ray<double> back = pair.back;
      back.position = rotation.of_place(back.position);
      back.direction = rotation.of_direction(back.direction);
      EXPECT_LT(length(at(back) - at(pair.laser)), 1e-5) << n;
      EXPECT_NEAR(length(back.direction), 1, 1e-14);
      EXPECT_NEAR(off_axis(back, axis, 3), off_axis(pair.back, axis, 3),
                  1e-12 * off_axis(back, axis, 3));
    }
  }
  EXPECT_GT(crossed, 200);
  EXPECT_GT(twice, 50);
  EXPECT_GT(none, 200);
}

// Floats have no squares of squares of what is that near. Seen red: with one root of the product of
// both distances' squares.
TEST(RotationToMeet, IsARotationHoweverNearTheVertical) {
  for (const float off : {1.0F, 1e-6F, 1e-12F, 1e-16F, 0.0F}) {
    estimator::Ray<float> laser, back;
    laser.position = {off, 0, -1};
    back.position = {0, off, -1};
    laser.direction = back.direction = {0, 0, -1};
    const auto rotation =
        estimator::rotation_to_meet(laser, back, estimator::RotationAxis<float>{true, 0, 0}, 2.0F);
    EXPECT_NEAR(rotation.cosine * rotation.cosine + rotation.sine * rotation.sine, 1, 1e-6) << off;
  }
}

// The volume that two rays sweep about where they meet, against finite differences: how the place
// where they meet, and the rotation, follow from both directions.
TEST(RotationJacobian, IsVolumePerSolidAngleAndRotation) {
  Random random(504);
  for (int n = 0; n < 1000; ++n) {
    const V laser{random.between(-1, 1), random.between(-1, 1), -1};
    const V back{random.between(-1, 1), random.between(-1, 1), -2};
    const V met{random.between(-8, 8), random.between(-8, 8), -random.between(10, 30)};
    const estimator::RotationAxis<double> axis{true, random.between(-1, 1), random.between(-1, 1)};
    // Columns: how both directions change with the place in x, y, z, and with the rotation of
    // `back`.
    const auto directions = [&](const V& place, double angle) {
      const V foot{axis.x, axis.y, 0};
      const V r = place - foot;
      const V rotated{std::cos(angle) * r.x - std::sin(angle) * r.y,
                      std::sin(angle) * r.x + std::cos(angle) * r.y, r.z};
      return std::array<V, 2>{normalised(place - laser), normalised(foot + rotated - back)};
    };
    const auto [w, v] = directions(met, 0);
    // Two directions across each.
    const V wa = normalised(cross(w, V{0.3, 0.5, 0.8})), wb = cross(w, wa);
    const V va = normalised(cross(v, V{0.3, 0.5, 0.8})), vb = cross(v, va);
    std::array<std::array<double, 4>, 4> m{};
    const std::array<V, 3> axes{V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at = [&](double h) {
        return directions(k < 3 ? met + h * axes[k] : met, k < 3 ? 0 : h);
      };
      const std::array<V, 4> across{wa, wb, va, vb};
      for (std::size_t i = 0; i < 4; ++i)
        m[i][k] = derivative([&](double h) { return dot(at(h)[i / 2], across[i]); }, 0, 1e-3);
    }
    double determinant = 1;  // by elimination
    for (std::size_t k = 0; k < 4; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < 4; ++i)
        if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
      std::swap(m[k], m[pivot]);
      determinant *= m[k][k];
      for (std::size_t i = k + 1; i < 4; ++i)
        for (std::size_t j = 4; j-- > k;) m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
    const double t = length(met - laser), s = length(met - back);
    const double expected = estimator::rotation_jacobian(met, w, v).about(axis);
    ASSERT_NEAR(std::abs(determinant) * t * t * s * s, expected, 1e-6 * (1 + expected)) << n;
  }
}

}  // namespace
}  // namespace photic::transport
