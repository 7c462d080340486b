#include "estimator/strategies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "estimator/model.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

std::string ship(const std::string& direction, const std::string& half_divergence_mrad = "5.0") {
  return "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 12.0]\ndirection = " +
         direction + "\ndiameter_m = 0.04\nhalf_divergence_mrad = " + half_divergence_mrad +
         "\n[[telescope]]\nposition_m = [0.0, 0.0, 12.0]\ndirection = " + direction +
         "\ndiameter_m = 0.40\nfocal_length_m = 2.0\ndetector_diameter_m = 0.04\n";
}
const std::string water = "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n";
const std::string elastic = test::channel("elastic"), raman = test::channel("raman");
const std::string down = "[0.0, 0.0, -1.0]", tilted = "[0.3, 0.0, -1.0]";

Model model_of(const std::string& scene) {
  return make_model(
      test::read(scene + test::depth_gates(12, 1) + test::simulation(1000, 1, "", "bidirectional")),
      *test::tables());
}
Strategies strategies_of(const std::string& scene) {
  const Model model = model_of(scene);
  return make_strategies(model.scene, model.medium);
}
bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(Strategies, AreAllUsedUnderAVerticalBeam) {
  const Strategies s = strategies_of(ship(down) + elastic + raman + water);
  for (const Strategy* one : {&s.to_laser, &s.between, &s.translated, &s.rotated,
                              &s.rotated_scattered, &s.free_telescope, &s.free_laser})
    EXPECT_TRUE(one->used) << one->name << ": " << one->reason;
}

// Seen red: with light that is not converted taken for such; with the beam taken for vertical.
TEST(Strategies, RotateAboutNoSlantedBeamThatConversionsLookFor) {
  EXPECT_TRUE(strategies_of(ship(tilted) + elastic + water).rotated.used);
  const Strategies s = strategies_of(ship(tilted) + elastic + raman + water);
  EXPECT_FALSE(s.rotated.used);
  EXPECT_FALSE(s.rotated_scattered.used);
  EXPECT_TRUE(has(s.rotated.reason, "a beam that is not vertical"));
  EXPECT_TRUE(s.translated.used);
}

// Seen red: with waves of one variance taken for others.
TEST(Strategies, RotateOverWavesWhatTheseHaveNotMet) {
  const auto over = [](const std::string& waves) {
    return strategies_of(ship(down) + elastic + "[sea]\nsurface = " + waves + "\n" + water).rotated;
  };
  const auto cox_munk = over("{ model = \"cox-munk\", wind_speed_m_s = 7.0 }");
  EXPECT_TRUE(cox_munk.used);
  EXPECT_TRUE(has(cox_munk.reason, "have not met what is rotated"));
  const auto isotropic = over(
      "{ model = \"gaussian\", upwind_slope_variance = 0.02, crosswind_slope_variance = 0.02 }");
  EXPECT_TRUE(isotropic.used);
  EXPECT_EQ(isotropic.reason, "");
}

// Seen red: with rotations left in.
TEST(Strategies, DoNotRotateScatteredLightInOtherWaters) {
  const Strategies s =
      strategies_of(ship(down) + elastic + water +
                    "[[environment]]\nset = { \"sea.layer.0.chlorophyll_mg_m3\" = 0.6 }\n");
  EXPECT_TRUE(s.rotated.used);
  EXPECT_FALSE(s.rotated_scattered.used);
  EXPECT_TRUE(has(s.rotated_scattered.reason, "environments"));
}

// Seen red: with parallel rays taken for others.
TEST(Strategies, LeadNothingIntoParallelRays) {
  const Strategy parallel = strategies_of(ship(down, "0.0") + elastic + water).to_laser;
  EXPECT_FALSE(parallel.used);
  EXPECT_TRUE(has(parallel.reason, "parallel"));
  EXPECT_TRUE(
      has(strategies_of(ship(down, "0.0") + elastic + water).free_laser.reason, "parallel"));
}

// Seen red: with the cosine of another angle; with the names of all telescopes; of none.
TEST(Strategies, TranslateOnlySteepRays) {
  const std::string other =
      "[[telescope]]\nname = \"aside\"\nposition_m = [5.0, 0.0, 2.0]\ndirection = [-1.0, 0.0, "
      "-0.1]\n"
      "diameter_m = 0.1\nfocal_length_m = 0.5\ndetector_diameter_m = 0.02\n";
  const Strategy one = strategies_of(ship(down) + other + elastic + water).translated;
  EXPECT_TRUE(one.used);
  EXPECT_EQ(one.reason, "from aside only rays steeper than 12 degrees");
}

// Seen red: without a limit.
TEST(Strategies, FreeNoWalksWhereMeansWithoutEndWouldBeNeeded) {
  std::string many = ship(down);
  for (int i = 0; i < 600; ++i)
    many += "[[telescope]]\nname = \"t" + std::to_string(i) + "\"\nposition_m = [" +
            std::to_string(i) +
            ".0, 0.0, 2.0]\ndirection = [0.0, 0.0, -1.0]\ndiameter_m = 0.1\n"
            "focal_length_m = 0.5\ndetector_diameter_m = 0.02\n";
  const Strategies s = strategies_of(many + elastic + water);
  EXPECT_FALSE(s.free_telescope.used || s.free_laser.used);
  EXPECT_TRUE(has(s.free_laser.reason, "means of phase functions"));
}

// Seen red: with the reasons left out.
TEST(Strategies, AreListedLineByLine) {
  const Model model = model_of(ship(tilted) + elastic + raman + water);
  const auto listed = reported_strategies(model.scene, model.medium);
  ASSERT_EQ(listed.size(), 7U);
  EXPECT_EQ(listed[1], "walks from both sides connected: yes: a share of 0.3");
  EXPECT_EQ(listed[3],
            "walks from telescopes rotated about a vertical so that rays meet: no: light is "
            "converted, and looked for about a beam that is not vertical");
  EXPECT_EQ(listed[5], "free walks of telescopes: yes: as pilot runs found");
  EXPECT_EQ(describe(model).strategies, listed);
  scene::Scene chosen = model.scene;
  chosen.simulation.free_telescope_meetings = 0.25;
  chosen.simulation.free_laser_meetings = 0;
  const auto then = reported_strategies(chosen, model.medium);
  EXPECT_EQ(then[5], "free walks of telescopes: yes: two rays meet 0.25 times per metre of depth");
  EXPECT_EQ(then[6],
            "free walks of the laser: no: they cost more than they give, or are not requested");
  scene::Scene forward = model.scene;
  forward.simulation.estimator = scene::Estimator::forward;
  EXPECT_TRUE(reported_strategies(forward, model.medium).empty());
}

}  // namespace
}  // namespace photic::estimator
