// [environment_grid]: environments as the product of values.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

/// The base scene with these lines behind it: the first of them is line 31.
std::string with(const std::string& lines) { return edited({}) + lines + '\n'; }

/// With a grid whose first path is in line 32.
std::string grid(const std::string& lines) { return with("[environment_grid]\n" + lines); }

Texts names_of(const Scene& scene) {
  Texts names;
  for (const Environment& environment : scene.environment) names.push_back(environment.name);
  return names;
}

const char* const six = R"("sea.layer.0.chlorophyll_mg_m3" = [0.1, 0.50, 1]
"sea.layer.0.cdom_a440_per_m" = [0.01, 0.02])";

// Seen red, each for itself: with the last path changing slowest; in front of those given.
TEST(EnvironmentGrid, IsTheProductBehindTheEnvironmentsGiven) {
  const Scene scene =
      read_text(with("[[environment]]\nset = {}\n[environment_grid]\n" + std::string(six)));
  EXPECT_EQ(names_of(scene),
            (Texts{"environment0", "chlorophyll_mg_m3 = 0.1, cdom_a440_per_m = 0.01",
                   "chlorophyll_mg_m3 = 0.1, cdom_a440_per_m = 0.02",
                   "chlorophyll_mg_m3 = 0.5, cdom_a440_per_m = 0.01",
                   "chlorophyll_mg_m3 = 0.5, cdom_a440_per_m = 0.02",
                   "chlorophyll_mg_m3 = 1, cdom_a440_per_m = 0.01",
                   "chlorophyll_mg_m3 = 1, cdom_a440_per_m = 0.02"}));
  EXPECT_EQ(scene.environment[4].set,
            (std::vector<Change>{{"sea.layer.0.chlorophyll_mg_m3", "0.5"},
                                 {"sea.layer.0.cdom_a440_per_m", "0.02"}}));
  EXPECT_EQ(scene_in(scene, scene.environment[4]),
            base_scene({"sea.layer.0.chlorophyll_mg_m3=0.5", "sea.layer.0.cdom_a440_per_m=0.02"}));
}

// Seen red: with last parts alone, which makes names twice.
TEST(EnvironmentGrid, NamesWholePathsWhereTheirEndsAreAlike) {
  const Scene scene = read_text(edited({{24, 25, "chlorophyll_mg_m3 = 1"}}) + R"([environment_grid]
"sea.layer.0.chlorophyll_mg_m3" = [0.1, 0.2]
"optics.raman" = ["marshall-smith"]
"sea.layer.1.chlorophyll_mg_m3" = [0.2]
)");
  EXPECT_EQ(
      names_of(scene),
      (Texts{
          R"(sea.layer.0.chlorophyll_mg_m3 = 0.1, raman = marshall-smith, sea.layer.1.chlorophyll_mg_m3 = 0.2)",
          R"(sea.layer.0.chlorophyll_mg_m3 = 0.2, raman = marshall-smith, sea.layer.1.chlorophyll_mg_m3 = 0.2)"}));
}

TEST(EnvironmentGrid, IsWrittenAsEnvironmentsAndReadsBack) {
  const Scene scene = read_text(grid(six));
  const std::string text = write_scene(scene);
  EXPECT_EQ(text.find("environment_grid"), std::string::npos);
  EXPECT_NE(text.find(R"(
[[environment]]
name = "chlorophyll_mg_m3 = 1, cdom_a440_per_m = 0.02"
set = { "sea.layer.0.chlorophyll_mg_m3" = 1, "sea.layer.0.cdom_a440_per_m" = 0.02 }
)"),
            std::string::npos)
      << text;
  EXPECT_TRUE(read_scene_text(text, "written.toml", "/elsewhere").scene == scene);
}

// Seen red: with every dot of a path followed.
TEST(EnvironmentGrid, MayComeFromSet) {
  const Scene scene =
      read_text(edited({}), {"environment_grid.sea.layer.0.chlorophyll_mg_m3=[0.3, 0.4]"});
  EXPECT_EQ(names_of(scene), (Texts{"chlorophyll_mg_m3 = 0.3", "chlorophyll_mg_m3 = 0.4"}));
  EXPECT_EQ(diagnostics_of(grid(six), {"environment_grid.sea.layer.0.chlorophyll_mg_m3=[0.3,-4]"}),
            (Texts{"--set environment_grid.sea.layer.0.chlorophyll_mg_m3: 'chlorophyll_mg_m3' must "
                   "be a finite number, at least 0, not -4"}));
}

