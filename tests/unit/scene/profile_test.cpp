// Constituents that change with depth: their means, where layers are cut, what is wrong with them.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/cut.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

/// The base scene with this for the chlorophyll of its first layer, from line 22 on, column 21.
std::string with_chlorophyll(const std::string& profile, const std::string& more = "") {
  return edited({{22, 22, "chlorophyll_mg_m3 = " + profile + more}});
}

const char* const ramp = "{ depth_m = [0, 5, 20], value = [0.2, 1.0, 0.1] }";
const char* const maximum =
    R"({ model = "gaussian", background = 0.05, maximum = 0.6, depth_m = 12, width_m = 3 })";

/// Of layers first to last of a scene.
double column(const Scene& scene, std::size_t first, std::size_t last, double Layer::*value) {
  double sum = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double top = i == 0 ? 0.0 : *scene.sea.layer[i - 1].bottom_depth_m;
    sum += scene.sea.layer[i].*value * (*scene.sea.layer[i].bottom_depth_m - top);
  }
  return sum;
}

// --- Means ---------------------------------------------------------------------------------------

TEST(Profile, LinearIntegralsAreThoseOfTrapezoids) {
  const LinearProfile p({0, 5, 20}, {0.2, 1.0, 0.1});
  EXPECT_NEAR(p.integral(0, 20), 5 * 0.6 + 15 * 0.55, 1e-14);
  EXPECT_NEAR(p.integral(2.5, 5), 2.5 * 0.8, 1e-15);
  EXPECT_NEAR(p.integral(4, 11), 0.5 * (0.84 + 1.0) + 3 * (1.0 + 0.64), 1e-14);
  EXPECT_NEAR(p.integral(6, 7), 0.91, 1e-15);
  EXPECT_EQ(p.extremes(4, 11).greatest, 1.0);
  EXPECT_NEAR(p.extremes(4, 11).least, 0.64, 1e-15);
}

// Against sums of the formula as it is printed. Seen red: with the width for sqrt(2) times it.
TEST(Profile, GaussianIntegralsAreThoseOfItsFormula) {
  const GaussianProfile p{0.05, 0.6, 12, 3};
  for (const auto& [a, b] : {std::pair{0.0, 20.0}, {9.0, 12.0}, {11.0, 11.5}, {50.0, 90.0}}) {
    double sum = 0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const double z = a + (b - a) * (i + 0.5) / steps;
      sum += 0.05 + 0.55 * std::exp(-(z - 12) * (z - 12) / (2 * 3 * 3));
    }
    EXPECT_NEAR(p.integral(a, b), sum * (b - a) / steps, 1e-8) << a;
  }
  EXPECT_EQ(p.extremes(0, 20).greatest, 0.6);
  EXPECT_EQ(p.extremes(0, 11).greatest, p.extremes(11, 11).greatest);
}

// --- Cuts ----------------------------------------------------------------------------------------

// Seen red: with a departure of twice the tolerance allowed; with the extremes of the ends alone.
TEST(Cut, KeepsTheToleranceWithFewLayers) {
  const std::vector<Varying> profiles{{LinearProfile({0, 5, 20}, {0.2, 1.0, 0.1})},
                                      {GaussianProfile{0.05, 0.6, 12, 3}}};
  for (const double tolerance : {0.3, 0.05, 0.01}) {
    SCOPED_TRACE(tolerance);
    const auto ends = cut(profiles, {0, 20}, tolerance);
    ASSERT_TRUE(ends);
    EXPECT_EQ(ends->back(), 20);
    double top = 0;
    for (const double end : *ends) {
      ASSERT_GT(end, top);
      for (int i = 0; i <= 100; ++i) {
        const double z = std::lerp(top, end, i / 100.0);
        const auto departs = [&](const Profile& p, double value) {
          return std::fabs(value - mean(p, top, end)) / greatest(p, 0, 20);
        };
        const double linear = z < 5 ? 0.2 + 0.16 * z : 1.0 - 0.06 * (z - 5);
        const double bell = 0.05 + 0.55 * std::exp(-(z - 12) * (z - 12) / 18);
        EXPECT_LE(departs(profiles[0].profile, linear), tolerance + 1e-12);
        EXPECT_LE(departs(profiles[1].profile, bell), tolerance + 1e-12);
      }
      top = end;
    }
    // Each profile alone takes (total rise and fall)/(2 tolerance) layers.
    EXPECT_LE(static_cast<double>(ends->size()), 1.2 * (1.7 / 1 + 1.1 / 0.6) / (2 * tolerance) + 4);
  }
}

