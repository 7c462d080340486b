// The numbers that environments set.
#include "scene/environment_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/scene/environment_scenes.hpp"

namespace photic::scene {
namespace {

const std::string chlorophyll = "sea.layer.0.chlorophyll_mg_m3";
const std::string cdom = "sea.layer.0.cdom_a440_per_m";

EnvironmentValues values_of(const std::string& environments) {
  return environment_values(read_text(with_environments(environments)));
}

TEST(EnvironmentValues, NoneWithoutEnvironments) {
  EXPECT_TRUE(environment_values(base_scene()).path.empty());
  EXPECT_TRUE(values_of("[[environment]]\nset = {}").path.empty());
}

TEST(EnvironmentValues, OfAGrid) {
  const auto found = values_of("[environment_grid]\n\"" + chlorophyll + "\" = [0.5, 1]\n\"" + cdom +
                               "\" = [0.01, 0.02]");
  EXPECT_EQ(found.path, (Texts{chlorophyll, cdom}));
  EXPECT_EQ(found.value, (std::vector<double>{0.5, 0.01, 0.5, 0.02, 1, 0.01, 1, 0.02}));
}

// Seen red: with NaN where an environment sets nothing.
TEST(EnvironmentValues, AreThoseOfTheSceneWhereNothingIsSet) {
  const auto found =
      values_of("[[environment]]\nset = {}\n[[environment]]\nset = { \"" + chlorophyll +
                "\" = 0.5 }\n[[environment]]\nset = { \"" + cdom + "\" = 0.02 }");
  EXPECT_EQ(found.path, (Texts{chlorophyll, cdom}));
  EXPECT_EQ(found.value, (std::vector<double>{0.1, 0, 0.5, 0, 0.1, 0.02}));
}

// Seen red: with a column for a path that no environment sets to a number; with the scene's value
// where an environment sets a text.
TEST(EnvironmentValues, AreNoNumbersWhereATextIsSet) {
  const std::string raman = "optics.raman";
  const auto words = values_of("[[environment]]\nset = { \"" + raman + "\" = \"marshall-smith\" }");
  EXPECT_EQ(words.path, Texts{});
  const std::string g = "sea.layer.1.phase_function.g", shape = "sea.layer.1.phase_function";
  const auto found = values_of(
      "[[environment]]\nset = { \"" + g + "\" = 0.8 }\n[[environment]]\nset = { \"" + shape +
      "\" = \"isotropic\" }\n[[environment]]\nset = { \"" + raman + "\" = \"marshall-smith\" }");
  EXPECT_EQ(found.path, Texts{g});
  ASSERT_EQ(found.value.size(), 3u);
  EXPECT_EQ(found.value[0], 0.8);
  EXPECT_TRUE(std::isnan(found.value[1]));
  EXPECT_EQ(found.value[2], 0.9);
}

// Seen red: with paths as they stand in the file, which makes two of one.
TEST(EnvironmentValues, GoByTheNumbersOfLayers) {
  const std::string named = R"([[environment]]
set = { "sea.layer.top.chlorophyll_mg_m3" = 0.5 }
[[environment]]
set = { "sea.layer.0.chlorophyll_mg_m3" = 2 })";
  const auto found =
      environment_values(read_text(with_environments(named), {"sea.layer.0.name=top"}));
  EXPECT_EQ(found.path, Texts{chlorophyll});
  EXPECT_EQ(found.value, (std::vector<double>{0.5, 2}));
}

// Seen red: with what an environment sets itself looked at, and not its scene.
TEST(EnvironmentValues, FollowATableThatIsSet) {
  const auto found = values_of("[[environment]]\nset = { \"" + chlorophyll +
                               "\" = 0.5 }\n[[environment]]\nset = { \"sea.layer.0\" = "
                               "{ bottom_depth_m = 20, chlorophyll_mg_m3 = 3 } }");
  EXPECT_EQ(found.path, Texts{chlorophyll});
  EXPECT_EQ(found.value, (std::vector<double>{0.5, 3}));
}

TEST(EnvironmentValues, AreTheSameOfTheSceneThatIsWritten) {
  const Scene scene = read_text(with_environments(
      "[[environment]]\nset = { \"optics.set\" = \"paper\", \"" + chlorophyll + "\" = 0.5 }"));
  const auto found = environment_values(scene);
  const auto again =
      environment_values(read_scene_text(write_scene(scene), "written.toml", "/elsewhere").scene);
  EXPECT_EQ(found.path, again.path);
  EXPECT_EQ(found.value, again.value);
  EXPECT_NE(std::find(found.path.begin(), found.path.end(), chlorophyll), found.path.end());
}

}  // namespace
}  // namespace photic::scene