// Seen red, each for itself: values reported at their key; the same problem reported for each
// environment that has it; values not compared; the number of environments not looked at.
TEST(EnvironmentGrid, EveryTextOfWhatIsWrong) {
  const std::vector<std::pair<std::string, Texts>> cases{
      {grid(R"("sea.layer.0.chlorophyll_mg_m3" = [0.1, -1]
"sea.layer.0.cdom_a440_per_m" = [0.1, 0.2, "x"])"),
       {"scene.toml:32:41: 'chlorophyll_mg_m3' must be a finite number, at least 0, not -1",
        R"(scene.toml:33:44: 'cdom_a440_per_m' must be a finite number, at least 0, not text "x")"}},
      {grid(R"("sea.layer.0.bottom_depth_m" = [20, 21])"),
       {"scene.toml:32:37: 'bottom_depth_m' must be as in the scene, 20, not 21: light crosses "
        "from layer to layer in the same way in all environments (simulate that in a scene of its "
        "own)"}},
      {grid(R"("sea.layer.1.iop.0.a_per_m" = [0, 1]
"sea.layer.1.iop.0.b_per_m" = [0, 1]
"optics.raman" = ["bartlett", "marshall-smith"])"),
       {R"(scene.toml:32:32: in environment "a_per_m = 0, b_per_m = 0, raman = bartlett": a_per_m + b_per_m is 0: there is no water without attenuation)"}},
      {grid(R"("gates.depth_max_m" = [50]
"sea" = [{}]
"sea.layer.0.chlorophyll_mg_m3" = 0.5
"sea.layer.0.cdom_a440_per_m" = []
"sea.layer.1.iop.0.a_per_m" = [inf]
"sea.layer.1.iop.0.b_per_m" = [0.1, 0.2, 0.10])"),
       {"scene.toml:32:1: 'gates.depth_max_m' cannot be set in an environment: only the water, the "
        "bed, "
        "a film of oil and the air may differ, since the histories are the same (set paths that "
        "begin with "
        "sea., optics., bottom., oil. or atmosphere.)",
        R"(scene.toml:33:1: 'sea' cannot be set as a whole in an environment (quote the whole path: "sea.layer.0.chlorophyll_mg_m3" = 0.5))",
        "scene.toml:34:35: 'sea.layer.0.chlorophyll_mg_m3' must be an array of one or more values, "
        "not 0.5 (write the values in brackets: [0.1, 0.5])",
        "scene.toml:35:33: 'sea.layer.0.cdom_a440_per_m' must be an array of one or more values, "
        "not [] (write the values in brackets: [0.1, 0.5])",
        "scene.toml:36:32: 'sea.layer.1.iop.0.a_per_m' must be made of finite numbers, texts, true "
        "and false, not inf",
        "scene.toml:37:42: 'sea.layer.1.iop.0.b_per_m' has 0.1 twice (each value once)"}},
      {grid("sea.layer.0.chlorophyll_mg_m3 = [0.1]"),
       {R"(scene.toml:32:1: 'sea' cannot be set as a whole in an environment (quote the whole path: "sea.layer.0.chlorophyll_mg_m3" = 0.5))"}},
      {grid(""),
       {R"(scene.toml:31:1: 'environment_grid' must be a table of one or more paths with their values, not an empty one (write "sea.layer.0.chlorophyll_mg_m3" = [0.1, 0.5] below [environment_grid]))"}},
      {"environment_grid = 5\n" + edited({}),
       {R"(scene.toml:1:20: 'environment_grid' must be a table of one or more paths with their values, not 5 (write "sea.layer.0.chlorophyll_mg_m3" = [0.1, 0.5] below [environment_grid]))"}},
      {with(
           "[[environment]]\nname = \"chlorophyll_mg_m3 = 0.1, cdom_a440_per_m = 0.02\"\nset = {}\n"
           "[environment_grid]\n" +
           std::string(six)),
       {R"(scene.toml:34:1: two of [[environment]] are called "chlorophyll_mg_m3 = 0.1, cdom_a440_per_m = 0.02" (give each its own name))"}},
      {"environment = 5\n" + grid(six),
       {"scene.toml:1:15: 'environment' must be one or more tables, not 5 (write "
        "[[environment]])"}},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(diagnostics_of(text), expected) << text;
}

/// So many numbers, the first of them 1.
std::string numbers(int count) {
  std::string out;
  for (int i = 1; i <= count; ++i) out += std::to_string(i) + ", ";
  return "[" + out + "]";
}

TEST(EnvironmentGrid, IsRefusedIfItIsTooLarge) {
  EXPECT_EQ(diagnostics_of(grid("\"sea.layer.0.chlorophyll_mg_m3\" = " + numbers(101) +
                                "\n\"sea.layer.0.cdom_a440_per_m\" = " + numbers(100))),
            (Texts{"scene.toml:31:1: these are 10100 environments (at most 10000 are possible: "
                   "give fewer values)"}));
  EXPECT_EQ(diagnostics_of(edited({{28, 28, "depth_step_m = 0.012"}}) +
                           "[[environment]]\nset = {}\n[environment_grid]\n"
                           "\"sea.layer.0.chlorophyll_mg_m3\" = " +
                           numbers(2400)),
            (Texts{"scene.toml:33:1: the tallies (telescopes 1, channels 1, gates 4167, orders 6, "
                   "cells of depth 100, environments 2401) would take 4.53 GiB; the limit is 2 GiB "
                   "(take fewer environments, or fewer gates)"}));
}

}  // namespace
}  // namespace photic::scene
