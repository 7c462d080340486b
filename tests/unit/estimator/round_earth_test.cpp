// Where it shows that the sea is simulated as a plane. The numbers are those of the triangle of
// earth's centre, instrument and sea, made apart by the law of sines and a difference of heights.
#include "estimator/round_earth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "estimator/model.hpp"
#include "support/tables.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::estimator {
namespace {

using Texts = std::vector<std::string>;

/// What is said of the base scene with its telescope at a height, tilted so far.
Texts remarks_on(double height_m, double tilt_deg) {
  const double tilt = tilt_deg * radian_per_degree;
  const std::string text =
      scene::edited({{10, 11,
                      fmt::format("position_m = [0, 0, {}]\ndirection = [{}, 0, {}]", height_m,
                                  std::sin(tilt), -std::cos(tilt))},
                     {14, 14, "detector_diameter_m = 0.8"},
                     {19, 19, "[sea]\nrefractive_index = 1.34"}});
  return scene::read_scene_text(text, "scene.toml", "/", {}, optics_check(test::tables())).remarks;
}

std::string flat_and_round(const std::string& flat, const std::string& round) {
  return "scene.toml:11:13: the simulated sea is flat: along this axis the surface is " + flat +
         " to the vertical; on a round earth these are " + round;
}

// At 20 degrees from 705 km both differ by less than 1 %, at 30 by 1.9; from 12 m at 89.5 degrees
// the range alone does, from 20 000 km at 3 degrees the cosine alone. Seen red: with the range
// alone; with the cosine alone; with the tilt for the angle at the sea.
TEST(RoundEarth, IsRemarkedOnWhereItShows) {
  EXPECT_EQ(remarks_on(705e3, 20), Texts{});
  EXPECT_EQ(
      remarks_on(705e3, 30),
      Texts{flat_and_round("814.1 km away and light goes on in the water with the cosine 0.9278",
                           "829.7 km and 0.9101")});
  EXPECT_EQ(remarks_on(12, 89), Texts{});
  EXPECT_EQ(
      remarks_on(12, 89.5),
      Texts{flat_and_round("1375 m away and light goes on in the water with the cosine 0.6657",
                           "1393 m and 0.6657")});
  EXPECT_EQ(remarks_on(20e6, 3).size(), 1U);
  EXPECT_EQ(remarks_on(300, 15), Texts{});
}

// sin(i) = (1 + H / R) sin(tilt) would be 1.007 and 1.0000015. Seen red: without the horizon.
TEST(RoundEarth, HasAHorizon) {
  const std::string beyond =
      "scene.toml:11:13: on a round earth this axis passes above the horizon; on the flat sea of "
      "the simulation it meets the surface after ";
  EXPECT_EQ(remarks_on(705e3, 65), Texts{beyond + "1668 km"});
  EXPECT_EQ(remarks_on(12, 89.95), Texts{beyond + "13.75 km"});
}

// Seen red: with the telescopes alone.
TEST(RoundEarth, IsThatOfTheLaserToo) {
  const std::string text =
      scene::edited({{4, 5, "position_m = [0, 0, 705e3]\ndirection = [1, 0, -1.7320508075688772]"},
                     {14, 14, "detector_diameter_m = 0.8"},
                     {27, 28, "range_min_m = 1\nrange_max_m = 50\nrange_step_m = 1"}});
  const auto remarks =
      scene::read_scene_text(text, "scene.toml", "/", {}, optics_check(test::tables())).remarks;
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_TRUE(remarks[0].starts_with("scene.toml:5:13: the simulated sea is flat: ")) << remarks[0];
}

}  // namespace
}  // namespace photic::estimator
