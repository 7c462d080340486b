// The local estimate of single rays: their mean over the lens is that of the whole lens.
#include "transport/connect_ray.hpp"

#include <gtest/gtest.h>

#include "support/mean.hpp"
#include "support/random.hpp"
#include "support/z_test.hpp"
#include "unit/transport/connect_if_seen.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

/// A lens that is small against all distances here, with a detector that its blur nearly fills.
scene::Telescope small_telescope(const V& position, const V& direction) {
  scene::Telescope t;
  t.position_m = position;
  t.direction = direction;
  t.diameter_m = 0.05;
  t.obstruction_diameter_m = 0.02;
  t.focal_length_m = 0.5;
  t.detector_shift_m = 0.4;
  t.detector_diameter_m = 0.04;
  return t;
}

Connection<double> connect_ray(const Sea& sea, const scene::Telescope& scene,
                               const Photon<double>& at, std::int32_t line,
                               const instrument::PlanePoint<double>& lens, bool mirrored) {
  const auto telescope = instrument::make_telescope<double>(scene);
  return transport::connect_ray(sea.view(), telescope, region_at(sea, scene.position_m), at, line,
                                lens, route_of(mirrored),
                                may_see(sea.view(), telescope, at.position, line));
}
Connection<double> connect(const Sea& sea, const scene::Telescope& scene, const Photon<double>& at,
                           std::int32_t line, bool mirrored) {
  const auto telescope = instrument::make_telescope<double>(scene);
  return transport::connect(sea.view(), telescope, region_at(sea, scene.position_m), at, line,
                            route_of(mirrored), may_see(sea.view(), telescope, at.position, line));
}

/// Points about a place, lines, and lens points; z-tests, 1 % for the family.
void expect_same_mean(const scene::Telescope& scene, const V& place, bool mirrored,
                      std::uint64_t seed) {
  constexpr int rays = 4000;
  const auto sea = make_sea(60);
  const auto telescope = instrument::make_telescope<double>(scene);
  const double left_out = telescope.inside ? 0 : telescope.distance;  // of paths
  Random random(seed);
  test::ZFamily family(0.01);
  for (int n = 0; n < 100; ++n) {
    const auto at = photon_at(sea, place + V{random.between(-0.7, 0.7), random.between(-0.7, 0.7),
                                             random.between(-1, 1)});
    const std::int32_t line = random.below(3);
    const auto whole = connect(sea, scene, at, line, mirrored);
    test::Mean mean;
    int seen = 0;
    for (int i = 0; i < rays; ++i) {
      const auto ray =
          connect_ray(sea, scene, at, line,
                      lens_point(telescope, random.uniform(), random.uniform()), mirrored);
      mean.add(ray.acceptance);
      if (!(ray.acceptance > 0)) continue;
      ++seen;
      ASSERT_LT(length(ray.direction - whole.direction), 0.01);
      ASSERT_NEAR(ray.optical_depth / whole.optical_depth, 1, 0.01);
      ASSERT_NEAR(ray.path, whole.path, 0.01 * (whole.path + left_out));
    }
    if (whole.acceptance == 0) {
      ASSERT_LT(seen, 0.01 * rays);
    } else if (mean.error() > 2e-3 * mean.value()) {
      family.add(mean.value(), whole.acceptance, mean.error(), "point " + std::to_string(n));
    } else {
      ASSERT_NEAR(mean.value() / whole.acceptance, 1, 1e-3);
    }
  }
  EXPECT_GT(family.size(), 30);
  family.judge();
}

// Seen red: with all rays to the lens' centre; with rays beside the detector; with the reflected
// share; with the length in water by the angle in air.
TEST(ConnectRay, OverTheLensIsTheWholeThroughTheSurface) {
  expect_same_mean(small_telescope({0, 0, 10}, {0, 0, -1}), {0, 0, -15}, false, 301);
  expect_same_mean(small_telescope({1, 2, 12}, {0.3, 0, -1}), {6.3, 2, -8}, false, 302);
}

// Seen red: with all rays to the lens' centre; with rays beside the detector; with the optical
// depth of the mirrored end subtracted; with the arriving ray not mirrored.
TEST(ConnectRay, OverTheLensIsTheWholeInTheWater) {
  expect_same_mean(small_telescope({0, 0, -3}, {0, 0.2, -1}), {0, 3, -18}, false, 303);
  expect_same_mean(small_telescope({0, 0, -6}, {0, 1, 1}), {0, 20, -14}, true, 304);
}

// All rays are seen, under 15 to 24 degrees to the axis; the lens is small to 1 in 10^4. Seen red:
// without the cosine to the axis.
TEST(ConnectRay, TakesTheLensAtItsAngle) {
  Random random(306);
  const auto sea = make_sea(60);
  for (const double height : {10.0, -3.0}) {
    auto scene = small_telescope({0, 0, height}, {0, 0, -1});
    scene.detector_diameter_m = 2;
    const auto telescope = instrument::make_telescope<double>(scene);
    for (int n = 0; n < 100; ++n) {
      const auto at = photon_at(sea, {random.between(5, 7), random.between(-1, 1), -17});
      const auto whole = connect(sea, scene, at, 0, false);
      ASSERT_GT(whole.acceptance, 0);
      test::Mean mean;
      for (int i = 0; i < 200; ++i) {
        const auto lens = lens_point(telescope, random.uniform(), random.uniform());
        mean.add(connect_ray(sea, scene, at, 0, lens, false).acceptance);
      }
      ASSERT_NEAR(mean.value() / whole.acceptance, 1, 1e-3);
    }
  }
}

// Seen red: with rays beside the detector; with all rays to the lens' centre.
TEST(ConnectRay, IsNoneOffTheDetector) {
  Random random(305);
  const auto sea = make_sea(60);
  int seen = 0, unseen = 0;
  for (const bool submerged : {false, true}) {
    for (int n = 0; n < 2000; ++n) {
      const bool mirrored = submerged && n % 2 == 0;
      const auto scene = small_telescope({0, 0, submerged ? -6.0 : 10.0},
                                         {0, mirrored ? 1.0 : 0.0, mirrored ? 1.0 : -1.0});
      const auto telescope = instrument::make_telescope<double>(scene);
      const auto at = photon_at(sea, V{0, mirrored ? 20.0 : 0.0, -14} +
                                         V{random.between(-1, 1), random.between(-1, 1), 0});
      const auto lens = lens_point(telescope, random.uniform(), random.uniform());
      const V there = in_space(telescope, lens);
      const auto way =
          geometry::sightline(sea.view(), at.position, 0, there, region_at(sea, scene.position_m),
                              route_of(mirrored), true);
      const bool on_detector = sight(telescope, lens, way.arriving).on_detector;
      const auto ray = connect_ray(sea, scene, at, 0, lens, mirrored);
      ASSERT_EQ(ray.acceptance > 0, on_detector);
      (on_detector ? seen : unseen) += 1;
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(unseen, 500);
}

}  // namespace
}  // namespace photic::transport
