// What the forward estimator gets where a scene leaves it open.
#include "scene/forward_settings.hpp"

#include <gtest/gtest.h>

namespace photic::scene {
namespace {

Scene at_height(double z_m) {
  Scene scene;
  scene.telescope.emplace_back();
  scene.telescope.back().position_m = {0, 0, z_m};
  return scene;
}

// docs/decisions/0038 has the measurement. Seen red: with one value for all heights; with the
// highest telescope.
TEST(ForwardSettings, GoByTheHeightOfTheLowestTelescope) {
  Scene scene = at_height(12);
  EXPECT_EQ(directed_fraction_in(scene), 0.5);
  EXPECT_EQ(scored_points_in(scene), 4);
  scene = at_height(705e3);
  EXPECT_EQ(directed_fraction_in(scene), 0.25);
  EXPECT_EQ(scored_points_in(scene), 1);
  scene.telescope.push_back(at_height(-5).telescope.front());
  EXPECT_EQ(directed_fraction_in(scene), 0.5);
}

// Seen red: with the usual value in place of one that is named.
TEST(ForwardSettings, AreThoseThatTheSceneNames) {
  Scene scene = at_height(705e3);
  EXPECT_EQ(forward_settings(scene), (std::vector<ForwardSettings>{{0.5, 4}, {0.25, 1}}));
  scene.simulation.directed_fraction = 0;
  EXPECT_EQ(directed_fraction_in(scene), 0);
  EXPECT_EQ(scored_points_in(scene), 1);
  EXPECT_EQ(forward_settings(scene), (std::vector<ForwardSettings>{{0, 4}, {0, 1}}));
  scene.simulation.scored_points = 2;
  EXPECT_EQ(forward_settings(scene), (std::vector<ForwardSettings>{{0, 2}}));
}

// Seen red: as above the sea.
TEST(ForwardSettings, InTheWaterAreThoseThatDirectMore) {
  Scene scene = at_height(705e3);
  scene.telescope.push_back(at_height(-5).telescope.front());
  EXPECT_EQ(forward_settings(scene), (std::vector<ForwardSettings>{{0.5, 4}}));
}

}  // namespace
}  // namespace photic::scene
