// Refraction at the surface: the crossing point and the spreading of a bundle.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "transport/connect.hpp"
#include "unit/transport/refracted_rays.hpp"

namespace photic::transport {
namespace {

constexpr double index = 1.3415;

// Seen red: without n^2; with n for 1 / n in the path; with the paraxial spreading, the same along
// as across; with the cosines swapped in their ratio.
TEST(RefractedSolidAngle, IsThatOfTracedRays) {
  for (const double degrees : {0.0, 1.0, 30.0, 60.0, 80.0}) {
    for (const auto& [depth, height] : {std::pair{10.0, 12.0}, {0.1, 100.0}, {50.0, 0.5}}) {
      const double air = degrees * radian_per_degree;
      const double cos_air = std::cos(air);
      const double cos_water = std::sqrt(1 - std::pow(std::sin(air) / index, 2));
      const double factor =
          geometry::refracted_area_per_solid_angle(1 / index, depth / cos_water, height / cos_air,
                                                   {cos_water / cos_air, cos_air / cos_water});
      EXPECT_NEAR(index * index * factor * solid_angle_per_area(index, depth, height, air), 1, 1e-6)
          << degrees << " " << depth;
    }
  }
}

TEST(RefractedSolidAngle, HasItsClosedForms) {
  EXPECT_NEAR(
      index * index * geometry::refracted_area_per_solid_angle(1 / index, 10.0, 12.0, {1.0, 1.0}),
      std::pow(index * 12 + 10, 2), 1e-12);
  EXPECT_NEAR(geometry::refracted_area_per_solid_angle(1.0, 3.0, 4.0, {1.0, 1.0}), 49, 1e-13);
}

/// The tangent in air.
double tangent_in_air(double depth, double height, double aside) {
  const auto start = geometry::crossing_start(1 / index, depth, height, aside * aside);
  return aside * geometry::crossing(index, depth, height, aside * aside, start);
}

/// How far aside a ray of tangent t in air has come.
long double aside_of(long double t, long double depth, long double height) {
  const long double sin_water = t / std::sqrt(1 + t * t) / static_cast<long double>(index);
  return height * t + depth * sin_water / std::sqrt(1 - sin_water * sin_water);
}

/// The tangent by bisection.
long double crossing_by_bisection(long double depth, long double height, long double aside) {
  long double low = 0;
  long double high = aside / height;  // straight through the air
  for (int i = 0; i < 200; ++i) {
    const long double middle = (low + high) / 2;
    (aside_of(middle, depth, height) < aside ? low : high) = middle;
  }
  return low;
}

// Lengths over twelve orders of magnitude, each. Where the light creeps along the surface its way
// aside barely depends on the tangent: what must hold to the last digits is Snell's law at the
// telescope, the tangent as far as it is determined. Seen red: with n for n^2 under the root; with
// one Newton step.
TEST(CrossingTangent, ObeysSnellOverTwelveOrdersOfMagnitude) {
  test::Random random(31);
  for (int i = 0; i < 100000; ++i) {
    const double depth = random.scale(1e-6, 1e6);
    const double height = random.scale(1e-6, 1e6);
    const double aside = random.scale(1e-6, 1e6);
    const double t = tangent_in_air(depth, height, aside);
    ASSERT_NEAR(static_cast<double>(aside_of(t, depth, height)) / aside, 1, 1e-13)
        << depth << " " << height << " " << aside;
    ASSERT_LE(index * aside / (index * height + depth), t * (1 + 1e-14))
        << "the paraxial tangent is never above";
    if (i % 20 != 0) continue;
    const long double slope =
        (aside_of(t * 1.001L, depth, height) - aside_of(t * 0.999L, depth, height)) / 0.002L;
    const double undetermined = 1e-13 * aside / static_cast<double>(slope);
    ASSERT_NEAR(t / static_cast<double>(crossing_by_bisection(depth, height, aside)), 1,
                1e-13 + undetermined)
        << depth << " " << height << " " << aside;
  }
}

TEST(CrossingTangent, OfAPointStraightBelowIsZero) { EXPECT_EQ(tangent_in_air(3, 12, 0), 0); }

// From the air into water, too: light goes as Snell's law has it, and comes to the point it is to
// come to. Seen red: with the way of the
// point in the thinner medium; with the secants of both media swapped.
TEST(RayThrough, LeadsBothWays) {
  test::Random random(32);
  for (int i = 0; i < 20000; ++i) {
    const double depth = random.scale(1e-3, 1e3), height = random.scale(1e-3, 1e3);
    const double x = random.scale(1e-3, 1e3), y = random.scale(1e-3, 1e3);
    for (const bool into_denser : {false, true}) {
      const double n = into_denser ? 1 / index : index;
      const auto [ray, per_rise] =
          geometry::ray_through(n, 1 / n, into_denser, depth, height, x, y, true);
      const Vec3<double> outside = ray.cos_air * ray.arriving;
      ASSERT_NEAR(length(ray.direction), 1, 1e-12);
      ASSERT_NEAR(length(outside), 1, 1e-12);
      ASSERT_NEAR(n * ray.direction.x, outside.x, 1e-12);
      ASSERT_NEAR(n * ray.direction.y, outside.y, 1e-12);
      ASSERT_NEAR(ray.secant_water * ray.direction.z, 1, 1e-12);
      ASSERT_NEAR(ray.cos_water * ray.secant_water, 1, 1e-12);
      ASSERT_NEAR(ray.secant_air * outside.z, 1, 1e-12);
      const double aside = depth * ray.secant_water * ray.direction.x + height * ray.arriving.x;
      ASSERT_NEAR(aside / x, 1, 1e-9) << depth << " " << height << " " << x << " " << y;
      ASSERT_GT(per_rise, 0);
    }
  }
}

// The series leaves out no more than it says. Seen red: without its last term; with share + 1 for
// share - 1.
TEST(CrossingStart, KnowsItsError) {
  for (const double depth : {0.1, 3.0, 30.0, 300.0}) {
    for (const double aside : {0.7, 1.0, 1.5}) {
      const auto start = geometry::crossing_start(1 / index, depth, 12.0, aside * aside);
      const auto exact =
          static_cast<double>(crossing_by_bisection(static_cast<long double>(depth), 12,
                                                    static_cast<long double>(aside)) /
                              static_cast<long double>(aside));
      const double off = 1 - start.per_rise / exact;
      EXPECT_LT(std::abs(off), start.error + 4e-16) << depth << " " << aside;
    }
  }
}

}  // namespace
}  // namespace photic::transport
