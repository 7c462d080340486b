// Sensitivities: the parameters with respect to which echoes are derived.
#include <gtest/gtest.h>

#include <sstream>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

/// A scene with this key above it: the first path stands in line 1, column 16.
std::string deriving(const std::string& paths, const std::string& scene = edited({})) {
  std::string text = "sensitivity = [";
  text += paths;
  text += "]\n";
  return text += scene;
}

// Seen red, each for itself: with the steps the other way round; with steps ten times as large;
// with the step upwards only.
TEST(Sensitivity, IsAValueAndTheWaterAStepToEitherSide) {
  const Scene scene =
      read_text(deriving(R"("sea.layer.0.chlorophyll_mg_m3", "sea.layer.1.phase_function.g")"));
  ASSERT_EQ(scene.sensitivity.size(), 2U);
  EXPECT_EQ(scene.sensitivity[0].path, "sea.layer.0.chlorophyll_mg_m3");
  EXPECT_EQ(scene.sensitivity[0].value, 0.1);
  EXPECT_DOUBLE_EQ(scene.sensitivity[0].step, 1e-4);
  const Scene base = base_scene();
  for (const auto& [water, chlorophyll] : {std::pair{scene.sensitivity[0].below, 0.1 - 1e-4},
                                           std::pair{scene.sensitivity[0].above, 0.1 + 1e-4}}) {
    Sea sea = base.sea;
    EXPECT_DOUBLE_EQ(water.sea.layer.at(0).chlorophyll_mg_m3, chlorophyll);
    sea.layer[0].chlorophyll_mg_m3 = water.sea.layer[0].chlorophyll_mg_m3;
    EXPECT_EQ(water.sea, sea);
    EXPECT_EQ(water.optics, base.optics);
    EXPECT_EQ(water.name.rfind("sea.layer.0.chlorophyll_mg_m3 = 0.", 0), 0U);
    EXPECT_EQ(water.set.at(0).path, "sea.layer.0.chlorophyll_mg_m3");
  }
  EXPECT_EQ(scene.sensitivity[1].value, 0.9);
  EXPECT_DOUBLE_EQ(scene.sensitivity[1].above.sea.layer.at(1).phase_function->g, 0.9009);
  EXPECT_EQ(scene.sea, base.sea);
  EXPECT_TRUE(scene.has_environments());
  EXPECT_FALSE(base.has_environments());
}