TEST(Cut, OfWhatIsConstantIsOneLayer) {
  EXPECT_EQ(cut({{LinearProfile({0, 20}, {0.1, 0.1})}}, {0, 20}, 1e-3), std::vector{20.0});
  EXPECT_EQ(cut({{LinearProfile({0, 20}, {0, 0})}}, {0, 20}, 1e-3), std::vector{20.0});
}

TEST(Cut, DepthsAreRound) {
  const auto ends = cut({{LinearProfile({0, 20}, {0, 1})}}, {0, 20}, 0.05);
  ASSERT_EQ(ends->size(), 11U);  // of 2 m, but for rounding
  EXPECT_EQ((*ends)[0], 1.9);
  EXPECT_EQ((*ends)[9], 19.0);
}

TEST(Cut, HasAnEnd) {
  const std::vector<Varying> steep{{LinearProfile({0, 20}, {0, 1})}};
  EXPECT_FALSE(cut(steep, {0, 20}, 1e-4));
  EXPECT_EQ(tolerance_to_keep(steep, {0, 20}, 1e-4), 0.002);
  EXPECT_TRUE(cut(steep, {0, 20}, 0.002));
  EXPECT_FALSE(cut(steep, {0, 20}, 0.001));
}

// --- Scenes --------------------------------------------------------------------------------------

// Seen red: with the value in the middle of a layer for the mean.
TEST(Profile, BecomesLayersWithTheSameColumn) {
  const Scene scene = read_text(with_chlorophyll(ramp));
  const std::size_t last = scene.sea.layer.size() - 1;
  ASSERT_EQ(last, 18U);  // 17, but for rounding
  EXPECT_NEAR(column(scene, 0, last - 1, &Layer::chlorophyll_mg_m3), 11.25, 1e-13);
  EXPECT_EQ(scene.sea.layer[0].name, "layer0.0");
  EXPECT_EQ(scene.sea.layer[17].name, "layer0.17");
  EXPECT_EQ(scene.sea.layer[17].bottom_depth_m, 20.0);
  EXPECT_EQ(scene.sea.layer[18].name, "layer1");
  EXPECT_FALSE(scene.sea.layer[18].iop.empty());
}

// Seen red: with exp(-x^2) where layers are cut.
TEST(Profile, OfAMaximum) {
  const Scene scene = read_text(with_chlorophyll(maximum));
  const std::size_t last = scene.sea.layer.size() - 1;
  EXPECT_NEAR(column(scene, 0, last - 1, &Layer::chlorophyll_mg_m3),
              GaussianProfile({0.05, 0.6, 12, 3}).integral(0, 20), 1e-13);
}

TEST(Profile, IsWrittenAsNumbersAndReadsBack) {
  const Scene scene = read_text(with_chlorophyll(ramp, "\nname = \"top\""));
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("name = \"top.3\""), std::string::npos) << text;
  EXPECT_EQ(text.find("value ="), std::string::npos) << text;
  EXPECT_TRUE(read_scene_text(text, "written.toml", "/elsewhere").scene == scene);
}

// Seen red: with cuts for the first constituent alone.
TEST(Profile, OfSeveralConstituentsShareTheirCuts) {
  const Scene scene =
      read_text(with_chlorophyll("{ depth_m = [0, 20], value = [1, 0.8] }",
                                 "\ncdom_a440_per_m = { depth_m = [-1, 30], value = [0, 0.31] }"));
  const std::size_t last = scene.sea.layer.size() - 1;
  EXPECT_EQ(last, 10U);  // (0.21 - 0.01) / (2 * 0.05 * 0.21) is 9.5
  EXPECT_NEAR(column(scene, 0, last - 1, &Layer::chlorophyll_mg_m3), 20 * 0.9, 1e-13);
  EXPECT_NEAR(column(scene, 0, last - 1, &Layer::cdom_a440_per_m), 20 * 0.11, 1e-13);
}

