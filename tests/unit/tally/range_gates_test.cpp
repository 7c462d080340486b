// Gates by range along the axis of a tilted or submerged instrument.
#include <gtest/gtest.h>

#include "core/constants.hpp"
#include "tally/gates.hpp"
#include "unit/tally/lines.hpp"

namespace photic::tally {
namespace {

constexpr double group = 1.3638;

scene::Scene with_range_gates(const Vec3<double>& position, const Vec3<double>& direction) {
  scene::Scene scene = test::ship_scene();
  scene.gates = {};
  scene.gates.range_m = {0, 100, 1};
  scene.source.position_m = scene.telescope[0].position_m = position;
  scene.source.direction = scene.telescope[0].direction = direction;
  return scene;
}

// Seen red: with the group index from the lens on; with the height for the slant way to the
// surface.
TEST(RangeGates, OfATiltedLidarFollowItsRefractedAxis) {
  const double tilt = 30 * radian_per_degree;
  const Gates gates(with_range_gates({0, 0, 12}, {std::sin(tilt), 0, -std::cos(tilt)}), lines());
  const double in_air = 12 / std::cos(tilt);
  EXPECT_TRUE(gates.depth_is_range());
  for (std::int32_t range = 0; range <= 100; ++range) {
    const double path = range < in_air ? 2.0 * range : 2 * in_air + 2 * group * (range - in_air);
    EXPECT_NEAR(gates.edge_path(range), path, 1e-10) << range;
    EXPECT_NEAR(gates.depth(path, 0, lines()[0]), range, 1e-10) << range;
  }
  // Light of another group index from beyond the surface.
  EXPECT_NEAR(gates.depth(gates.edge_path(50), 0, lines()[1]),
              in_air + (50 - in_air) * 2 * group / (group + 1.3541), 1e-10);
}

// The grid of the last scattering's depth: vertical, through Snell's law. Seen red: with the range
// for the depth; with the angle in air below the surface.
TEST(RangeGates, OfATiltedLidarCoverTheDepthsItLooksAt) {
  const double tilt = 30 * radian_per_degree;
  const Gates gates(with_range_gates({0, 0, 12}, {std::sin(tilt), 0, -std::cos(tilt)}), lines());
  const auto edges = gates.depth_edges(100);
  ASSERT_EQ(edges.size(), 101U);
  EXPECT_EQ(edges.front(), 0);
  const double water = std::asin(std::sin(tilt) / 1.3415);
  EXPECT_NEAR(edges.back(), (100 - 12 / std::cos(tilt)) * std::cos(water), 1e-9);
}

TEST(RangeGates, OfASubmergedLidarLookingDownAreInWaterFromTheLensOn) {
  const Gates gates(with_range_gates({0, 0, -5}, {0, 0, -1}), lines());
  for (const std::int32_t range : {0, 1, 50, 100})
    EXPECT_NEAR(gates.edge_path(range), 2 * group * range, 1e-10);
  EXPECT_NEAR(gates.depth_edges(100).front(), 5, 1e-12);
  EXPECT_NEAR(gates.depth_edges(100).back(), 105, 1e-12);
}

// Beyond the surface a range lies in the air.
TEST(RangeGates, OfASubmergedLidarLookingUpEndInTheAir) {
  const Gates gates(with_range_gates({0, 0, -5}, {0, 0, 1}), lines());
  EXPECT_NEAR(gates.edge_path(5), 10 * group, 1e-10);
  EXPECT_NEAR(gates.edge_path(6), 10 * group + 2, 1e-10);
  const auto edges = gates.depth_edges(100);
  EXPECT_EQ(edges.front(), 0);
  EXPECT_GE(edges.back(), 5);
}

TEST(RangeGates, OfASubmergedLidarLookingSidewaysNeverReachTheSurface) {
  const Gates gates(with_range_gates({0, 0, -50}, {1, 0, 0}), lines());
  EXPECT_NEAR(gates.edge_path(100), 200 * group, 1e-10);
  const auto edges = gates.depth_edges(100);
  EXPECT_LT(edges.front(), 50);
  EXPECT_GT(edges.back(), 50);
}

// Light from the bed at 10 m, in the range at which the axis meets it. Seen red: with all of the
// distance between them by the source's medium.
TEST(RangeGates, KnowASourceBeyondTheSurface) {
  auto from_below = with_range_gates({0, 0, 12}, {0, 0, -1});
  from_below.source.position_m.z = -5;
  const Gates above(from_below, lines());
  EXPECT_NEAR(above.depth(5 * group + 10 * group + 12, 0, lines()[0]), 22, 1e-10);
  EXPECT_NEAR(above.depth(0.5 * group + 5.5 * group + 12, 0, lines()[0]), 17.5, 1e-10);
  auto from_above = with_range_gates({0, 0, -5}, {0, 0, -1});
  from_above.source.position_m.z = 12;
  const Gates below(from_above, lines());
  EXPECT_NEAR(below.depth(12 + 10 * group + 5 * group, 0, lines()[0]), 5, 1e-10);
}

// Each telescope has ranges along its own axis. Seen red: with those of the first.
TEST(RangeGates, OfAnotherTelescopeAreAlongItsOwnAxis) {
  auto scene = with_range_gates({0, 0, 12}, {0, 0, -1});
  scene.telescope.push_back(scene.telescope[0]);
  scene.telescope[1].direction = {0, std::sin(0.6), -std::cos(0.6)};
  const Gates gates(scene, lines());
  EXPECT_NEAR(gates.depth(24 + 2 * group * 5, 0, lines()[0]), 17, 1e-10);
  const double in_air = 12 / std::cos(0.6);
  EXPECT_NEAR(gates.depth(2 * in_air + 2 * group * 5, 1, lines()[0]), in_air + 5, 1e-10);
}

// A source ahead of the telescope has a shorter way, in its own medium. Seen red: with the sign of
// the offset turned; without the group index in the water.
TEST(RangeGates, KnowASourceAheadOfTheTelescope) {
  auto scene = with_range_gates({0, 0, 12}, {0, 0, -1});
  const double together = Gates(scene, lines()).edge_path(60);
  scene.source.position_m.z = 11;
  EXPECT_NEAR(Gates(scene, lines()).edge_path(60), together - 1, 1e-10);
  scene.source.position_m = {0.5, 0, 12};  // beside it: the same
  EXPECT_NEAR(Gates(scene, lines()).edge_path(60), together, 1e-10);

  auto submerged = with_range_gates({0, 0, -5}, {1, 0, -1});
  const double at_lens = Gates(submerged, lines()).edge_path(10);
  submerged.source.position_m = {0.2, 0, -5.2};
  EXPECT_NEAR(Gates(submerged, lines()).edge_path(10), at_lens - group * 0.2 * std::sqrt(2.0),
              1e-10);
}

}  // namespace
}  // namespace photic::tally
