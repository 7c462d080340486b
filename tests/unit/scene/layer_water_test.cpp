// Salinity and temperature of layers, as numbers and as profiles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/scene/base_scene.hpp"
#include "unit/scene/written_files.hpp"

namespace photic::scene {
namespace {

/// The base scene with more keys in its first layer, from line 23 on.
std::string with_keys(const std::string& keys) {
  return edited({{22, 22, "chlorophyll_mg_m3 = 0.1\n" + keys}});
}

TEST(LayerWater, IsTheSeasUnlessTheLayerHasItsOwn) {
  const Scene scene = read_text(with_keys("salinity_psu = 30\ntemperature_c = -1.5"));
  EXPECT_EQ(scene.sea.layer[0].salinity_psu, 30);
  EXPECT_EQ(scene.sea.layer[0].temperature_c, -1.5);
  EXPECT_EQ(scene.sea.salinity_psu, 35);
  EXPECT_EQ(base_scene().sea.layer[0].salinity_psu, std::nullopt);
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

// A scene without them is written as it always was: its temperature can still be set for all.
TEST(LayerWater, IsWrittenOnlyWhereItIsGiven) {
  const std::string text = write_scene(base_scene());
  EXPECT_EQ(text.find("temperature_c"), text.rfind("temperature_c")) << text;
}

// 20 C by the default tolerance of 0.05 is 1 C to either side, at any temperature. Seen red: with
// the greatest temperature for the scale, by which 4 to 0 C become 10 layers.
TEST(LayerWater, ProfilesOfTemperatureAreCutByDegrees) {
  for (const double warmest : {4.0, 24.0}) {
    const Scene scene = read_text(with_keys(fmt::format(
        "temperature_c = {{ depth_m = [0, 20], value = [{}, {}] }}", warmest, warmest - 4)));
    ASSERT_EQ(scene.sea.layer.size(), 3U);  // two of 2 C, and the one below
    double column = 0, top = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Layer& layer = scene.sea.layer[i];
      column += *layer.temperature_c * (*layer.bottom_depth_m - top);
      top = *layer.bottom_depth_m;
      EXPECT_EQ(layer.chlorophyll_mg_m3, 0.1);
    }
    EXPECT_NEAR(column, 20 * (warmest - 2), 1e-11);
    EXPECT_EQ(scene.sea.layer[2].temperature_c, std::nullopt);
  }
}

TEST(LayerWater, ProfilesOfSalinityAreCutBy35Psu) {
  const auto layers = [](const char* values) {
    return read_text(with_keys(fmt::format("salinity_psu = {{ depth_m = [0, 20], value = [{}] }}",
                                           values)))
               .sea.layer.size() -
           1;
  };
  EXPECT_EQ(layers("33, 36"), 1U);  // 1.75 PSU to either side
  EXPECT_EQ(layers("0, 3"), 1U);
  EXPECT_EQ(layers("0, 36"), 11U);  // 36 / 3.5, rounded up
}

// Seen red: with means as they are rounded.
TEST(LayerWater, MayBeAtTheEndOfItsRange) {
  const Scene scene = read_text(with_keys(
      "temperature_c = { depth_m = [0, 6.3, 14.9, 17.7, 20], value = [-2, -2, -2, -2, -2] }\n"
      "salinity_psu = { depth_m = [0, 6.4, 16.9, 17.8, 20], value = [45, 45, 45, 45, 45] }"));
  EXPECT_EQ(scene.sea.layer[0].temperature_c, -2);
  EXPECT_EQ(scene.sea.layer[0].salinity_psu, 45);
}

TEST(LayerWater, OfAFloat) {
  WrittenFiles files("float_water");
  files.write("float.nc", "");
  const std::vector<std::string> dimensions{"N_PROF", "N_LEVELS"};
  files.netcdf["PRES"] = {dimensions, {1, 3}, "decibar", {0, 10, 30}};
  files.netcdf["TEMP"] = {dimensions, {1, 3}, "degree_Celsius", {20, 16, 12}};
  files.netcdf["PSAL"] = {dimensions, {1, 3}, "psu", {35, 36, 36}};
  files.netcdf["LATITUDE"] = {{"N_PROF"}, {1}, "degree_north", {30}};
  const auto from = [](const char* variable) {
    return fmt::format("{{ file = 'float.nc', depth = 'PRES', variable = '{}' }}", variable);
  };
  const auto text =
      with_keys(fmt::format("temperature_c = {}\nsalinity_psu = {}", from("TEMP"), from("PSAL")));
  const Scene scene = files.read(text).scene;
  EXPECT_GE(scene.sea.layer.size(), 5U);
  EXPECT_NEAR(*scene.sea.layer[0].temperature_c, 19, 0.1);
  EXPECT_NEAR(*scene.sea.layer[0].salinity_psu, 35.25, 0.03);
  files.netcdf["TEMP"].value[1] = 289;  // kelvin
  EXPECT_EQ(files.problems(text),
            (Texts{"scene.toml:23:26: float.nc: TEMP[0, 1]: must be a finite number, at least "
                   "-2 and at most 45, not 289"}));
}

// --- Environments and sensitivities --------------------------------------------------------------

std::string in_environment(const std::string& keys, const std::string& set) {
  return with_keys(keys) + "[[environment]]\nset = { " + set + " }\n";
}

// It bends nothing, unlike the sea's. Seen red: with the layers' compared as the sea's are.
TEST(LayerWater, MayDifferInAnEnvironment) {
  const std::string colder = R"("sea.layer.0.temperature_c" = 5)";
  for (const char* own : {"", "temperature_c = 10"}) {
    const Scene scene = read_text(in_environment(own, colder));
    EXPECT_EQ(scene.environment[0].sea.layer[0].temperature_c, 5);
    EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
  }
  EXPECT_EQ(diagnostics_of(in_environment("", R"("sea.temperature_c" = 5)")).size(), 1U);
}

// Allowed is what the scale allows. Seen red: with the greatest value in its place.
TEST(LayerWater, OfAnEnvironmentMustSuitTheScenesLayers) {
  const auto reported = [](const char* values) {
    return diagnostics_of(in_environment(
        "temperature_c = { depth_m = [0, 20], value = [4, 0] }",
        fmt::format(R"("sea.layer.0.temperature_c" = {{ depth_m = [0, 20], value = [{}] }})",
                    values)));
  };
  EXPECT_EQ(reported("1, -2"), Texts{});
  EXPECT_EQ(reported("30, 20"),
            (Texts{"scene.toml:33:9: 'temperature_c' departs from its mean by 2.5 between 0 and "
                   "10 m, a layer of the scene; profile_tolerance allows 1 (allow more by "
                   "\"sea.profile_tolerance\" in the environment, or simulate that in a "
                   "scene of its own)"}));
}

TEST(LayerWater, HasDerivatives) {
  const auto deriving = [](const std::string& keys) {
    return "sensitivity = ['sea.layer.0.temperature_c', 'sea.layer.0.salinity_psu']\n" +
           with_keys(keys);
  };
  const Scene scene = read_text(deriving("temperature_c = 10\nsalinity_psu = 33"));
  EXPECT_EQ(scene.sensitivity[0].value, 10);
  EXPECT_EQ(scene.sensitivity[0].above.sea.layer[0].temperature_c, 10.01);
  EXPECT_EQ(scene.sensitivity[1].below.sea.layer[0].salinity_psu, 33 - 0.033);
  const auto problems = diagnostics_of(deriving(""));
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_NE(problems[0].find("there is no 'temperature_c' in 'sea.layer.0'"), std::string::npos)
      << problems[0];
}

// --- What is wrong with it -----------------------------------------------------------------------

class LayerWaterProblem : public testing::TestWithParam<Case> {};

TEST_P(LayerWaterProblem, IsReportedAtItsPlace) {
  EXPECT_EQ(diagnostics_of(edited(GetParam().edits)), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, LayerWaterProblem,
    testing::Values(
        Case{"TooCold",
             {{22, 22, "temperature_c = -3"}},
             {"scene.toml:22:17: 'temperature_c' must be a finite number, at least -2 and at most "
              "45, not -3"}},
        Case{"TooSaltySomewhere",
             {{22, 22, "salinity_psu = { depth_m = [0, 20], value = [30, 50] }"}},
             {"scene.toml:22:50: 'salinity_psu' must be a finite number, at least 0 and at most "
              "45, not 50"}},
        Case{"TooWarmAtItsMaximum",
             {{22, 22,
               "temperature_c = { model = 'gaussian', background = 10, maximum = 60, depth_m = 5, "
               "width_m = 2 }"}},
             {"scene.toml:22:66: 'temperature_c' must be a finite number, at least -2 and at most "
              "45, not 60"}},
        Case{"InAnIopLayer",
             {{23, 23, "[[sea.layer]]\ntemperature_c = 10"}},
             {"scene.toml:25:1: 'temperature_c' and 'iop' exclude each other in [[sea.layer]] "
              "(keep one of them)"}},
        Case{"InAJerlovLayer",
             {{23, 25, "[[sea.layer]]\njerlov = 'II'\nsalinity_psu = 30"}},
             {"scene.toml:25:1: 'jerlov' and 'salinity_psu' exclude each other in [[sea.layer]] "
              "(keep one of them)"}}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace photic::scene