TEST(Profile, OfALowerLayerBeginsWhereTheUpperOneEnds) {
  const Scene scene = read_text(edited({{23, 25, R"([[sea.layer]]
bottom_depth_m = 40
cdom_a440_per_m = { depth_m = [20, 40], value = [0.1, 0.3] }
[[sea.layer]])"}}),
                                {"sea.profile_tolerance=0.2"});
  ASSERT_EQ(scene.sea.layer.size(), 4U);
  EXPECT_EQ(scene.sea.layer[0].name, "layer0");
  EXPECT_EQ(scene.sea.layer[1].name, "layer1.0");
  EXPECT_EQ(scene.sea.layer[2].name, "layer1.1");
  EXPECT_EQ(scene.sea.layer[3].name, "layer2");
  EXPECT_EQ(scene.sea.layer[1].bottom_depth_m, 31.0);
  EXPECT_NEAR(scene.sea.layer[1].cdom_a440_per_m, 0.155, 1e-15);
  EXPECT_NEAR(scene.sea.layer[2].cdom_a440_per_m, 0.255, 1e-15);
}

TEST(Profile, WithinTheToleranceIsANumber) {
  const Scene scene = read_text(with_chlorophyll("{ depth_m = [0, 30], value = [0.100, 0.103] }"));
  ASSERT_EQ(scene.sea.layer.size(), 2U);
  EXPECT_EQ(scene.sea.layer[0].name, "layer0");
  EXPECT_NEAR(scene.sea.layer[0].chlorophyll_mg_m3, 0.101, 1e-15);
}

TEST(Profile, MayBeSetAndReplacedByAnOverride) {
  EXPECT_EQ(read_text(with_chlorophyll(ramp), {"sea.layer.0.chlorophyll_mg_m3=0.1"}), base_scene());
  EXPECT_EQ(base_scene({std::string("sea.layer.0.chlorophyll_mg_m3=") + ramp}),
            read_text(with_chlorophyll(ramp)));
}

// --- Environments and sensitivities --------------------------------------------------------------

std::string in_environment(const std::string& set) {
  return with_chlorophyll(ramp) + "[[environment]]\nset = { " + set + " }\n";
}

// Seen red: with the environment cut on its own.
TEST(Profile, IsReplacedInAllItsLayersByANumberOfAnEnvironment) {
  const Scene scene = read_text(in_environment(R"("sea.layer.0.chlorophyll_mg_m3" = 0.5)"));
  const auto& layers = scene.environment[0].sea.layer;
  ASSERT_EQ(layers.size(), scene.sea.layer.size());
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    EXPECT_EQ(layers[i].chlorophyll_mg_m3, 0.5);
    EXPECT_EQ(layers[i].bottom_depth_m, scene.sea.layer[i].bottom_depth_m);
  }
  EXPECT_EQ(layers.back(), scene.sea.layer.back());
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

TEST(Profile, OfAnEnvironmentIsCutAsTheScenes) {
  const Scene scene = read_text(in_environment(
      R"("sea.layer.0.chlorophyll_mg_m3" = { depth_m = [0, 5, 20], value = [0.4, 2.0, 0.2] }, )"
      R"("sea.layer.1.iop.0.a_per_m" = 0.2)"));
  for (std::size_t i = 0; i + 1 < scene.sea.layer.size(); ++i)
    EXPECT_NEAR(scene.environment[0].sea.layer[i].chlorophyll_mg_m3,
                2 * scene.sea.layer[i].chlorophyll_mg_m3, 1e-14);
  EXPECT_EQ(scene.environment[0].sea.layer.back().iop[0].a_per_m, 0.2);
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

// Seen red: with the departures not looked at.
TEST(Profile, OfAnEnvironmentMustSuitTheScenesLayers) {
  const std::string other =
      R"("sea.layer.0.chlorophyll_mg_m3" = { depth_m = [0, 10, 11, 20], value = [0, 0, 1, 1] })";
  EXPECT_EQ(
      diagnostics_of(in_environment(other)),
      (Texts{"scene.toml:32:9: 'chlorophyll_mg_m3' departs from its mean by 0.563 between 9.8 and "
             "11.4 m, a layer of the scene; profile_tolerance allows 0.05 (allow more by "
             "\"sea.profile_tolerance\" in the environment, or simulate that in a scene of "
             "its own)"}));
  const Scene scene = read_text(in_environment(other + R"(, "sea.profile_tolerance" = 0.9)"));
  EXPECT_NEAR(column(scene_in(scene, scene.environment[0]), 0, scene.sea.layer.size() - 2,
                     &Layer::chlorophyll_mg_m3),
              9.5, 1e-13);
}

TEST(Profile, MovesTheLayersThatSensitivitiesName) {
  const Scene scene =
      read_text("sensitivity = ['sea.layer.1.iop.0.a_per_m']\n" + with_chlorophyll(ramp));
  EXPECT_EQ(scene.sensitivity[0].path, "sea.layer.18.iop.0.a_per_m");
  EXPECT_EQ(scene.sensitivity[0].value, 0.06);
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

// Seen red: with the path taken for one of the layers that there are in the end.
TEST(Profile, HasNoOneValueToDeriveBy) {
  EXPECT_EQ(
      diagnostics_of("sensitivity = ['sea.layer.0.chlorophyll_mg_m3', 'sea.layer.top.cdom']\n" +
                     with_chlorophyll(ramp, "\nname = 'top'")),
      (Texts{"scene.toml:1:16: 'sea.layer.0.chlorophyll_mg_m3' is in a layer that its "
             "profiles cut into 18: it has no single value for a derivative (compare environments, "
             "or take the derivative in the scene that `photic show` writes)",
             "scene.toml:1:49: 'sea.layer.top.cdom' is in a layer that its profiles cut into "
             "18: it has no single value for a derivative (compare environments, or take the "
             "derivative in the scene that `photic show` writes)"}));
}

// --- What is wrong with them ---------------------------------------------------------------------

class ProfileProblem : public testing::TestWithParam<Case> {};

TEST_P(ProfileProblem, IsReportedAtItsPlace) {
  EXPECT_EQ(diagnostics_of(edited(GetParam().edits)), GetParam().expected);
}

Case chlorophyll(const char* name, const char* profile, std::vector<std::string> expected) {
  return {name, {{22, 22, std::string("chlorophyll_mg_m3 = ") + profile}}, std::move(expected)};
}

INSTANTIATE_TEST_SUITE_P(
    All, ProfileProblem,
    testing::Values(
        chlorophyll("Outside", "{ depth_m = [1, 20], value = [0.1, 0.2] }",
                    {"scene.toml:22:21: 'chlorophyll_mg_m3' is known from 1 to 20 m, and its layer "
                     "goes from 0 to 20 m (above = \"constant\" holds its first value up to the "
                     "top; or let layers with a number begin and end where the "
                     "profile does)"}),
        chlorophyll("NotAscending", "{ depth_m = [0, 20, 20], value = [0.1, 0.2, 0.3] }",
                    {"scene.toml:22:41: 'chlorophyll_mg_m3' goes from 20 m to 20 m: depths must "
                     "ascend"}),
        chlorophyll("Negative", "{ depth_m = [0, 20], value = [-0.1, -1e9] }",
                    {"scene.toml:22:51: 'chlorophyll_mg_m3' must be a finite number, at least 0, "
                     "not -0.1",
                     "scene.toml:22:57: 'chlorophyll_mg_m3' must be a finite number, at least 0, "
                     "not -1000000000"}),
        chlorophyll("NotANumber", "{ depth_m = [0, nan], value = [0.1, 'x'] }",
                    {"scene.toml:22:33: 'depth_m' must be two or more finite numbers [a, b, …], "
                     "not [0, nan]",
                     "scene.toml:22:51: 'value' must be two or more finite numbers [a, b, …], not "
                     "[0.1, text \"x\"]"}),
        chlorophyll("OneTooMany", "{ depth_m = [0, 20], value = [0.1, 0.2, 0.3] }",
                    {"scene.toml:22:50: 'chlorophyll_mg_m3' has 3 values at 2 depths (give a value "
                     "for each depth)"}),
        chlorophyll("Misspelt", "{ depth = [0, 20], value = [0.1, 0.2] }",
                    {"scene.toml:22:21: 'depth_m' is missing in 'chlorophyll_mg_m3' (add it: "
                     "depths in m, ascending)",
                     "scene.toml:22:23: unknown key 'depth' in 'chlorophyll_mg_m3' (did you mean "
                     "'depth_m'?)"}),
        chlorophyll(
            "MaximumBelowBackground",
            "{ model = 'gaussian', background = 1, maximum = 0.5, depth_m = 1, width_m = 1 }",
            {"scene.toml:22:69: 'chlorophyll_mg_m3' has a maximum of 0.5, below its "
             "background of 1 (the maximum is the value there, background included)"}),
        chlorophyll("OtherModel", "{ model = 'gauss' }",
                    {"scene.toml:22:21: 'background' is missing in 'chlorophyll_mg_m3' (add it: "
                     "the value far from the maximum)",
                     "scene.toml:22:21: 'maximum' is missing in 'chlorophyll_mg_m3' (add it: the "
                     "value at the maximum)",
                     "scene.toml:22:21: 'depth_m' is missing in 'chlorophyll_mg_m3' (add it: the "
                     "depth of the maximum in m)",
                     "scene.toml:22:21: 'width_m' is missing in 'chlorophyll_mg_m3' (add it: its "
                     "standard deviation in m)",
                     "scene.toml:22:31: 'model' must be \"gaussian\", not text \"gauss\" (choose "
                     "from: gaussian)"}),
        Case{"Bottomless",
             {{23, 25, "[[sea.layer]]\ncdom_a440_per_m = { depth_m = [20, 90], value = [0, 1] }"}},
             {"scene.toml:24:19: 'cdom_a440_per_m' changes with depth in a layer without "
              "'bottom_depth_m' (end the layer, and add one with a number below it)"}},
        Case{"UnderALayerThatIsWrong",
             {{21, 21, "bottom_depth_m = -1"},
              {23, 25,
               "[[sea.layer]]\nbottom_depth_m = 90\ncdom_a440_per_m = { depth_m = [20, 90], value "
               "= [0, 1] }"}},
             {"scene.toml:21:18: 'bottom_depth_m' must be a finite number, greater than 0, not "
              "-1"}},
        Case{"InAnIopLayer",
             {{23, 23,
               "[[sea.layer]]\nbottom_depth_m = 40\n"
               "cdom_a440_per_m = { depth_m = [20, 90], value = [0, 1] }"}},
             {"scene.toml:26:1: 'cdom_a440_per_m' and 'iop' exclude each other in [[sea.layer]] "
              "(keep one of them)"}},
        Case{"OfWhatIsNoConstituent",
             {{22, 22, "chlorophyll_yield = { depth_m = [0, 20], value = [0.1, 0.2] }"}},
             {"scene.toml:22:21: 'chlorophyll_yield' must be a finite number, at least 0 and at "
              "most 1, not a table"}},
        Case{"TooFine",
             {{19, 19, "[sea]\nprofile_tolerance = 1e-4"},
              {22, 22, "chlorophyll_mg_m3 = { depth_m = [0, 20], value = [0, 1] }"}},
             {"scene.toml:23:21: the layer would be cut into more than 500 with profile_tolerance "
              "= 0.0001 "
              "(profile_tolerance = 0.002 would do)"}},
        chlorophyll(
            "TooLarge", "{ depth_m = [0, 20], value = [1e308, 1.7e308] }",
            {"scene.toml:22:21: the layer would be cut into more than 500 with profile_tolerance = "
             "0.05 (are the units right?)"}),
        Case{"ToleranceOfNothing",
             {{19, 19, "[sea]\nprofile_tolerance = 0"}},
             {"scene.toml:20:21: 'profile_tolerance' must be a finite number, greater than 0 and "
              "at most 1, not 0"}}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace photic::scene