// Seen red, each for itself: with steps in the file's own text, which has no defaults; with steps
// that have the value's sign.
TEST(Sensitivity, OfDefaultsNamesAndNegativeNumbers) {
  const Scene scene =
      read_text(deriving("'sea.layer.top.cdom_slope_per_nm', 'optics.water_depolarisation', "
                         "'sea.layer.1.phase_function.junge_slope', 'sea.layer.2.phase_function.g'",
                         edited({{20, 20, "[[sea.layer]]\nname = \"top\"\ncdom_a440_per_m = 0.1"},
                                 {24, 25,
                                  R"(bottom_depth_m = 30
iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]
phase_function = "mie"
[[sea.layer]]
iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]
phase_function = { model = "henyey-greenstein", g = -0.2 })"}})));
  ASSERT_EQ(scene.sensitivity.size(), 4U);
  EXPECT_EQ(scene.sensitivity[0].value, 0.017);
  EXPECT_DOUBLE_EQ(scene.sensitivity[0].below.sea.layer[0].cdom_slope_per_nm, 0.016983);
  EXPECT_EQ(scene.sensitivity[1].value, 0.039);
  EXPECT_DOUBLE_EQ(scene.sensitivity[1].above.optics.water_depolarisation, 0.039039);
  EXPECT_EQ(scene.sensitivity[2].value, 5.0);
  EXPECT_DOUBLE_EQ(scene.sensitivity[2].above.sea.layer[1].phase_function->particles.junge_slope,
                   5.005);
  EXPECT_EQ(scene.sensitivity[3].value, -0.2);
  EXPECT_DOUBLE_EQ(scene.sensitivity[3].step, 2e-4);
  EXPECT_DOUBLE_EQ(scene.sensitivity[3].below.sea.layer[2].phase_function->g, -0.2002);
}

// Seen red: with the values in place of the paths.
TEST(Sensitivity, IsWrittenAsItWasReadAndReadsBack) {
  EXPECT_EQ(write_scene(base_scene()).find("sensitivity"), std::string::npos);
  const Scene scene =
      read_text(deriving(R"("sea.layer.0.chlorophyll_mg_m3")") + "[[environment]]\nset = {}\n",
                {"sensitivity=['sea.layer.layer1.phase_function.g', "
                 "'sea.layer.0.chlorophyll_mg_m3']",
                 "sensitivity.1=sea.layer.0.chlorophyll_yield"});
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("\nsensitivity = [\"sea.layer.layer1.phase_function.g\", "
                      "\"sea.layer.0.chlorophyll_yield\"]\n"),
            std::string::npos)
      << text;
  EXPECT_TRUE(read_text(text) == scene);
  EXPECT_EQ(read_text(text).sensitivity[1].value, 0.01);
  EXPECT_TRUE(scene_in(scene, scene.environment[0]).sensitivity.empty());
}

// Seen red, each for itself: with any path allowed; zeros allowed; all reported at the array.
TEST(Sensitivity, EveryTextOfWhatIsWrong) {
  const std::string only_water =
      ": only the water, the bed, a film of oil and the air may differ, since the histories are "
      "the same "
      "(name "
      "paths that "
      "begin with "
      "sea., optics., bottom., oil. or atmosphere.)";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"'gates.depth_max_m'",
       "there is no derivative with respect to 'gates.depth_max_m'" + only_water},
      {"'sea'", "there is no derivative with respect to 'sea'" + only_water},
      {"''", "there is no derivative with respect to ''" + only_water},
      {"5", "'sensitivity' must hold paths, not 5 (write \"sea.layer.0.chlorophyll_mg_m3\")"},
      {"'sea.layer.0.chlorophyl_mg_m3'",
       "there is no 'chlorophyl_mg_m3' in 'sea.layer.0' (did you mean 'chlorophyll_mg_m3'?)"},
      {"'sea.layer.1.chlorophyll_mg_m3'",
       "there is no 'chlorophyll_mg_m3' in 'sea.layer.1' (known there: name, iop, phase_function, "
       "chlorophyll_yield)"},
      {"'sea.refractive_index'",
       "there is no 'refractive_index' in 'sea' (known there: salinity_psu, temperature_c, "
       "surface, layer)"},
      {"'optics.x.y'",
       "there is no 'x' in 'optics' (known there: set, water_absorption, water_scattering, "
       "water_depolarisation, phytoplankton, phytoplankton_phase, minerals, "
       "minerals_a_443_m2_per_g, minerals_a_slope_per_nm, minerals_b_555_m2_per_g, "
       "minerals_b_exponent, minerals_phase, raman, emission, chlorophyll_share_730, "
       "cdom_fluorescence, chlorophyll_lifetime_ns, cdom_lifetime_ns)"},
      {"'sea..layer'",
       "there is an empty name in the path (write names and numbers with dots between)"},
      {"'sea.layer.top.chlorophyll_mg_m3'",
       "nothing in 'layer' is called 'top' (its names and numbers: layer0, layer1)"},
      {"'sea.layer.2.chlorophyll_mg_m3'",
       "there is no element 2 in 'layer' (it has 2, counted from 0)"},
      {"'sea.salinity_psu.x'", "'salinity_psu' is 35: there is no 'x' in it"},
      {"'sea.layer.0.name'",
       "'sea.layer.0.name' is text \"layer0\", not a number (name the path of a number)"},
      {"'sea.layer.1.iop'",
       "'sea.layer.1.iop' is an array of 1, not a number (name the path of a number)"},
      {"'sea.surface'", "'sea.surface' is a table, not a number (name the path of a number)"},
      {"'sea.layer.0.cdom_a440_per_m'",
       "'sea.layer.0.cdom_a440_per_m' is 0: the derivative may be infinite there, and no step is "
       "small relative to it (give it a small value instead)"},
      {"'sea.layer.0.bottom_depth_m'",
       "no step of 'sea.layer.0.bottom_depth_m' to 19.98 can be made: 'bottom_depth_m' must be as "
       "in the scene, 20, not 19.98: light crosses from layer to layer in the same way in all "
       "environments "
       "(simulate that in a scene of its own)"},
      {"'sea.salinity_psu'",
       "no step of 'sea.salinity_psu' to 34.965 can be made: 'salinity_psu' must be as in the "
       "scene, 35, not 34.965: it bends and times the light, whose histories are the same in all "
       "environments (simulate that in a scene of its own)"},
  };
  for (const auto& [path, text] : cases) {
    EXPECT_EQ(diagnostics_of(deriving(path)), (Texts{"scene.toml:1:16: " + text})) << path;
    // Each at its own place.
    EXPECT_EQ(diagnostics_of(deriving("'sea.layer.0.chlorophyll_mg_m3',\n  " + path)),
              (Texts{"scene.toml:2:3: " + text}))
        << path;
  }
  EXPECT_EQ(diagnostics_of("sensitivity = 'sea.salinity_psu'\n" + edited({})),
            (Texts{"scene.toml:1:15: 'sensitivity' must be an array of paths, not text "
                   "\"sea.salinity_psu\" (write [\"sea.layer.0.chlorophyll_mg_m3\"])"}));
  EXPECT_EQ(diagnostics_of(edited({}), {"sensitivity=['sea.x']"}),
            (Texts{"--set sensitivity: there is no 'x' in 'sea' (known there: salinity_psu, "
                   "temperature_c, surface, layer)"}));
}

