// Environments: other water of a scene, and what may not differ in it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "unit/scene/environment_scenes.hpp"

namespace photic::scene {
namespace {

// --- What becomes of a good one ------------------------------------------------------------------

// Seen red: with the scene's optics for those of the environment.
TEST(Environment, IsTheSceneWithItsChanges) {
  const Scene scene = read_text(with_environments(R"([[environment]]
name = "more algae"
set = { "sea.layer.0.chlorophyll_mg_m3" = 0.5, "sea.layer.0.cdom_a440_per_m" = 0.02 }
[[environment]]
[environment.set]
"sea.layer.1.iop.0.a_per_m" = 0.07
"sea.layer.1.phase_function.g" = 0.8
"optics.set" = "paper")"));
  ASSERT_EQ(scene.environment.size(), 2U);
  const auto& [algae, clearer] = std::tie(scene.environment[0], scene.environment[1]);
  EXPECT_EQ(algae.name, "more algae");
  EXPECT_EQ(algae.set, (std::vector<Change>{{"sea.layer.0.chlorophyll_mg_m3", "0.5"},
                                            {"sea.layer.0.cdom_a440_per_m", "0.02"}}));
  EXPECT_EQ(algae.optics, scene.optics);
  Sea sea = base_scene().sea;
  EXPECT_EQ(scene.sea, sea);
  sea.layer[0].chlorophyll_mg_m3 = 0.5;
  sea.layer[0].cdom_a440_per_m = 0.02;
  EXPECT_EQ(algae.sea, sea);

  EXPECT_EQ(clearer.name, "environment1");
  EXPECT_EQ(clearer.sea.layer[0], scene.sea.layer[0]);
  EXPECT_EQ(clearer.sea.layer[1].iop[0].a_per_m, 0.07);
  EXPECT_EQ(clearer.sea.layer[1].iop[0].b_per_m, 0.1);
  EXPECT_EQ(clearer.sea.layer[1].phase_function->g, 0.8);
  EXPECT_EQ(clearer.optics.raman, "marshall-smith");
  EXPECT_EQ(scene.optics.raman, "bartlett");
}

TEST(Environment, SceneInIt) {
  const Scene scene = read_text(setting(R"("sea.layer.0.chlorophyll_mg_m3" = 0.5)"));
  EXPECT_EQ(scene_in(scene, scene.environment[0]),
            base_scene({"sea.layer.0.chlorophyll_mg_m3=0.5"}));
}

TEST(Environment, MayBeTheSceneItself) {
  const Scene scene = read_text(setting(""));
  EXPECT_TRUE(scene.environment[0].set.empty());
  EXPECT_EQ(scene_in(scene, scene.environment[0]), base_scene());
}

// Seen red: with the fixed values refused wherever they are given.
TEST(Environment, MaySetWhatTheSceneHas) {
  const Scene scene = read_text(setting(
      R"("sea.salinity_psu" = 35, "sea.layer.0.bottom_depth_m" = 20.0, "sea.layer.1.name" = "layer1", "sea.surface.model" = "flat")"));
  EXPECT_EQ(scene_in(scene, scene.environment[0]), base_scene());
}

TEST(Environment, LayersMayBeSetWhole) {
  const Scene scene =
      read_text(setting(R"("sea.layer.0" = { bottom_depth_m = 20, cdom_a440_per_m = 0.1 })"));
  EXPECT_EQ(scene.environment[0].sea.layer[0].chlorophyll_mg_m3, 0.0);
  EXPECT_EQ(scene.environment[0].sea.layer[0].cdom_a440_per_m, 0.1);
}

// By name, by number, or with all of its layer; a layer may be set whole and one of its keys after
// that. Seen red: without the look at what has been set; with paths that are alike alone.
TEST(Environment, SetsEachValueOnce) {
  const auto twice = [](const std::string& first, const std::string& second) {
    return diagnostics_of(
        with_environments("[[environment]]\nset = { " + first + ", " + second + " }"),
        {"sea.layer.0.name=top"});
  };
  const std::string
      by_name = R"("sea.layer.top.chlorophyll_mg_m3" = 0.2)",
      by_number = R"("sea.layer.0.chlorophyll_mg_m3" = 0.3)",
      whole = R"("sea.layer.0" = { name = "top", bottom_depth_m = 20, cdom_a440_per_m = 0.1 })";
  const auto says = [](const std::string& path) {
    return "'" + path + "' sets what an entry before it has set (set each value once)";
  };
  ASSERT_EQ(twice(by_name, by_number).size(), 1U);
  EXPECT_THAT(twice(by_name, by_number)[0],
              testing::EndsWith(says("sea.layer.0.chlorophyll_mg_m3")));
  ASSERT_EQ(twice(by_number, whole).size(), 1U);
  EXPECT_THAT(twice(by_number, whole)[0], testing::EndsWith(says("sea.layer.0")));
  EXPECT_EQ(twice(whole, by_number), Texts{});
  EXPECT_EQ(twice(by_name, R"("sea.layer.0.cdom_a440_per_m" = 0.2)"), Texts{});
}

// --- --set ---------------------------------------------------------------------------------------

// Seen red: with every dot of a path inside `set` followed.
TEST(Environment, SetReachesTheSceneFirst) {
  const std::string text = setting(R"("sea.layer.0.chlorophyll_mg_m3" = 0.5)");
  const Scene both = read_text(text, {"sea.layer.0.cdom_a440_per_m=0.3", "sea.salinity_psu=30"});
  EXPECT_EQ(both.sea.layer[0].cdom_a440_per_m, 0.3);
  EXPECT_EQ(both.environment[0].sea.layer[0].cdom_a440_per_m, 0.3);
  EXPECT_EQ(both.environment[0].sea.layer[0].chlorophyll_mg_m3, 0.5);
  EXPECT_EQ(both.environment[0].sea.salinity_psu, 30.0);
  const Scene one =
      read_text(text, {"environment.0.set.sea.layer.0.chlorophyll_mg_m3=0.7",
                       "environment.0.set.sea.layer.0.cdom_a440_per_m=1", "environment.0.name=x"});
  EXPECT_EQ(one.sea, base_scene().sea);
  EXPECT_EQ(one.environment[0].name, "x");
  EXPECT_EQ(one.environment[0].sea.layer[0].chlorophyll_mg_m3, 0.7);
}

// --- What is said of a bad one -------------------------------------------------------------------

struct ChangeCase {
  const char* changes;
  std::vector<std::string> expected;
};

const std::vector<ChangeCase>& change_cases() {
  static const std::vector<ChangeCase> all{
      {R"("gates.depth_max_m" = 50)",
       {"scene.toml:32:9: 'gates.depth_max_m' cannot be set in an environment: only the water, the "
        "bed, "
        "a film of oil and the air may differ, since the histories are the same (set paths that "
        "begin with "
        "sea., optics., bottom., oil. or atmosphere.)"}},
      {R"("environment.0.name" = "x")",
       {"scene.toml:32:9: 'environment.0.name' cannot be set in an environment: only the water, "
        "the bed, "
        "a film of oil and the air may differ, since the histories are the same (set paths that "
        "begin with "
        "sea., optics., bottom., oil. or atmosphere.)"}},
      {R"("" = 1)",
       {"scene.toml:32:9: '' cannot be set in an environment: only the water, the bed, "
        "a film of oil and the air may differ, since the histories are the same (set paths that "
        "begin with "
        "sea., optics., bottom., oil. or atmosphere.)"}},
      {R"("sea" = { layer = [{}] })",
       {R"(scene.toml:32:9: 'sea' cannot be set as a whole in an environment (quote the whole path: "sea.layer.0.chlorophyll_mg_m3" = 0.5))"}},
      {R"(optics.set = "paper")",
       {R"(scene.toml:32:9: 'optics' cannot be set as a whole in an environment (quote the whole path: "sea.layer.0.chlorophyll_mg_m3" = 0.5))"}},
      {R"("sea..layer" = 1)",
       {"scene.toml:32:9: there is an empty name in the path (write names and numbers with dots "
        "between)"}},
      {R"("sea.layer.0.chlorophyll_mg_m3" = -1)",
       {"scene.toml:32:9: 'chlorophyll_mg_m3' must be a finite number, at least 0, not -1"}},
      {R"("sea.layer.0.chlorophyll_mg_m3" = inf)",
       {"scene.toml:32:9: 'sea.layer.0.chlorophyll_mg_m3' must be made of finite numbers, texts, "
        "true and false, not inf"}},
      {R"("sea.layer.1.iop" = [{ wavelength_nm = 1979-05-27 }])",
       {"scene.toml:32:9: 'sea.layer.1.iop' must be made of finite numbers, texts, true and false, "
        "not an array of 1"}},
      {R"("sea.layer.0.chlorophyl_mg_m3" = 1)",
       {"scene.toml:32:9: unknown key 'chlorophyl_mg_m3' in [[sea.layer]] (did you mean "
        "'chlorophyll_mg_m3'?)"}},
      {R"("sea.layer.top.chlorophyll_mg_m3" = 1)",
       {"scene.toml:32:9: nothing in 'layer' is called 'top' (its names and numbers: 0, 1)"}},
      {R"("sea.layer.2.chlorophyll_mg_m3" = 1)",
       {"scene.toml:32:9: there is no element 2 in 'layer' (it has 2, counted from 0)"}},
      {R"("sea.layer.0.name" = "top")",
       {R"(scene.toml:32:9: 'name' must be as in the scene, text "layer0", not text "top": all environments have the same layers (simulate that in a scene of its own))"}},
      {R"("sea.layer.0.bottom_depth_m" = 21)",
       {"scene.toml:32:9: 'bottom_depth_m' must be as in the scene, 20, not 21: light crosses from "
        "layer to layer in the same way in all environments (simulate that in a scene of its "
        "own)"}},
      {R"("sea.layer.1.bottom_depth_m" = 60)",
       {"scene.toml:32:9: 'bottom_depth_m' must be as in the scene, which has none, not 60: light "
        "crosses from layer to layer in the same way in all environments (simulate that in a scene "
        "of "
        "its own)"}},
      {R"("sea.layer.1.bottom_depth_m" = 10)",
       {"scene.toml:32:9: the layer ends at 10 m, not below the one above it, which ends at 20 m "
        "(layers go from the surface down)"}},
      {R"("sea.layer" = [{ chlorophyll_mg_m3 = 0.1 }])",
       {"scene.toml:32:9: there must be as many layers as in the scene, 2, not 1: light crosses "
        "from layer to layer in the same way in all environments (simulate that in a scene of its "
        "own)"}},
      {R"("sea.layer.0" = { chlorophyll_mg_m3 = 0.1 })",
       {"scene.toml:32:9: 'bottom_depth_m' is missing in [[sea.layer]] (only the last layer may be "
        "bottomless)"}},
      {R"("sea.salinity_psu" = 30)",
       {"scene.toml:32:9: 'salinity_psu' must be as in the scene, 35, not 30: it bends and times "
        "the light, whose histories are the same in all environments (simulate that in a "
        "scene of its own)"}},
      {R"("sea.temperature_c" = 10)",
       {"scene.toml:32:9: 'temperature_c' must be as in the scene, 20, not 10: it bends and times "
        "the light, whose histories are the same in all environments (simulate that in a "
        "scene of its own)"}},
      {R"("sea.refractive_index" = 1.33)",
       {"scene.toml:32:9: 'refractive_index' must be as in the scene, which has none, not 1.33: it "
        "bends the light, whose histories are the same in all environments (simulate that in "
        "a scene of its own)"}},
      {R"("sea.group_index" = 1.36)",
       {"scene.toml:32:9: 'group_index' must be as in the scene, which has none, not 1.36: it "
        "times the light, whose histories are the same in all environments (simulate that in "
        "a scene of its own)"}},
      {R"("optics.chlorophyll_lifetime_ns" = 1.5)",
       {"scene.toml:32:9: 'chlorophyll_lifetime_ns' must be as in the scene, 0, not 1.5: it times "
        "the light, whose histories are the same in all environments (simulate that in a "
        "scene of its own)"}},
      {R"("optics.cdom_lifetime_ns" = 2, "optics.raman" = "bartlett")",
       {"scene.toml:32:9: 'cdom_lifetime_ns' must be as in the scene, 0, not 2: it times the "
        "light, whose histories are the same in all environments (simulate that in a scene "
        "of its own)"}},
      {R"("sea.surface.model" = "cox-munk")",
       {"scene.toml:32:9: 'wind_speed_m_s' is missing in 'surface' (add it: the wind's speed in "
        "m/s; at 0 the surface is flat)",
        "scene.toml:32:9: 'model' must be as in the scene, text \"flat\", not text \"cox-munk\": "
        "it bends the light, whose histories are the same in all environments (simulate that "
        "in a scene of its own)"}},
      {R"("sea.surface.model" = "cox-munk", "sea.surface.wind_speed_m_s" = 3)",
       {"scene.toml:32:9: 'model' must be as in the scene, text \"flat\", not text \"cox-munk\": "
        "it bends the light, whose histories are the same in all environments (simulate that "
        "in a scene of its own)"}},
      {R"("sea.surface.wind_speed_m_s" = 3)",
       {"scene.toml:32:9: 'wind_speed_m_s' does not belong to model = \"flat\" (it belongs to "
        "\"cox-munk\" and \"paper\")"}},
      {R"("sea.layer.1.phase_function" = { model = "fournier-forand", slope = 3.6 })",
       {"scene.toml:32:9: 'refractive_index' is missing in 'phase_function' (add it: the "
        "particles' real refractive index relative to water)"}},
      {R"("sea.layer.0.iop" = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }])",
       {"scene.toml:32:9: 'chlorophyll_mg_m3' and 'iop' exclude each other in [[sea.layer]] (keep "
        "one of them)"}},
      {R"("optics.set" = "papper")",
       {R"(scene.toml:32:9: 'set' must be "modern" or "paper", not text "papper" (did you mean 'paper'?))"}},
      {R"("optics.raman.x" = "bartlett")",
       {R"(scene.toml:32:9: 'raman' must be "bartlett" or "marshall-smith", not a table)"}},
      {R"("optics.raman" = "bartlett", "sea.layer.1.iop.0.a_per_m" = 0, "sea.layer.1.iop.0.b_per_m" = 0)",
       {R"(scene.toml:32:38: in environment "environment0": a_per_m + b_per_m is 0: there is no water without attenuation)"}},
  };
  return all;
}

// Seen red, each for itself: with any path allowed; "sea" as a whole allowed; values not asked
// whether they are any; layers not compared; the group index left out; values below a change in
// places of their own; the last of equally near changes taken; the environment compared with a
// scene where this is wrong.
TEST(Environment, EveryTextOfWhatIsWrong) {
  for (const ChangeCase& c : change_cases()) {
    SCOPED_TRACE(c.changes);
    EXPECT_EQ(diagnostics_of(setting(c.changes)), c.expected);
  }
}

// Seen red: with names that may be there twice.
TEST(Environment, NamesTwiceAndKeysAmiss) {
  const auto reported = [](const std::string& text) {
    return diagnostics_of(with_environments(text));
  };
  EXPECT_EQ(
      reported("[[environment]]\nname = \"environment1\"\nset = {}\n[[environment]]\nset = {}"),
      (Texts{
          R"(scene.toml:34:1: two of [[environment]] are called "environment1" (give each its own name))"}));
  EXPECT_EQ(
      reported("[[environment]]\nname = \"a\""),
      (Texts{"scene.toml:31:1: 'set' is missing in [[environment]] (add it: the values that differ "
             "in this water, by their paths: those of --set that begin with "
             "sea., optics., bottom., oil. or atmosphere.)"}));
  EXPECT_EQ(
      reported("[[environment]]\nset = 5"),
      (Texts{
          R"(scene.toml:32:7: 'set' must be a table, not 5 (write { "sea.layer.0.chlorophyll_mg_m3" = 0.5 }))"}));
  EXPECT_EQ(
      reported("[[environment]]\nset = {}\nchannel = 1"),
      (Texts{"scene.toml:33:1: unknown key 'channel' in [[environment]] (write [[channel]])"}));
  EXPECT_EQ(diagnostics_of("environment = []\n" + edited({})),
            (Texts{"scene.toml:1:15: 'environment' must be one or more tables, not [] (write "
                   "[[environment]])"}));
}

// Seen red, each for itself: with the scene's problems reported again; places outside the changes
// kept; all reported at `set`; the place of the key where --set gave the value; names in paths left
// as they are.
TEST(Environment, ProblemsAreReportedOnceAndAtTheChange) {
  const std::string two = R"([[environment]]
set = { "optics.raman" = "bartlett" }
[[environment]]
name = "b"
[environment.set]
"optics.raman" = "bartlett"
"sea.layer.0.chlorophyll_mg_m3" = -2
"sea.layer.deep.iop.0.a_per_m" = 0)";
  // The scene is wrong itself, once at a value that an environment mends.
  EXPECT_EQ(
      diagnostics_of(
          edited({{3, 3, "wavelength_nm = -1"},
                  {22, 22, "chlorophyll_mg_m3 = -1"},
                  {23, 23, "[[sea.layer]]\nname = \"deep\""},
                  {24, 24, "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0 }]"}}) +
          two),
      (Texts{
          "scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not -1",
          "scene.toml:22:21: 'chlorophyll_mg_m3' must be a finite number, at least 0, not -1",
          "scene.toml:38:1: 'chlorophyll_mg_m3' must be a finite number, at least 0, not -2",
          R"(scene.toml:39:1: in environment "b": a_per_m + b_per_m is 0: there is no water without attenuation)"}));
  EXPECT_EQ(
      diagnostics_of(edited({}) + two, {"sea.layer.1.name=deep", "sea.layer.1.iop.0.b_per_m=0"}),
      (Texts{
          "scene.toml:37:1: 'chlorophyll_mg_m3' must be a finite number, at least 0, not -2",
          R"(scene.toml:38:1: in environment "b": a_per_m + b_per_m is 0: there is no water without attenuation)"}));
  EXPECT_EQ(
      diagnostics_of(
          with_environments(two),
          {"sea.layer.1.name=deep", "environment.1.set.sea.layer.0.chlorophyll_mg_m3=-3"}),
      (Texts{"--set environment.1.set.sea.layer.0.chlorophyll_mg_m3: 'chlorophyll_mg_m3' must "
             "be a finite number, at least 0, not -3"}));
}

/// Stands for the optics, which find nothing wrong with the base scene.
void find_fault(const Scene& scene, Findings& findings, Asked) {
  findings.remark("channel.0.process", "true of every water");
  if (scene.sea.layer[0].chlorophyll_mg_m3 > 0.1) findings.remark("sea.layer.0", "a murky layer");
  if (scene.sea.layer[0].chlorophyll_mg_m3 <= 1.0) return;
  findings.add("source.wavelength_nm", "no data", "another laser");
  findings.add("sea.layer.0.chlorophyll_yield", "too much light", "");
  findings.add("sea.layer.1", {"vsf.csv", 3, 1}, "no number", "");
}

// Seen red, each for itself: with the check not run on environments; the scene's remarks reported
// again; what is wrong in other files reported at a change.
TEST(Environment, IsCheckedAsTheSceneIs) {
  const std::string text = with_environments(R"([[environment]]
name = "b"
set = { "optics.raman" = "bartlett", "sea.layer.0.chlorophyll_mg_m3" = 0.5 })");
  EXPECT_EQ(read_scene_text(text, "scene.toml", "/", {}, find_fault).remarks,
            (Texts{"scene.toml:17:11: true of every water",
                   R"(scene.toml:33:38: in environment "b": a murky layer)"}));
  EXPECT_EQ(
      diagnostics_of(text, {"environment.0.set.sea.layer.0.chlorophyll_mg_m3=2"}, find_fault),
      (Texts{
          R"(scene.toml:33:1: in environment "b": no data (another laser))",
          "vsf.csv:3:1: no number",
          R"(--set environment.0.set.sea.layer.0.chlorophyll_mg_m3: in environment "b": too much light)"}));
}

// Seen red: with the environments' bytes not counted.
TEST(Environment, TakesMemory) {
  std::string channels;
  for (int i = 0; i < 200; ++i)
    channels += "[[channel]]\nname = \"c" + std::to_string(i) + "\"\nprocess = \"raman\"\n";
  channels.pop_back();
  std::string text = edited({{15, 17, channels}, {28, 28, "depth_step_m = 0.125"}});
  EXPECT_TRUE(diagnostics_of(text).empty());
  for (int i = 0; i < 100; ++i) text += "[[environment]]\nset = {}\n";
  EXPECT_EQ(diagnostics_of(text),
            std::vector<std::string>{
                "scene.toml:628:1: the tallies (telescopes 1, channels 200, gates "
                "400, orders 6, cells of depth 100, environments 100) would take "
                "4.7 GiB; the limit is 2 GiB (take fewer environments, or fewer gates)"});
}

}  // namespace
}  // namespace photic::scene
