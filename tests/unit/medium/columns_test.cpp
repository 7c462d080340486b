// Columns of water side by side as layers of a medium, one column after the other.
#include <limits>

#include "medium/optical_table.hpp"
#include "unit/medium/checked_scenes.hpp"
#include "unit/scene/row_scene.hpp"

namespace photic::medium {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The layers of the base scene in one column, and all else as it is.
std::string in_one_column() {
  std::string text =
      edited({{20, 20, "[[sea.column]]\n[[sea.column.layer]]"}, {23, 23, "[[sea.column.layer]]"}});
  return text;
}

std::vector<std::string> lines_of(const std::vector<Source>& sources) {
  std::vector<std::string> out;
  for (const Source& source : sources) out.push_back(source_line(source));
  return out;
}

void expect_equal_tables(const Medium& a, const Medium& b) {
  EXPECT_EQ(a.top, b.top);
  EXPECT_EQ(a.c, b.c);
  EXPECT_EQ(a.albedo, b.albedo);
  EXPECT_EQ(a.conversion, b.conversion);
  EXPECT_EQ(a.absorption, b.absorption);
  EXPECT_EQ(a.elastic_phase, b.elastic_phase);
  EXPECT_EQ(a.conversion_phase, b.conversion_phase);
  EXPECT_EQ(a.phase_count(), b.phase_count());
  EXPECT_EQ(a.bed_albedo, b.bed_albedo);
  EXPECT_EQ(a.absorbers.constituent, b.absorbers.constituent);
  EXPECT_EQ(a.absorbers.share, b.absorbers.share);
  EXPECT_EQ(lines_of(a.sources), lines_of(b.sources));
  EXPECT_EQ(a.environments.excess_c, b.environments.excess_c);
  EXPECT_EQ(a.environments.excess_part, b.environments.excess_part);
}

/// All light, and water that differs in an environment.
const std::vector<scene::Override> all_light{
    "channel=[{ name = 'e', process = 'elastic' }, { name = 'c', process = 'chlorophyll' }]",
    "sea.%1.iop=[{ wavelength_nm = 400, a_per_m = 0.06, b_per_m = 0.1 }, { wavelength_nm = 900, "
    "a_per_m = 0.3, b_per_m = 0.2 }]",
    "environment=[{ set = { 'sea.%0.chlorophyll_mg_m3' = 0.2 } }]"};

/// The same, of layers at a path.
std::vector<scene::Override> all_light_in(const std::string& path) {
  std::vector<scene::Override> out = all_light;
  for (std::string& text : out)
    if (const auto at = text.find('%'); at != std::string::npos) text.replace(at, 1, path + '.');
  return out;
}

// To the last bit. Seen red: with the names of layers without their column; with lower edges in
// `top`.
TEST(Columns, OneIsTheSeaWithoutThem) {
  const Medium sea = medium_of(scene::read_text(edited({}), all_light_in("layer")));
  const Medium one = medium_of(scene::read_text(in_one_column(), all_light_in("column.0.layer")));
  ASSERT_GT(sea.line.size(), 1U);
  ASSERT_EQ(sea.environments.count, 1);
  expect_equal_tables(sea, one);
  EXPECT_EQ(one.row.first_layer, std::vector<std::int32_t>{0});
  EXPECT_EQ(one.row.face_m, sea.row.face_m);
  EXPECT_EQ(sea.absorbers.layer, (Texts{"layer0", "layer1"}));
  EXPECT_EQ(one.absorbers.layer, (Texts{"column0/layer0", "column0/layer1"}));
}

// Seen red: with a face for each column alone; with lower edges in `top`.
TEST(Columns, FollowEachOtherInEveryTable) {
  const Medium row = medium_of(scene::read_text(scene::row_scene()));
  EXPECT_EQ(row.row.columns(), 2);
  EXPECT_EQ(row.row.first_layer, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(row.row.face_m, (std::vector<double>{-1, 2, 40}));
  EXPECT_EQ(row.row.y_min_m, -50);
  EXPECT_EQ(row.row.y_max_m, 50);
  EXPECT_EQ(row.top, (std::vector<double>{0, 0, 5, 20}));
  EXPECT_EQ(row.layers(), 3);
  EXPECT_EQ(row.absorbers.layer, (Texts{"column0/layer0", "plume/layer0", "plume/layer1"}));
  const auto alone = [](const std::string& layers) {
    return medium_of(scene::read_text(edited({{20, 25, layers}})));
  };
  const Medium clear = alone("[[sea.layer]]\nchlorophyll_mg_m3 = 0.1");
  const Medium turbid = alone("[[sea.layer]]\nminerals_g_m3 = 5");
  EXPECT_EQ(row.c, (std::vector<double>{clear.c[0], turbid.c[0], 0.06 + 0.1}));
  EXPECT_EQ(row.albedo[1], turbid.albedo[0]);
}

TEST(Columns, MayHaveNoEndsAndNoBed) {
  const Medium row = medium_of(scene::read_text(
      scene::row_text({{20, 21, ""}, {23, 23, ""}, {26, 26, ""}, {30, 30, ""}, {35, 35, ""}})));
  EXPECT_EQ(row.row.face_m, (std::vector<double>{-infinity, 2, infinity}));
  EXPECT_EQ(row.row.y_min_m, -infinity);
  EXPECT_EQ(row.row.y_max_m, infinity);
  EXPECT_EQ(row.top.back(), infinity);
}

// Seen red: with one layer of each column counted in `first_layer`.
TEST(Columns, HaveProfiles) {
  const std::string ramp = "chlorophyll_mg_m3 = { depth_m = [0, 20], value = [0.2, 1.0] }";
  const Medium sea = medium_of(scene::read_text(edited({{22, 22, ramp}, {23, 25, ""}})));
  const Medium row = medium_of(scene::read_text(scene::row_text({{27, 27, ramp}})));
  const auto cut = static_cast<std::size_t>(sea.layers());
  ASSERT_GT(cut, 5U);
  ASSERT_EQ(row.c.size(), cut + 2);
  EXPECT_EQ((std::vector<double>{row.c.begin(), row.c.end() - 2}), sea.c);
  EXPECT_EQ((std::vector<double>{row.top.begin(), row.top.end() - 3}),
            (std::vector<double>{sea.top.begin(), sea.top.end() - 1}));
  EXPECT_EQ(row.row.first_layer[1], sea.layers());
}

// Seen red: with layers called by their own names; with the upper edges one after the other.
TEST(Columns, AreInTheTableOfOptics) {
  const OpticalTable table = optical_table(scene::read_text(scene::row_scene()), library(), {532});
  EXPECT_TRUE(table.in_columns);
  EXPECT_EQ(table.layer_name, (Texts{"column0/layer0", "plume/layer0", "plume/layer1"}));
  EXPECT_EQ(table.first_m, (std::vector<double>{0, 0, 5}));
  EXPECT_EQ(table.last_m, (std::vector<double>{20, 5, 20}));
  EXPECT_EQ(table.a_per_m[2], 0.06);
}

// Seen red: with the name of the layer alone, in each of the two texts.
TEST(Columns, AreNamedInWhatTheOpticsRefuse) {
  EXPECT_EQ(
      scene::diagnostics_of(scene::row_text(), {"source.wavelength_nm=550"}, check),
      (Texts{"scene.toml:36:7: the iop of layer \"plume/layer1\" covers 531 to 533 nm, not 550 "
             "nm; the source emits there (add an entry for it)"}));
  const scene::Scene scene = scene::read_text(
      scene::row_scene() +
      "[[environment]]\nset = { 'sea.column.0.layer.0.chlorophyll_mg_m3' = 0.2 }\n");
  scene::Scene dark = scene;
  for (auto* sea : {&dark.sea, &dark.environment[0].sea})
    sea->column[1].layer[1].iop[0].b_per_m = 0;
  dark.environment[0].sea.column[1].layer[1].iop[0].b_per_m = 0.1;
  EXPECT_NE(
      refusal(dark).find("layer \"plume/layer1\" scatters light, but not in the scene itself"),
      std::string::npos)
      << refusal(dark);
}

// Before environments are read they have no columns. Seen red: with the first bed's albedo for all.
TEST(Columns, HaveBedsOfTheirOwn) {
  const auto row = [](const std::string& albedo, const std::string& changes) {
    return scene::row_text(
               {{37, 37,
                 "phase_function = 'isotropic'\n[sea.column.bottom]\nalbedo = " + albedo}}) +
           "[[environment]]\nset = { " + changes + " }\n";
  };
  const std::string half = "'sea.column.plume.bottom.albedo' = 0.25";
  EXPECT_EQ(scene::diagnostics_of(row("0.5", half), {}, check), Texts{});
  const Medium medium = medium_of(scene::read_text(row("0.5", half)));
  EXPECT_EQ(medium.bed_albedo, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(medium.environments.excess_bed, (std::vector<double>{0, -0.25}));
  EXPECT_EQ(
      scene::diagnostics_of(row("0", half), {}, check),
      (Texts{"scene.toml:46:9: in environment \"environment0\": the sea bed reflects light of 532 "
             "nm and a zenith angle of 0 degrees, but not in the scene itself (no history of "
             "the scene goes that way: give its bed a little albedo, too)"}));
}

}  // namespace
}  // namespace photic::medium
