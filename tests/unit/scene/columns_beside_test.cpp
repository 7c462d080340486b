// Columns of water side by side: what cannot do with them, and paths that go through them.
#include <gtest/gtest.h>

#include "unit/scene/lit_scene.hpp"
#include "unit/scene/row_scene.hpp"

namespace photic::scene {
namespace {

// --- What cannot do with them --------------------------------------------------------------------

// Seen red, each for itself: without check_instruments and check_simulation of check_columns.cpp.
TEST(Columns, EveryTextOfWhatCannotDoWithThem) {
  const auto of = [](const std::string& override_text, const std::vector<Edit>& edits = {}) {
    return diagnostics_of(row_text(edits), {override_text, "gates.depth_min_m=1"});
  };
  EXPECT_EQ(of("telescope.0.position_m=[40, 0, -1]"),
            (Texts{"--set telescope.0.position_m: the telescope is at x = 40 m, beside the row of "
                   "columns (move it into a column, or move the end of the row)"}));
  EXPECT_EQ(of("telescope.0.position_m=[39, 0, -1]"), Texts{});
  EXPECT_EQ(of("telescope.0.position_m=[99, 99, 1]"), Texts{});  // in the air
  EXPECT_EQ(of("source.position_m=[0, -60, -1]"),
            (Texts{"--set source.position_m: the source is at y = -60 m, beside the row of columns "
                   "(move it into a column, or move y_min_m or y_max_m)"}));
  EXPECT_EQ(of("source.position_m=[0, -60, -1]", {{20, 20, ""}}), Texts{});
  EXPECT_EQ(
      of("simulation.estimator=bidirectional"),
      (Texts{"--set simulation.estimator: the bidirectional estimator cannot treat columns "
             "of water: five of its seven strategies move a walk and need a sea that is alike "
             "everywhere, and what stays does not converge on peaked water (write estimator "
             "= \"forward\", or take [[sea.layer]] in place of [[sea.column]])"}));
  EXPECT_EQ(of("simulation.estimator=analog"), Texts{});
  EXPECT_EQ(of("atmosphere={ profile = 'us-standard' }"),
            (Texts{"--set atmosphere: air above columns of water is not yet simulated (leave "
                   "[atmosphere] out, or take [[sea.layer]] in place of [[sea.column]])"}));
}

// Seen red: with a row of columns without ends taken for a sea that is alike everywhere; without
// the radiance's own check.
TEST(Columns, AreNotLitByABeamAsWideAsTheWorld) {
  const auto lit = [](const std::string& tally, const std::string& water) {
    return diagnostics_of(lit_scene(sun, tally, water));
  };
  const std::string layer = "[[sea.column.layer]]\nbottom_depth_m = 20\n";
  const std::string one = "[[sea.column]]\n" + layer;
  const std::string two = "[[sea.column]]\nx_max_m = 0\n" + layer + one;
  const std::string beam =
      "scene.toml:3:8: the light of a beam as wide as the world is followed from one place, which "
      "stands for all places only where the sea is alike everywhere (give the beam a position_m, "
      "or take one column without ends)";
  const std::string radiance =
      "[[tally]]\nkind = \"radiance\"\ndepth_m = [1]\n"
      "direction_deg = [[0, 0]]";
  EXPECT_EQ(lit(balance, one), Texts{});
  EXPECT_EQ(lit(balance, two), Texts{beam});
  EXPECT_EQ(lit(balance, "[sea]\ny_max_m = 3\n" + one), Texts{beam});
  EXPECT_EQ(lit(radiance, one), Texts{});
  EXPECT_EQ(lit(radiance, two),
            (Texts{beam,
                   "scene.toml:6:8: a radiance is that of a sea that is alike everywhere, and "
                   "this one has columns (take kind = \"irradiance\", or one column without "
                   "ends)"}));
  EXPECT_EQ(diagnostics_of(lit_scene(lamp,
                                     "[[tally]]\nkind = \"fluence\"\ndepth_m = [0, 1]\n"
                                     "radius_m = [0, 1]",
                                     two)),
            Texts{});
}

// Seen red: with the layers of the first column alone.
TEST(Columns, HaveSlabsThatFitIntoTheLayersOfAll) {
  EXPECT_EQ(
      diagnostics_of(row_text({{19, 19,
                                "[[tally]]\nkind = 'irradiance'\ndepth_m = [2]\n"
                                "slab_m = 6\n[sea]"}})),
      (Texts{"scene.toml:22:10: a slab of 6 m about 2 m is thicker than its layer from 0 to 5 "
             "m (write at most 5)"}));
}

// --- Their paths ---------------------------------------------------------------------------------

Texts in_environment(const std::string& changes) {
  return diagnostics_of(row_scene() + "[[environment]]\nset = { " + changes + " }\n");
}

// Seen red: with compare_columns left out of other_water.cpp.
TEST(Columns, AreWhatEnvironmentsChange) {
  const Scene scene =
      read_text(row_scene() +
                    "[[environment]]\nset = { 'sea.column.plume.layer.layer1.iop.0.a_per_m' = 0.1, "
                    "'sea.column.0.layer.0.chlorophyll_mg_m3' = 0.2 }\n",
                {"sea.column.1.layer.0.name=upper", "sea.column.1.layer.1.name=layer1",
                 "sea.column.plume.layer.upper.minerals_g_m3=7"});
  ASSERT_EQ(scene.environment.size(), 1U);
  const Sea& there = scene.environment[0].sea;
  EXPECT_EQ(scene.sea.column[1].layer[0].minerals_g_m3, 7);
  EXPECT_EQ(there.column[1].layer[1].iop[0].a_per_m, 0.1);
  EXPECT_EQ(there.column[0].layer[0].chlorophyll_mg_m3, 0.2);
  EXPECT_TRUE(read_text(write_scene(scene)) == scene);
  const std::string columns =
      ": light crosses from column to column in the same way in all environments (simulate that in "
      "a scene of its own)";
  EXPECT_EQ(in_environment("'sea.column.0.x_max_m' = 3"),
            (Texts{"scene.toml:44:9: 'x_max_m' must be as in the scene, 2, not 3" + columns}));
  EXPECT_EQ(in_environment("'sea.y_max_m' = 3"),
            (Texts{"scene.toml:44:9: 'y_max_m' must be as in the scene, 50, not 3" + columns}));
  EXPECT_EQ(in_environment("'sea.column.plume.name' = 'front'"),
            (Texts{"scene.toml:44:9: 'name' must be as in the scene, text \"plume\", not text "
                   "\"front\": all "
                   "environments have the same columns (simulate that in a scene of its own)"}));
  EXPECT_EQ(in_environment("'sea.column.plume.layer.0.bottom_depth_m' = 6"),
            (Texts{"scene.toml:44:9: 'bottom_depth_m' must be as in the scene, 5, not 6: light "
                   "crosses from layer to layer in the same way in all environments (simulate that "
                   "in a scene of its own)"}));
  EXPECT_EQ(in_environment("'sea.column.plume.oil' = { class = 'light-refined', thickness_um = 1 }")
                .size(),
            1U);
  EXPECT_EQ(in_environment("'sea.column.front.layer.0.minerals_g_m3' = 6"),
            (Texts{"scene.toml:44:9: nothing in 'column' is called 'front' (its names and numbers: "
                   "0, plume)"}));
}

// A profile cuts the layer above the parameter's. Seen red: with the paths of columns left as they
// are.
TEST(Columns, SensitivitiesFollowTheirLayers) {
  const std::string ramp = "minerals_g_m3 = { depth_m = [0, 5], value = [1, 2] }";
  const auto derive = [&](const std::string& path) {
    std::vector<Edit> edits{{33, 33, ramp}};
    return "sensitivity = ['" + path + "']\n" + row_text(edits);
  };
  const Scene scene = read_text(derive("sea.column.plume.layer.1.iop.0.a_per_m"));
  ASSERT_EQ(scene.sensitivity.size(), 1U);
  EXPECT_EQ(scene.sensitivity[0].value, 0.06);
  EXPECT_EQ(scene.sensitivity[0].path, "sea.column.1.layer." +
                                           std::to_string(scene.sea.column[1].layer.size() - 1) +
                                           ".iop.0.a_per_m");
  EXPECT_EQ(read_text(derive("sea.column.0.layer.0.chlorophyll_mg_m3")).sensitivity[0].value, 0.1);
  EXPECT_EQ(
      diagnostics_of(derive("sea.column.1.layer.0.minerals_g_m3")),
      (Texts{"scene.toml:1:16: 'sea.column.1.layer.0.minerals_g_m3' is in a layer that its "
             "profiles cut into 6: it has no single value for a derivative (compare "
             "environments, or take the derivative in the scene that `photic show` writes)"}));
}

}  // namespace
}  // namespace photic::scene