// Seen red: with paths compared as they stand.
TEST(Sensitivity, StepsBeyondARangeAndPathsTwice) {
  EXPECT_EQ(
      diagnostics_of(deriving("'sea.layer.1.phase_function.g'",
                              edited({{25, 25,
                                       "phase_function = { model = \"henyey-greenstein\", g = "
                                       "0.9995 }"}}))),
      (Texts{"scene.toml:1:16: no step of 'sea.layer.1.phase_function.g' to 1.0005 can be "
             "made: 'g' must be a finite number, at least -0.4 and less than 1, not "
             "1.0004995"}));
  EXPECT_EQ(
      diagnostics_of(deriving("'sea.layer.1.phase_function.g'",
                              edited({{25, 25,
                                       "phase_function = { model = \"henyey-greenstein\", g = "
                                       "-0.4 }"}}))),
      (Texts{"scene.toml:1:16: no step of 'sea.layer.1.phase_function.g' to -0.4004 can be "
             "made: 'g' must be a finite number, at least -0.4 and less than 1, not "
             "-0.40040000000000003"}));
  EXPECT_EQ(diagnostics_of(
                deriving("'sea.layer.0.chlorophyll_mg_m3', 'sea.layer.layer0.chlorophyll_mg_m3'")),
            (Texts{"scene.toml:1:49: 'sea.layer.layer0.chlorophyll_mg_m3' appears twice (name "
                   "each path once)"}));
}

/// Stands for the optics.
void find_green_fault(const Scene& scene, Findings& findings, Asked) {
  if (scene.sea.layer[0].chlorophyll_mg_m3 > 0.10005)
    findings.add("source.wavelength_nm", "too green", "another laser");
  findings.remark("sea.layer.0", "true of every water");
}

// Seen red, each for itself: with the optics not asked; steps made though the laser is wrong; paths
// followed though the water is.
TEST(Sensitivity, IsReportedWithAllElse) {
  EXPECT_EQ(diagnostics_of(deriving("'sea.layer.0.chlorophyll_mg_m3'"), {}, find_green_fault),
            (Texts{"scene.toml:1:16: no step of 'sea.layer.0.chlorophyll_mg_m3' to 0.1001 can be "
                   "made: too green (another laser)"}));
  const std::string wrong = edited({{6, 6, "diameter_m = -1"}});
  EXPECT_EQ(
      diagnostics_of(
          deriving("'sea.layer.1.phase_function.k', 'sea.layer.0.chlorophyll_mg_m3'", wrong) +
          "[[environment]]\nset = { 'sea.x' = 1 }\n"),
      (Texts{"scene.toml:1:16: there is no 'k' in 'sea.layer.1.phase_function' (known there: "
             "model, g)",
             "scene.toml:7:14: 'diameter_m' must be a finite number, greater than 0, not -1",
             "scene.toml:33:9: unknown key 'x' in [sea] (known here: salinity_psu, "
             "temperature_c, refractive_index, group_index, surface, layer, column, iop_table, "
             "y_min_m, y_max_m, "
             "profile_tolerance)"}));
  EXPECT_EQ(diagnostics_of(deriving("'sea.layer.0.chlorophyll_mg_m3', 5",
                                    edited({{22, 22, "chlorophyll_mg_m3 = -1"}}))),
            (Texts{"scene.toml:1:49: 'sensitivity' must hold paths, not 5 (write "
                   "\"sea.layer.0.chlorophyll_mg_m3\")",
                   "scene.toml:23:21: 'chlorophyll_mg_m3' must be a finite number, at least 0, not "
                   "-1"}));
}

TEST(Sensitivity, TakesMemory) {
  std::ostringstream paths;
  std::ostringstream entries;
  for (int i = 0; i < 620; ++i) {
    paths << "'sea.layer.1.iop." << i << ".a_per_m', ";
    entries << "{ wavelength_nm = " << 500 + 0.1 * i << ", a_per_m = 0.06, b_per_m = 0.1 }, ";
  }
  const std::string scene =
      edited({{17, 17, "process = \"elastic\"\n[[channel]]\nname = \"r\"\nprocess = \"raman\""},
              {24, 24, "iop = [" + entries.str() + "]"},
              {27, 28, "depth_max_m = 41\ndepth_step_m = 0.01"}});
  EXPECT_EQ(
      diagnostics_of(deriving(paths.str(), scene)),
      (Texts{"scene.toml:1:15: the tallies (telescopes 1, channels 2, gates 4100, orders 6, "
             "cells of depth 100, parameters 620) would take 2.41 GiB; the limit is 2 GiB (take "
             "fewer parameters, or fewer gates)"}));
}

}  // namespace
}  // namespace photic::scene
