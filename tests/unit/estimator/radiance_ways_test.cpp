// The ways of scattered light to the levels and directions of a radiance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "estimator/make_world.hpp"
#include "estimator/tallies/radiance_ways.hpp"
#include "support/absorbers.hpp"
#include "support/lit_scenes.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

constexpr double n = 1.34;

/// Of one direction, from the water or from the air.
std::vector<RadianceWay> ways_to(double zenith_deg, const std::string& levels, bool of_air = false,
                                 const std::string& air = "") {
  const Model water = make_model(
      test::read(test::sun_at(30) +
                 fmt::format("[[tally]]\nkind = \"radiance\"\n{}\ndirection_deg = [[{}, 40]]\n",
                             levels, zenith_deg) +
                 air + fmt::format("[sea]\nrefractive_index = {}\n", n) +
                 test::layer_to(10, 0.1, 0.2) + test::simulation(1e3, 1)),
      *test::tables());
  const Model model = of_air ? model_of_air(water) : water;
  return radiance_ways(model.scene.tally.front(), model, model.paths.slabs(model.medium), 0);
}
double cos_deg(double angle) { return std::cos(angle * radian_per_degree); }
double sin_deg(double angle) { return std::sin(angle * radian_per_degree); }

void expect_direction(const Vec3<double>& direction, double zenith_deg, double sign = 1) {
  EXPECT_NEAR(direction.x, sin_deg(zenith_deg) * cos_deg(40), 1e-9);
  EXPECT_NEAR(direction.y, sin_deg(zenith_deg) * sin_deg(40), 1e-9);
  EXPECT_NEAR(direction.z, sign * cos_deg(zenith_deg), 1e-9);
}

// Light that goes up in the water comes to its levels straight.
TEST(RadianceWays, LeadUpStraight) {
  const auto ways = ways_to(30, "depth_m = [1, 3]");
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_FALSE(ways[0].by_surface);
  expect_direction(ways[0].direction, 30);
  ASSERT_EQ(ways[0].levels.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(ways[0].levels[i].cell, i);
    EXPECT_EQ(ways[0].levels[i].gain, 1);
  }
  EXPECT_EQ(ways[0].levels[1].distance, 3);
}

// Light that goes down also comes by the surface's mirror, with what that sends back: all of it
// beyond the critical angle. Seen red: without the mirror.
TEST(RadianceWays, LeadDownStraightAndByTheMirror) {
  const double above_deg = std::asin(n * sin_deg(30)) / radian_per_degree;
  const double partly = test::refracted(cos_deg(above_deg), n).first;
  for (const auto& [zenith_deg, reflectance] : {std::pair{150.0, partly}, {110.0, 1.0}}) {
    const auto ways = ways_to(zenith_deg, "depth_m = [2]");
    ASSERT_EQ(ways.size(), 2U);
    expect_direction(ways[0].direction, zenith_deg);
    EXPECT_TRUE(ways[1].by_surface);
    expect_direction(ways[1].direction, zenith_deg, -1);
    ASSERT_EQ(ways[1].levels.size(), 1U);
    EXPECT_EQ(ways[1].levels[0].distance, 2);
    EXPECT_NEAR(ways[1].levels[0].gain, reflectance, 1e-9);
  }
}

// To the air: from the direction before refraction, T / n^2 of it; none of the light in the water
// goes down in the air. Seen red: without 1 / n^2.
TEST(RadianceWays, LeadThroughTheSurface) {
  const auto [reflectance, below] = test::refracted(cos_deg(50), n);
  const auto ways = ways_to(50, "height_m = [0, 2]");
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_TRUE(ways[0].by_surface);
  expect_direction(ways[0].direction, std::acos(below) / radian_per_degree);
  ASSERT_EQ(ways[0].levels.size(), 2U);
  for (const auto& level : ways[0].levels)
    EXPECT_NEAR(level.gain, (1 - reflectance) / (n * n), 1e-9);
  EXPECT_TRUE(ways_to(130, "height_m = [0]").empty());
}

const std::string one_air = "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 4.0\n" +
                            test::scattering(0.05, 0.1, 0.5);

// Through air that attenuates. Seen red: without the air's optical depth.
TEST(RadianceWays, LeadThroughTheAir) {
  const auto ways = ways_to(50, "height_m = [0, 2]", false, one_air);
  ASSERT_EQ(ways.size(), 1U);
  const auto& levels = ways[0].levels;
  ASSERT_EQ(levels.size(), 2U);
  // Levels are from the highest down.
  EXPECT_NEAR(levels[0].gain / levels[1].gain, std::exp(-2 * 0.15 / cos_deg(50)), 1e-6);
}

// From the air, which is upside down as a medium: to the water only downwards, times n^2, and up in
// the air by the mirror.
TEST(RadianceWays, LeadFromTheAir) {
  const auto through = ways_to(150, "depth_m = [0]", true, one_air);
  ASSERT_EQ(through.size(), 1U);
  const double above_deg = std::asin(n * sin_deg(30)) / radian_per_degree;
  expect_direction(through[0].direction, 180 - above_deg, -1);
  const double reflectance = test::refracted(cos_deg(above_deg), n).first;
  EXPECT_NEAR(through[0].levels.at(0).gain, (1 - reflectance) * n * n, 1e-6);
  EXPECT_TRUE(ways_to(110, "depth_m = [0]", true, one_air).empty());  // beyond the critical angle

  const auto up = ways_to(50, "height_m = [1]", true, one_air);
  ASSERT_EQ(up.size(), 2U);
  expect_direction(up[0].direction, 50, -1);
  EXPECT_TRUE(up[1].by_surface);
  EXPECT_NEAR(up[1].levels.at(0).gain, test::refracted(cos_deg(50), n).first, 1e-9);
}

}  // namespace
}  // namespace photic::estimator
