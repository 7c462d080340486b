// Columns of water side by side: how they are read and written, and what is wrong with them.
#include <gtest/gtest.h>

#include "scene/compare.hpp"
#include "scene/waves.hpp"
#include "unit/scene/lit_scene.hpp"
#include "unit/scene/row_scene.hpp"

namespace photic::scene {
namespace {

Texts layer_names(const Scene& scene) {
  Texts out;
  for (const PlacedLayer& at : layers_of(scene.sea)) out.push_back(at.name);
  return out;
}

Texts layer_paths(const Scene& scene) {
  Texts out;
  for (const PlacedLayer& at : layers_of(scene.sea)) out.push_back(at.path);
  return out;
}

// --- What is read and written --------------------------------------------------------------------

// Seen red: with columns left without names by default; with the names of layers alone.
TEST(Columns, AreReadWithTheirLayers) {
  const Scene scene = read_text(row_scene());
  EXPECT_TRUE(scene.sea.layer.empty());
  ASSERT_EQ(scene.sea.column.size(), 2U);
  EXPECT_EQ(scene.sea.column[0].x_min_m, -1);
  EXPECT_EQ(scene.sea.column[0].x_max_m, 2);
  EXPECT_EQ(scene.sea.column[1].x_min_m, std::nullopt);
  EXPECT_EQ(scene.sea.column[1].x_max_m, 40);
  EXPECT_EQ(scene.sea.y_min_m, -50);
  EXPECT_EQ(scene.sea.y_max_m, 50);
  EXPECT_EQ(layer_names(scene), (Texts{"column0/layer0", "plume/layer0", "plume/layer1"}));
  EXPECT_EQ(layer_paths(scene),
            (Texts{"sea.column.0.layer.0", "sea.column.1.layer.0", "sea.column.1.layer.1"}));
  const auto layers = layers_of(scene.sea);
  EXPECT_EQ(layers[1].top_m, 0);
  EXPECT_EQ(layers[2].top_m, 5);
  EXPECT_EQ(layers[1]->minerals_g_m3, 5);
}

// Seen red: with the layers of a sea without columns called by a column.
TEST(Columns, OfASeaWithoutThemAreItsLayers) {
  const Scene scene = base_scene();
  EXPECT_EQ(layer_names(scene), (Texts{"layer0", "layer1"}));
  EXPECT_EQ(layer_paths(scene), (Texts{"sea.layer.0", "sea.layer.1"}));
  EXPECT_TRUE(scene.sea.is_alike_everywhere());
  EXPECT_FALSE(read_text(row_scene()).sea.is_alike_everywhere());
}

TEST(Columns, MayHaveNoEnds) {
  const Scene scene =
      read_text(row_text({{20, 21, ""}, {23, 23, ""}, {30, 30, ""}, {26, 26, ""}, {35, 35, ""}}));
  EXPECT_EQ(scene.sea.column[0].x_min_m, std::nullopt);
  EXPECT_EQ(scene.sea.column[1].x_max_m, std::nullopt);
  EXPECT_FALSE(scene.sea.ends());
  EXPECT_FALSE(scene.sea.is_alike_everywhere());  // there are two
  Scene one = scene;
  one.sea.column.pop_back();
  one.sea.column.back().x_max_m.reset();
  EXPECT_TRUE(one.sea.is_alike_everywhere());
  one.sea.y_max_m = 3;
  EXPECT_FALSE(one.sea.is_alike_everywhere());
}

// Seen red: with y_min_m left out; with [[sea.layer]] in place of [[sea.column.layer]].
TEST(Columns, AreWrittenAsTheyAre) {
  const Scene scene = read_text(row_scene());
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("\n[[sea.column]]\nname = \"plume\"\nx_max_m = 40.0\n\n[[sea.column.layer]]"
                      "\nname = \"layer0\"\nbottom_depth_m = 5.0\n"),
            std::string::npos)
      << text;
  const Scene again = read_text(text);
  EXPECT_TRUE(again == scene) << text;
  EXPECT_EQ(write_scene(again), text);
  EXPECT_NE(write_scene_json(scene).find("\"column\": ["), std::string::npos);
  Scene other = scene;
  other.sea.column[1].layer[0].minerals_g_m3 = 6;
  EXPECT_EQ(differences(scene, other),
            (std::vector<Difference>{{"sea.column.1.layer.0.minerals_g_m3", "5", "6"}}));
}

// Seen red: with the oil of a column left out of what is written, and with its bed.
TEST(Columns, WriteTheirOilAndBed) {
  Scene scene = read_text(row_scene());
  Oil& oil = scene.sea.column[1].oil.emplace();
  oil.of_class = OilClass::light_refined;
  oil.thickness_um = 2;
  scene.sea.column[1].bottom = Bottom{0.25};
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("oil = { class = \"light-refined\", thickness_um = 2.0"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\n[sea.column.bottom]\nalbedo = 0.25\n"), std::string::npos) << text;
  EXPECT_EQ(diagnostics_of(text).size(), 2U);  // both are not yet simulated, and nothing else
}

// The layers of a column are those of a sea, cut in the same way. Seen red: with a column's
// profiles left as they are; with the cuts of the first column for the second.
TEST(Columns, HaveProfilesAsLayersHave) {
  const std::string ramp = "chlorophyll_mg_m3 = { depth_m = [0, 5, 20], value = [0.2, 1.0, 0.1] }";
  const Scene sea = read_text(edited({{22, 22, ramp}, {23, 25, ""}}));
  const Scene row = read_text(row_text({{27, 27, ramp}}));
  EXPECT_GT(sea.sea.layer.size(), 5U);
  EXPECT_EQ(row.sea.column[0].layer, sea.sea.layer);
  EXPECT_EQ(row.sea.column[1].layer.size(), 2U);
  const Scene second = read_text(row_text({{33, 33,
                                            "minerals_g_m3 = { depth_m = [0, 5], value = "
                                            "[1, 2] }"}}));
  EXPECT_EQ(second.sea.column[0].layer.size(), 1U);
  ASSERT_GT(second.sea.column[1].layer.size(), 4U);
  EXPECT_EQ(second.sea.column[1].layer[1].name, "layer0.1");
  EXPECT_EQ(second.sea.column[1].layer.back().name, "layer1");
}

// --- What is wrong with them ---------------------------------------------------------------------

struct RowCase {
  const char* name;
  std::vector<Edit> edits;
  std::vector<std::string> expected;
};

const std::vector<RowCase>& wrong_rows() {
  static const std::vector<RowCase> cases{
      {"AsItIs", {}, {}},
      {"Overlap",
       {{30, 30, "x_min_m = 1.5"}},
       {"scene.toml:30:11: the column begins at x = 1.5 m and overlaps the one before it, which "
        "ends at 2 m (leave x_min_m out: it is for the first column)"}},
      {"Gap",
       {{30, 30, "x_min_m = 3"}},
       {"scene.toml:30:11: there is a gap in the row of columns from x = 2 to 3 m (leave x_min_m "
        "out: it is for the first column)"}},
      {"BeginOfTheSecond",
       {{30, 30, "x_min_m = 2"}},
       {"scene.toml:30:11: a column begins where the one before it ends (leave x_min_m out: it is "
        "for the first column)"}},
      {"Descending",
       {{30, 30, "x_max_m = 2"}},
       {"scene.toml:30:11: the column ends at x = 2 m, not beyond 2 m, where it begins (list "
        "columns in ascending x)"}},
      {"EndsBeforeItBegins",
       {{24, 24, "x_max_m = -1"}},
       {"scene.toml:24:11: the column ends at x = -1 m, not beyond -1 m, where it begins (list "
        "columns in ascending x)"}},
      {"NoEnd",
       {{24, 24, ""}},
       {"scene.toml:22:1: 'x_max_m' is missing in [[sea.column]] (only the last column may have no "
        "end)"}},
      {"NoWidth",
       {{21, 21, "y_max_m = -50"}},
       {"scene.toml:21:11: the columns end at y = -50 m, not beyond -50 m, where they begin "
        "(y_max_m must be greater than y_min_m)"}},
      {"UnequalBeds",
       {{35, 35, "bottom_depth_m = 21"}},
       {"scene.toml:35:18: the column ends at 21 m, and the first one ends at 20 m: a stair of "
        "beds is no slope (end all columns at the same depth, or none of them)"}},
      {"BedOfOne",
       {{35, 35, ""}},
       {"scene.toml:34:1: the column is bottomless, and the first one ends at 20 m: a stair of "
        "beds is no slope (end all columns at the same depth, or none of them)"}},
      {"BesideLayers",
       {{19, 19, "[sea]\nlayer = [{}]"}},
       {"scene.toml:23:7: 'layer' and 'column' exclude each other in [sea] (keep one of them)"}},
      {"BesideATable",
       {{20, 20, "iop_table = 'water.csv'"}},
       {"scene.toml:20:1: 'column' and 'iop_table' exclude each other in [sea] (keep one of "
        "them)"}},
      {"Surface",
       {{30, 30, "surface = { model = 'flat' }"}},
       {"scene.toml:30:1: unknown key 'surface' in [[sea.column]] (it belongs in [sea])"}},
      {"EndsWithoutColumns",
       {{22, 37, "[[sea.layer]]"}},
       {"scene.toml:20:11: 'y_min_m' belongs to [[sea.column]], of which there is none (add one, "
        "or "
        "leave 'y_min_m' out)",
        "scene.toml:21:11: 'y_max_m' belongs to [[sea.column]], of which there is none (add one, "
        "or "
        "leave 'y_max_m' out)"}},
      {"NoLayers",
       {{25, 27, ""}},
       {"scene.toml:42:1: [[sea.column.layer]] is missing (add it: its layers of water from the "
        "surface down)"}},
      {"NameTwice",
       {{23, 23, "name = 'plume'"}},
       {"scene.toml:29:8: two of [[sea.column]] are called \"plume\" (give each its own name)"}},
      {"NameOfALayerTwice",
       {{32, 32, "bottom_depth_m = 5\nname = 'layer1'"}},
       {"scene.toml:35:1: two of [[sea.column.layer]] are called \"layer1\" (give each its own "
        "name)"}},
      {"Stroke",
       {{29, 29, "name = 'a/b'"}},
       {"scene.toml:29:8: the name of a column may not have a '/' (it stands between column and "
        "layer in results: take another letter)"}},
      {"DepthsOfLayers",
       {{32, 32, "bottom_depth_m = 30"}},
       {"scene.toml:35:18: the layer ends at 20 m, not below the one above it, which ends at 30 m "
        "(layers go from the surface down)"}},
      {"MissingDepth",
       {{32, 32, ""}},
       {"scene.toml:31:1: 'bottom_depth_m' is missing in [[sea.column.layer]] (only the last layer "
        "may be bottomless)"}},
      {"PhaseFunction",
       {{37, 37, ""}},
       {"scene.toml:34:1: 'phase_function' is missing in [[sea.column.layer]] (add it: the phase "
        "function of all scattering, water's included)"}},
      {"Oil",
       {{30, 30, "oil = { class = 'light-refined', thickness_um = 1 }"}},
       {"scene.toml:30:7: a film of oil on one column is not yet simulated (leave it out, or give "
        "all columns the film: [oil])"}},
      {"Bed",
       {{37, 37, "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = 0.1"}},
       {"scene.toml:38:1: a sea bed of one column is not yet simulated (leave it out, or give all "
        "columns the bed: [bottom])"}},
      {"OilOnAllAndOne",
       {{22, 22, "[oil]\nclass = 'light-refined'\nthickness_um = 1\n[[sea.column]]"},
        {30, 30, "oil = { class = 'light-refined', thickness_um = 1 }"}},
       {"scene.toml:33:7: [oil] is a film on all columns, and this is one on one of them (keep one "
        "of them)"}},
      {"BedOfAllAndOne",
       {{37, 37,
         "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = 0.1\n[bottom]\nalbedo = 0"}},
       {"scene.toml:38:1: [bottom] is the bed of all columns, and this is that of one (keep one of "
        "them)"}},
      {"BedOfBottomlessColumns",
       {{26, 26, ""},
        {35, 35, ""},
        {37, 37, "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = 0.1"}},
       {"scene.toml:38:1: the sea has no bed: its last layer is bottomless (give the last "
        "[[sea.column.layer]] its bottom_depth_m, or leave [sea.column.bottom] out)"}},
      {"OilWithoutLifetime",
       {{30, 30,
         "oil = { file = { wavelength_nm = [300, 900], n = [1, 1], a_per_m = [1, 1], "
         "emission_per_nm = [0, 1] }, thickness_um = 1, yield = 1 }"}},
       {"scene.toml:30:7: 'lifetime_ns' is missing in 'oil' (add it, there or in 'file')"}},
  };
  return cases;
}

// Seen red, each for itself: without the call of check_faces, check_width, check_depths and
// check_names of check_columns.cpp, of refuse_not_yet, and of the check of [oil] and [bottom]
// beside a column's.
TEST(Columns, EveryTextOfWhatIsWrongWithTheRow) {
  for (const RowCase& c : wrong_rows()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(row_text(c.edits)), c.expected);
  }
}

// --- What cannot do with them --------------------------------------------------------------------

// Seen red, each for itself: without check_instruments and check_simulation of check_columns.cpp,
// and without the radiance's own check; with the water of all piles open at their ends.
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

// Seen red: with a row of columns without ends taken for a sea that is alike everywhere.
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
// are; with the layers of the first column for those of a column called by its default name.
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
