// What is said of a sea surface that is amiss.
#include <gtest/gtest.h>

#include "unit/scene/surface_scenes.hpp"

namespace photic::scene {
namespace {

struct Wrong {
  const char* name;
  std::string keys, simulation;
  Texts expected;
};

const std::vector<Wrong>& wrong_surfaces() {
  static const std::string sea = waves;
  static const std::string own =
      R"(model = "gaussian", upwind_slope_variance = 0.02, crosswind_slope_variance = 0.01)";
  static const std::vector<Wrong> all{
      {"UnknownModel",
       R"(model = "coxmunk", wind_speed_m_s = 5, slick = true)",
       "",
       {R"(scene.toml:20:21: 'model' must be "flat", "cox-munk", "gaussian" or "paper", not text "coxmunk" (did you mean 'cox-munk'?))"}},
      {"SlickIsAKey",
       R"(model = "slick", wind_speed_m_s = 5)",
       "",
       {R"(scene.toml:20:21: 'model' must be "flat", "cox-munk", "gaussian" or "paper", not text "slick" (write model = "cox-munk" with slick = true))"}},
      {"ModelAsNumber",
       "model = 1, wind_speed_m_s = 5",
       "",
       {R"(scene.toml:20:21: 'model' must be "flat", "cox-munk", "gaussian" or "paper", not 1)"}},
      {"ModelMissing",
       "wind_speed_m_s = 5",
       "",
       {R"(scene.toml:20:30: 'wind_speed_m_s' does not belong to model = "flat" (it belongs to "cox-munk" and "paper"))"}},
      {"WindMissing",
       R"(model = "cox-munk", wind_direction_deg = 90)",
       "",
       {"scene.toml:20:11: 'wind_speed_m_s' is missing in 'surface' (add it: the wind's speed in "
        "m/s; at 0 the surface is flat)"}},
      {"WindOfThePaperMissing",
       R"(model = "paper")",
       "",
       {"scene.toml:20:11: 'wind_speed_m_s' is missing in 'surface' (add it: the wind's speed in "
        "m/s; at 0 the surface is flat)"}},
      {"VariancesMissing",
       R"(model = "gaussian")",
       "",
       {"scene.toml:20:11: 'upwind_slope_variance' is missing in 'surface' (add it: the variance "
        "of slopes along the wind)",
        "scene.toml:20:11: 'crosswind_slope_variance' is missing in 'surface' (add it: the "
        "variance of slopes across the wind; with one variance 0 waves are one-dimensional)"}},
      {"OutOfRange",
       R"(model = "cox-munk", wind_speed_m_s = 31, wind_direction_deg = 361, whitecap_fraction = 1.1)",
       "",
       {"scene.toml:20:50: 'wind_speed_m_s' must be a finite number, at least 0 and at most 30, "
        "not 31",
        "scene.toml:20:75: 'wind_direction_deg' must be a finite number, at least -360 and at most "
        "360, not 361",
        "scene.toml:20:100: 'whitecap_fraction' must be a finite number, at least 0 and at most 1, "
        "not 1.1"}},
      {"VariancesOutOfRange",
       R"(model = "gaussian", upwind_slope_variance = -0.1, crosswind_slope_variance = 1.5)",
       "",
       {"scene.toml:20:57: 'upwind_slope_variance' must be a finite number, at least 0 and at most "
        "1, not -0.1",
        "scene.toml:20:90: 'crosswind_slope_variance' must be a finite number, at least 0 and at "
        "most 1, not 1.5"}},
      {"NoYesOrNo",
       sea + R"(, slick = "true", gram_charlier = 1, whitecaps = [])",
       "",
       {R"(scene.toml:20:61: 'slick' must be true or false, not text "true")",
        "scene.toml:20:85: 'gram_charlier' must be true or false, not 1",
        "scene.toml:20:100: 'whitecaps' must be true or false, not []"}},
      {"KeysOfOtherModels",
       own +
           R"(, slick = true, gram_charlier = false, wind_speed_m_s = 5, whitecap_law = "monahan1980")",
       "",
       {R"(scene.toml:20:104: 'slick' does not belong to model = "gaussian" (it belongs to "cox-munk"))",
        R"(scene.toml:20:126: 'gram_charlier' does not belong to model = "gaussian" (it belongs to "cox-munk"))",
        R"(scene.toml:20:150: 'wind_speed_m_s' does not belong to model = "gaussian" (it belongs to "cox-munk" and "paper"))",
        R"(scene.toml:20:168: 'whitecap_law' does not belong to model = "gaussian" (it belongs to "cox-munk" and "paper"))"}},
      {"KeysOfWavesOfTheFlatSea",
       R"(model = "flat", whitecaps = false, wind_direction_deg = 0, upwind_slope_variance = 0)",
       "",
       {R"(scene.toml:20:41: 'whitecaps' does not belong to model = "flat" (it belongs to "cox-munk", "gaussian" and "paper"))",
        R"(scene.toml:20:69: 'wind_direction_deg' does not belong to model = "flat" (it belongs to "cox-munk", "gaussian" and "paper"))",
        R"(scene.toml:20:96: 'upwind_slope_variance' does not belong to model = "flat" (it belongs to "gaussian"))"}},
      {"KnotsAndOtherNames",
       R"(model = "cox-munk", wind_speed_knots = 10, wind_direction = 90, whitecap = false)",
       "",
       {"scene.toml:20:11: 'wind_speed_m_s' is missing in 'surface' (add it: the wind's speed in "
        "m/s; at 0 the surface is flat)",
        "scene.toml:20:33: unknown key 'wind_speed_knots' in 'surface' (did you mean "
        "'wind_speed_m_s'? it is in m/s)",
        "scene.toml:20:56: unknown key 'wind_direction' in 'surface' (did you mean "
        "'wind_direction_deg'?)",
        "scene.toml:20:77: unknown key 'whitecap' in 'surface' (did you mean 'whitecaps'?)"}},
      {"UnknownLaw",
       sea + R"(, whitecap_law = "monahan1986", whitecap_reflectance = "koepke1985")",
       "",
       {R"(scene.toml:20:68: 'whitecap_law' must be "monahan1980" or "stramska2003", not text "monahan1986" (did you mean 'monahan1980'?))",
        R"(scene.toml:20:106: 'whitecap_reflectance' must be "koepke1984" or "frouin1996", not text "koepke1985" (did you mean 'koepke1984'?))"}},
      {"TooLittleWind",
       R"(model = "paper", wind_speed_m_s = 1e-30)",
       "",
       {"scene.toml:20:47: a wind of 1e-30 m/s is too small for waves (write 0, or at least "
        "0.001)"}},
      {"TooSmallSlopes",
       R"(model = "gaussian", upwind_slope_variance = 1e-300, crosswind_slope_variance = 1e-7)",
       "",
       {"scene.toml:20:57: a variance of 1e-300 is too small for waves (write 0, or at least "
        "1e-06)",
        "scene.toml:20:92: a variance of 1e-07 is too small for waves (write 0, or at least "
        "1e-06)"}},
      {"OverlapOfWaves",
       own,
       "reception = \"overlap\"",
       {R"(scene.toml:32:13: waves spread light over the lens unevenly: the mean over the lens is not known (write reception = "ray"))"}},
      {"ForcedCollisionsUnderWaves",
       R"(model = "paper", wind_speed_m_s = 5)",
       "tools = { forced_collisions = 1 }",
       {R"(scene.toml:32:31: how much light leaves the water is known only for a flat surface (write forced_collisions = 0, or sea.surface = { model = "flat" }))"}},
      {"AllThatHasNoWaves",
       R"(model = "paper", wind_speed_m_s = 5)",
       "tools = { forced_collisions = 1 }\nreception = \"overlap\"",
       {R"(scene.toml:32:31: how much light leaves the water is known only for a flat surface (write forced_collisions = 0, or sea.surface = { model = "flat" }))",
        R"(scene.toml:33:13: waves spread light over the lens unevenly: the mean over the lens is not known (write reception = "ray"))"}},
      {"NoWhitecapsAndSome",
       sea + ", whitecaps = false, whitecap_fraction = 0.1",
       "",
       {"scene.toml:20:92: whitecaps = false says that there are no whitecaps (leave one of them "
        "out)"}},
      {"WhitecapsOfNoWind",
       R"(model = "cox-munk", wind_speed_m_s = 0, whitecap_fraction = 0.5)",
       "",
       {"scene.toml:20:73: a sea without waves has no whitecaps (give it a wind, or variances of "
        "slopes, or leave whitecap_fraction out)"}},
      {"WhitecapsOfNoSlopes",
       R"(model = "gaussian", upwind_slope_variance = 0, crosswind_slope_variance = 0, whitecap_fraction = 0.5)",
       "",
       {"scene.toml:20:110: a sea without waves has no whitecaps (give it a wind, or variances of "
        "slopes, or leave whitecap_fraction out)"}},
      {"WhitecapsWithoutWind",
       own + ", whitecaps = true",
       "",
       {"scene.toml:20:108: without a wind it is not known how much of the sea whitecaps cover "
        "(give whitecap_fraction)"}},
  };
  return all;
}

// Seen red, each for itself: keys of the flat sea reported where the model is none; "slick" without
// a word of its key; without each condition of check_surface.cpp; texts taken for true.
TEST(Surface, EveryTextWithLineAndColumn) {
  for (const Wrong& c : wrong_surfaces()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited(with_surface(c.keys, c.simulation))), c.expected);
  }
}

// Seen red: with all telescopes taken to look down.
TEST(Surface, BidirectionalOverWavesOfOneDirectionSeenFlat) {
  auto edits =
      with_surface(R"(model = "paper", wind_speed_m_s = 5)", "estimator = \"bidirectional\"");
  edits.insert(edits.begin(), {11, 11, "direction = [1, 0, -0.2]"});
  EXPECT_EQ(
      diagnostics_of(edited(edits)),
      Texts{
          R"(scene.toml:32:13: the bidirectional estimator cannot treat one-dimensional waves seen by rays within 12 degrees of the horizontal (write estimator = "forward", or sea.surface = { model = "flat" }))"});
}

// Nothing is said of whitecaps that are not there, nor twice of one thing.
TEST(Surface, WhitecapsOfNoneAreNoProblem) {
  const std::string sea = waves;
  EXPECT_EQ(
      diagnostics_of(edited(with_surface(sea + ", whitecaps = false, whitecap_fraction = 0"))),
      Texts{});
  EXPECT_EQ(
      diagnostics_of(edited(with_surface(
          R"(model = "gaussian", upwind_slope_variance = 0.01, crosswind_slope_variance = 0, whitecaps = false)"))),
      Texts{});
}

}  // namespace
}  // namespace photic::scene
