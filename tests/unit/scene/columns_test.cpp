// Columns of water side by side: how they are read and written, and what is wrong with them.
#include <gtest/gtest.h>

#include "scene/compare.hpp"
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

// Seen red: with columns left out of what is written.
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
  EXPECT_EQ(diagnostics_of(text).size(), 1U);  // the oil is not yet simulated
}

// The layers of a column are those of a sea, cut in the same way. Seen red: with a column's
// profiles left as they are.
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
      {"Bed", {{37, 37, "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = 0.1"}}, {}},
      {"AlbedoOfABed",
       {{37, 37, "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = 1.1"}},
       {"scene.toml:39:10: 'albedo' must be a finite number, at least 0 and at most 1, not 1.1"}},
      {"AnglesOfABed",
       {{37, 37,
         "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = { zenith_deg = [0, 80], "
         "albedo = [0, 0] }"}},
       {"scene.toml:39:29: the angles end at 80 degrees, not at 90 (give the albedo from 0 to 90 "
        "degrees)"}},
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

}  // namespace
}  // namespace photic::scene
