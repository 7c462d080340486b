// The straight ways to one point of an instrument, against rays traced forward.
#include "geometry/sightline.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "transport/cross.hpp"
#include "transport/emit.hpp"
#include "unit/transport/enter_water.hpp"
#include "unit/transport/refracted_rays.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

void expect_depths(const geometry::OpticalDepths<double>& depths, const Sea& sea, std::int32_t line,
                   const std::vector<V>& points) {
  double all = 0, walk = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    all += optical_depth_between(sea, line, points[i - 1], points[i]);
    walk += integral_between(sea, walk_coefficients(sea), line, points[i - 1], points[i]);
  }
  ASSERT_NEAR(depths.all / all, 1, 1e-9);
  ASSERT_NEAR(depths.walk / walk, 1, 1e-9);
}

geometry::OpticalDepths<double> depths_along(const Sea& sea, const geometry::Sightline<double>& way,
                                             std::int32_t line, const V& from, double length) {
  const auto level = sea.view().level(sea.layer_at(-from.z), -from.z);
  return geometry::optical_depths(sea.view(),
                                  geometry::along(sea.view(), way, line, level, length));
}

// Light that leaves in the way's direction is refracted by Snell's law and must arrive at the
// point; its spread is that of the rays beside it, its transmittance that of light going the other
// way. Seen red: with the cosines of air and water swapped in the spread; with
// n for n^2; with the length in water by the angle in air; with the arriving ray times the cosine
// in water; with the reflected share.
TEST(WayThroughSurface, IsTheWayOfALightRay) {
  Random random(201);
  const auto sea = make_sea(60);
  for (int i = 0; i < 5000; ++i) {
    const std::int32_t line = random.below(3);
    const double n = sea.line[static_cast<std::size_t>(line)].refractive_index;
    const V from = random_place(random);
    const V to{random.between(-10, 10), random.between(-10, 10), random.scale(0.5, 100)};
    auto way = geometry::sightline_through_surface(sea.view(), from, line, to, true);
    ASSERT_TRUE(way.exists);
    ASSERT_NEAR(length(way.direction), 1, 1e-13);
    const double in_water = -from.z / way.direction.z;
    const V surface = from + in_water * way.direction;
    V air{n * way.direction.x, n * way.direction.y, 0};
    air.z = std::sqrt(1 - dot(air, air));
    const double in_air = to.z / air.z;
    const double whole = in_air + in_water;
    ASSERT_LT(length(surface + in_air * air - to), 1e-9 * whole);
    ASSERT_LT(length(way.arriving - air), 1e-11);
    ASSERT_NEAR(way.length_water, in_water, 1e-12 * whole);
    ASSERT_NEAR(way.length_air, in_air, 1e-9 * whole);
    ASSERT_LT(length(way.crossing - surface), 1e-9 * whole);
    ASSERT_EQ(way.index_squared, n * n);
    ASSERT_NEAR(way.area_per_solid_angle * solid_angle_per_area(n, -from.z, to.z, std::acos(air.z)),
                1, 1e-5);

    Photon<double> down;
    down.line = line;
    down.position = to;
    down.direction = -air;
    test::enter_water(sea.view(), {true, 0}, down);
    ASSERT_NEAR(way.throughput, down.weight, 1e-9);

    way.to.outside = true;
    expect_depths(depths_along(sea, way, line, from, way.length_water), sea, line,
                  {from, {surface.x, surface.y, 0}});
  }
}

TEST(WayThroughSurface, IsNoneThatIsNotWanted) {
  const auto sea = make_sea(60);
  const V to{1, 2, 12};
  EXPECT_FALSE(geometry::sightline_through_surface(sea.view(), V{0, 0, -3}, 0, to, false).exists);
}

// Seen red: with the end as deep below as it is above; with 1 / distance for its square.
TEST(WayInWater, IsTheStraightLine) {
  Random random(202);
  const auto sea = make_sea(40);
  for (int i = 0; i < 5000; ++i) {
    const V from = random_place(random);
    const V to = i % 10 == 0 ? V{3, random.between(-10, 10), from.z} : random_place(random);
    const std::int32_t line = random.below(3);
    auto way = geometry::sightline_in_water(sea.view(), from, line, to, geometry::Route::direct);
    ASSERT_TRUE(way.exists);
    ASSERT_LT(length(from + way.length_water * way.direction - to), 1e-12);
    ASSERT_EQ(way.arriving, way.direction);
    ASSERT_EQ(way.length_air, 0);
    ASSERT_EQ(way.index_squared, 1);
    ASSERT_EQ(way.throughput, 1);
    ASSERT_NEAR(way.area_per_solid_angle / dot(to - from, to - from), 1, 1e-12);
    // Also of its first part alone: the last part to a laser's vertex lies behind its disc.
    for (const double share : {1.0, 0.7}) {
      const double length = share * way.length_water;
      const V end = from + length * way.direction;
      way.to.layer = sea.layer_at(-end.z);
      expect_depths(depths_along(sea, way, line, from, length), sea, line, {from, end});
    }
  }
}

// Unfolded it ends in the mirror image above the surface. Seen red: with the lens for its image;
// with the arriving ray not mirrored; with the depth of the end subtracted; with c for the walked
// coefficient.
TEST(WayInWater, MirroredIsTheStraightLineToTheMirrorImage) {
  Random random(203);
  const auto sea = make_sea(40);
  int total = 0, partly = 0;
  for (int i = 0; i < 5000; ++i) {
    const V from = random_place(random);
    V to = random_place(random);
    to.x += random.chance(0.5) ? 40 : 0;
    const std::int32_t line = random.below(3);
    auto way = geometry::sightline_in_water(sea.view(), from, line, to, geometry::Route::mirrored);
    const V image{to.x, to.y, -to.z};
    ASSERT_TRUE(way.exists);
    ASSERT_LT(length(from + way.length_water * way.direction - image), 1e-12);
    ASSERT_EQ(way.arriving, (V{way.direction.x, way.direction.y, -way.direction.z}));
    ASSERT_NEAR(way.area_per_solid_angle / dot(image - from, image - from), 1, 1e-12);
    const double n = sea.line[static_cast<std::size_t>(line)].refractive_index;
    const double sine = n * std::hypot(way.direction.x, way.direction.y);
    if (sine >= 1) {
      ASSERT_EQ(way.throughput, 1);
      ++total;
    } else {
      const double cos_air = std::sqrt(1 - sine * sine);
      ASSERT_NEAR(way.throughput, optics::fresnel_reflectance(n, 1.0, way.direction.z, cos_air),
                  1e-9);
      ++partly;
    }
    const V surface = from + (-from.z / way.direction.z) * way.direction;
    for (const double share : {1.0, 0.95}) {
      const double length = share * way.length_water;
      V end = from + length * way.direction;
      if (end.z < 0) continue;  // in the first half
      end.z = -end.z;
      way.to.layer = sea.layer_at(-end.z);
      expect_depths(depths_along(sea, way, line, from, length), sea, line,
                    {from, {surface.x, surface.y, 0}, end});
    }
  }
  EXPECT_GT(total, 1000);
  EXPECT_GT(partly, 1000);
}

TEST(WayInWater, FromThePointItselfIsNone) {
  const auto sea = make_sea(40);
  EXPECT_FALSE(
      geometry::sightline_in_water(sea.view(), V{1, 2, -3}, 0, V{1, 2, -3}, geometry::Route::direct)
          .exists);
}

}  // namespace
}  // namespace photic::transport
