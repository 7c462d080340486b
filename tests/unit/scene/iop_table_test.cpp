// Tables of inherent optical properties that stand for the layers of a scene.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "unit/scene/written_files.hpp"

namespace photic::scene {
namespace {

/// The base scene with this table for its layers.
std::string tabled(const std::string& table) {
  return edited({{19, 25, "[sea]\niop_table = " + table}});
}

const std::string with_phase = "{ file = 'lib.csv', phase_function = 'petzold' }";
const std::string good_rows =
    "depth_m, wavelength_nm, a_per_m, b_per_m\n"
    "0, 500, 0.05, 0.2\n0, 600, 0.25, 0.15\n10, 500, 0.04, 0.1\n10, 600, 0.24, 0.05\n";

PhaseFunction petzold_by_name() {
  PhaseFunction function;
  function.model = PhaseModel::petzold;
  return function;
}

TEST(IopTable, HasNoBed) {
  WrittenFiles files("iop_bed");
  files.write("lib.csv", good_rows);
  EXPECT_EQ(
      files.problems(tabled(with_phase + "\n[bottom]\nalbedo = 0.1")),
      Texts{"scene.toml:21:1: the sea has no bed: its last layer is bottomless (give the last "
            "[[sea.layer]] its bottom_depth_m (a sea by iop_table has none), or leave "
            "[bottom] out)"});
}

// Seen red: with the end of a layer 1 m below its top.
TEST(IopTable, OfCsvIsAStackOfLayers) {
  WrittenFiles files("iop_csv");
  files.write("lib.csv", good_rows);
  const Scene scene = files.read(tabled(with_phase)).scene;
  ASSERT_EQ(scene.sea.layer.size(), 2U);
  const auto& [top, deep] = std::tie(scene.sea.layer[0], scene.sea.layer[1]);
  EXPECT_EQ(top.name, "layer0");
  EXPECT_EQ(top.bottom_depth_m, 10.0);
  EXPECT_EQ(top.iop, (std::vector<IopEntry>{{500, 0.05, 0.2, 0, {}}, {600, 0.25, 0.15, 0, {}}}));
  EXPECT_EQ(top.phase_function, petzold_by_name());
  EXPECT_FALSE(deep.bottom_depth_m);
  EXPECT_EQ(deep.iop, (std::vector<IopEntry>{{500, 0.04, 0.1, 0, {}}, {600, 0.24, 0.05, 0, {}}}));
  const std::string text = write_scene(scene);
  EXPECT_EQ(text.find("lib.csv"), std::string::npos);
  EXPECT_TRUE(read_scene_text(text, "written.toml", "/elsewhere").scene == scene);
}

// Seen red: with c for b.
TEST(IopTable, OfAttenuationAndBackscattering) {
  WrittenFiles files("iop_c");
  files.write("lib.csv",
              "wavelength_nm, depth_m, c_per_m, a_per_m, bb_per_m, a_phytoplankton_per_m, other\n"
              "500, 0, 0.25, 0.05, 0.004, 0.01, x\n");
  const Scene scene = files.read(tabled("'lib.csv'")).scene;
  ASSERT_EQ(scene.sea.layer.size(), 1U);
  EXPECT_FALSE(scene.sea.layer[0].phase_function);
  EXPECT_EQ(scene.sea.layer[0].iop, (std::vector<IopEntry>{{500, 0.05, 0.2, 0.01, 0.004}}));
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

/// The same as good_rows with a backscattering coefficient.
void write_netcdf_table(WrittenFiles& files) {
  files.write("lib.nc", "");
  const std::vector<std::string> dimensions{"z", "lambda"};
  files.netcdf["depth_m"] = {{"z"}, {2}, "m", {0, 10}};
  files.netcdf["wavelength_nm"] = {{"lambda"}, {2}, "nm", {500, 600}};
  files.netcdf["a_per_m"] = {dimensions, {2, 2}, "m-1", {0.05, 0.25, 0.04, 0.24}};
  files.netcdf["b_per_m"] = {dimensions, {2, 2}, "m-1", {0.2, 0.15, 0.1, 0.05}};
  files.netcdf["bb_per_m"] = {dimensions, {2, 2}, "m-1", {0.004, 0.003, 0.002, 0.001}};
}

TEST(IopTable, OfNetcdf) {
  WrittenFiles files("iop_netcdf");
  write_netcdf_table(files);
  const Scene scene = files.read(tabled("'lib.nc'")).scene;
  ASSERT_EQ(scene.sea.layer.size(), 2U);
  EXPECT_EQ(scene.sea.layer[1].iop,
            (std::vector<IopEntry>{{500, 0.04, 0.1, 0, 0.002}, {600, 0.24, 0.05, 0, 0.001}}));
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

// Seen red: with the numbers as they are.
TEST(IopTable, OfNetcdfHasUnits) {
  WrittenFiles files("iop_units");
  write_netcdf_table(files);
  const Scene expected = files.read(tabled("'lib.nc'")).scene;
  files.netcdf["depth_m"] = {{"z"}, {2}, "m", {0, -10}, "altitude", "up"};
  files.netcdf["wavelength_nm"] = {{"lambda"}, {2}, "um", {0.5, 0.6}};
  files.netcdf["b_per_m"].units = "km-1";
  for (double& b : files.netcdf["b_per_m"].value) b *= 1000;
  const Scene scene = files.read(tabled("'lib.nc'")).scene;
  ASSERT_EQ(scene.sea.layer.size(), 2U);
  EXPECT_EQ(scene.sea.layer[0].bottom_depth_m, 10);
  for (std::size_t w = 0; w < 2; ++w) {
    const IopEntry &found = scene.sea.layer[1].iop[w], &meant = expected.sea.layer[1].iop[w];
    EXPECT_NEAR(found.wavelength_nm, meant.wavelength_nm, 1e-9);
    EXPECT_NEAR(found.b_per_m, meant.b_per_m, 1e-12);
    EXPECT_EQ(found.a_per_m, meant.a_per_m);
  }
  write_netcdf_table(files);
  for (auto& [name, variable] : files.netcdf) variable.units = "";
  EXPECT_TRUE(files.read(tabled("'lib.nc'")).scene == expected);
  files.netcdf["a_per_m"].units = "m2 mg-1";
  EXPECT_EQ(
      files.problems(tabled("'lib.nc'")),
      (Texts{"scene.toml:20:13: lib.nc: a_per_m: is in units of \"m2 mg-1\", not 1/m (units of "
             "1/length are understood, as \"m-1\")"}));
}

TEST(IopTable, OfAnEnvironmentIsAnotherFile) {
  WrittenFiles files("iop_environment");
  files.write("lib.csv", good_rows);
  files.write("other.csv",
              "depth_m, wavelength_nm, a_per_m, b_per_m\n0, 550, 0.1, 0.2\n10, 550, 0.1, 0.1\n");
  files.write("deeper.csv",
              "depth_m, wavelength_nm, a_per_m, b_per_m\n0, 550, 0.1, 0.2\n11, 550, 0.1, 0.1\n");
  const auto with = [](const std::string& file) {
    return tabled(with_phase) + "[[environment]]\nset = { 'sea.iop_table.file' = '" + file +
           "' }\n";
  };
  const Scene scene = files.read(with("other.csv")).scene;
  EXPECT_EQ(scene.environment[0].sea.layer[1].iop[0].wavelength_nm, 550);
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
  EXPECT_EQ(
      files.problems(with("deeper.csv")),
      (Texts{"deeper.csv:3:1: 'bottom_depth_m' must be as in the scene, 10, not 11: light crosses "
             "from layer to layer in the same way in all environments (simulate that in "
             "a scene of its own)"}));
}

/// Whatever stands in the file, there is a scene or a word on what is wrong.
TEST(IopTable, DamagedFiles) {
  WrittenFiles files("iop_damaged");
  std::mt19937_64 random(20240602);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string damaged = good_rows;
    damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    if (i % 5 == 0) damaged.resize(random() % damaged.size());
    files.write("lib.csv", damaged);
    try {
      const Scene scene = files.read(tabled(with_phase)).scene;
      EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_LT(refused, 1000);
}

struct Table {
  const char* name;
  std::string rows;
  Texts expected;
};

class IopTableProblem : public testing::TestWithParam<Table> {};

TEST_P(IopTableProblem, IsReportedAtItsPlace) {
  WrittenFiles files(std::string("iop_") + GetParam().name);
  files.write("lib.csv", GetParam().rows);
  EXPECT_EQ(files.problems(tabled(with_phase)), GetParam().expected);
}

std::string rows(const std::string& lines) {
  return "depth_m, wavelength_nm, a_per_m, b_per_m\n" + lines;
}

INSTANTIATE_TEST_SUITE_P(
    All, IopTableProblem,
    testing::Values(
        Table{"NoAbsorption",
              "depth_m, wavelength_nm, a, b_per_m\n0, 500, 1, 1\n",
              {"lib.csv:1:1: no \"a_per_m\" (did you mean 'a'?)"}},
        Table{"Misspelt",
              "# x\ndepth, wavelength_nm, a_per_m, b_per_m\n0, 500, 1, 1\n",
              {"lib.csv:2:1: no \"depth_m\" (did you mean 'depth'?)"}},
        Table{"NoScattering",
              "depth_m, wavelength_nm, a_per_m\n0, 500, 1\n",
              {"lib.csv:1:1: neither \"b_per_m\" nor \"c_per_m\" (there are, between "
               "commas: depth_m, wavelength_nm, a_per_m)"}},
        Table{"AttenuationBelowAbsorption",
              "depth_m, wavelength_nm, a_per_m, c_per_m\n0, 500, 1, 0.5\n",
              {"lib.csv:2:11: c_per_m, 0.5, is below a_per_m, 1 (c is a + b)"}},
        Table{"Negative",
              rows("0, 500, -1, 0.1\n"),
              {"lib.csv:2:8: 'a_per_m' must be a finite number, at least 0, not -1"}},
        Table{
            "NotANumber",
            rows("0, 500, 1, nan\n"),
            {"lib.csv:2:11: \"nan\" is not a finite number (fill the gap, or leave the row out)"}},
        Table{"NothingAtAll",
              rows("0, 500, 0, 0\n"),
              {"lib.csv:2:8: a_per_m + b_per_m is 0: there is no water without attenuation"}},
        Table{"NotFromTheSurface",
              rows("1, 500, 1, 1\n"),
              {"lib.csv:2:1: the first depth is 1 m, not 0"}},
        Table{"DepthsUnsorted",
              rows("0, 500, 1, 1\n20, 500, 1, 1\n10, 500, 1, 1\n"),
              {"lib.csv:4:1: 10 m comes after 20 m (sort rows by depth, and those of a depth by "
               "wavelength)"}},
        Table{"WavelengthsUnsorted",
              rows("0, 500, 1, 1\n0, 400, 1, 1\n"),
              {"lib.csv:3:3: 400 nm comes after 500 nm (sort rows by depth, and those of a depth "
               "by wavelength)"}},
        Table{"Twice",
              rows("0, 500, 1, 1\n10, 500, 1, 1\n10, 500, 1, 1\n"),
              {"lib.csv:4:4: 500 nm appears twice at 10 m (sort rows by depth, and those of a "
               "depth by wavelength)"}},
        Table{"PairMissing",
              rows("0, 500, 1, 1\n0, 600, 1, 1\n0, 700, 1, 1\n10, 500, 1, 1\n10, 700, 1, 1\n"),
              {"lib.csv:6:4: the row of 10 m and 600 nm is missing (all depths have the same "
               "wavelengths)"}},
        Table{"LastPairOfADepthMissing",
              rows("0, 500, 1, 1\n0, 600, 1, 1\n10, 500, 1, 1\n20, 500, 1, 1\n20, 600, 1, 1\n"),
              {"lib.csv:5:4: the row of 10 m and 600 nm is missing (all depths have the same "
               "wavelengths)"}},
        Table{"LastPairMissing",
              rows("0, 500, 1, 1\n0, 600, 1, 1\n10, 500, 1, 1\n"),
              {"lib.csv:4:4: the row of 10 m and 600 nm is missing (all depths have the same "
               "wavelengths)"}},
        Table{"OtherWavelength",
              rows("0, 500, 1, 1\n10, 400, 1, 1\n"),
              {"lib.csv:3:4: 400 nm at 10 m, and not at 0 m (all depths have the same "
               "wavelengths)"}},
        Table{"OneMoreWavelength",
              rows("0, 500, 1, 1\n10, 500, 1, 1\n10, 600, 1, 1\n"),
              {"lib.csv:4:4: 600 nm at 10 m, and not at 0 m (all depths have the same "
               "wavelengths)"}},
        Table{"FieldMissing",
              rows("0, 500, 1\n"),
              {"lib.csv:2:1: 3 fields where 4 columns are named (separate them by commas, as the "
               "names are)"}},
        Table{"NoRows", rows(""), {"lib.csv:1:1: no table of numbers: no rows of data"}},
        Table{"Backscattering",
              "depth_m, wavelength_nm, a_per_m, b_per_m, bb_per_m\n0, 500, 1, 1, 0.02\n",
              {"scene.toml:20:50: 'phase_function' and the file's bb_per_m exclude each other "
               "(keep one of them)"}}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(IopTable, BackscatteringMustYieldAPhaseFunction) {
  WrittenFiles files("iop_bb");
  files.write("lib.csv",
              "depth_m, wavelength_nm, a_per_m, b_per_m, bb_per_m\n0, 500, 1, 1, 0.6\n"
              "0, 600, 1, 0, 0\n0, 700, 1, 1, 1e-5\n");
  EXPECT_EQ(files.problems(tabled("'lib.csv'")),
            (Texts{"lib.csv:2:14: a backscatter fraction b_b/b of 0.6 is outside 0.0002 to 0.45, "
                   "where it sets the phase function (give a phase_function instead)",
                   "lib.csv:4:14: a backscatter fraction b_b/b of 1e-05 is outside 0.0002 to "
                   "0.45, where it sets the phase function (give a phase_function instead)"}));
}

TEST(IopTable, NeedsAPhaseFunctionFromSomewhere) {
  WrittenFiles files("iop_phase");
  files.write("lib.csv", good_rows);
  EXPECT_EQ(files.problems(tabled("'lib.csv'")),
            (Texts{"scene.toml:20:13: 'phase_function' is missing in 'iop_table', whose file has "
                   "no bb_per_m (write { file = …, phase_function = … })"}));
  EXPECT_EQ(files.problems(tabled("{ file = 'lib.csv', phase_function = 'petzolt' }")),
            (Texts{"scene.toml:20:50: 'model' must be \"henyey-greenstein\", \"fournier-forand\", "
                   "\"petzold\", \"rayleigh\", \"isotropic\", \"table\", \"mie\" or \"mixture\", "
                   "not text \"petzolt\" (did you mean 'petzold'?)"}));
}

TEST(IopTable, StandsForLayersAlone) {
  WrittenFiles files("iop_layers");
  files.write("lib.csv", good_rows);
  EXPECT_EQ(files.problems(edited({{19, 19, "[sea]\niop_table = 'lib.csv'"}})),
            (Texts{"scene.toml:20:1: 'layer' and 'iop_table' exclude each other in [sea] (keep "
                   "one of them)"}));
  EXPECT_EQ(files.problems(tabled("7")),
            (Texts{"scene.toml:20:13: 'iop_table' must be a file or a table, not 7 (write { file = "
                   "…, phase_function = … })"}));
  EXPECT_EQ(files.problems(tabled("'none.csv'")),
            (Texts{"scene.toml:20:13: 'file' names a file that cannot be read: none.csv (a "
                   "relative path starts at the scene file)"}));
  EXPECT_EQ(files.problems(tabled("{ file = 'lib.csv', phase = 'petzold' }")),
            (Texts{"scene.toml:20:33: unknown key 'phase' in 'iop_table' (did you mean "
                   "'phase_function'?)"}));
}

TEST(IopTable, NetcdfProblemsNameVariableAndIndex) {
  WrittenFiles files("iop_netcdf_problems");
  using Variables = std::map<std::string, NetcdfVariable>;
  const auto problems = [&](const auto& damage) {
    write_netcdf_table(files);
    damage(files.netcdf);
    return files.problems(tabled("'lib.nc'"));
  };
  EXPECT_EQ(problems([](Variables& v) { v.erase("b_per_m"); }),
            (Texts{"scene.toml:20:13: lib.nc: neither \"b_per_m\" nor \"c_per_m\" (there are: "
                   "a_per_m, bb_per_m, "
                   "depth_m, wavelength_nm)"}));
  EXPECT_EQ(problems([](Variables& v) {
              v["a_per_m"].value[3] = std::numeric_limits<double>::quiet_NaN();
              v["bb_per_m"].value[2] = -1;
            }),
            (Texts{"scene.toml:20:13: lib.nc: bb_per_m[1, 0]: 'bb_per_m' must be a finite number, "
                   "at least 0, not -1",
                   "scene.toml:20:13: lib.nc: a_per_m[1, 1]: 'a_per_m' must be a finite number, at "
                   "least 0, not "
                   "nan"}));
  EXPECT_EQ(
      problems(
          [](Variables& v) { std::swap(v["a_per_m"].dimension[0], v["a_per_m"].dimension[1]); }),
      (Texts{"scene.toml:20:13: lib.nc: a_per_m(lambda, z): its dimensions must be (z, lambda)"}));
  EXPECT_EQ(problems([](Variables& v) { v["wavelength_nm"].value[1] = 500; }),
            (Texts{"scene.toml:20:13: lib.nc: wavelength_nm[1]: 500 does not come after 500 "
                   "(values ascend, each "
                   "once)"}));
  EXPECT_EQ(problems([](Variables& v) { v["depth_m"].value[0] = 1; }),
            (Texts{"scene.toml:20:13: lib.nc: depth_m[0]: the first depth is 1 m, not 0"}));
  EXPECT_EQ(problems([](Variables& v) {
              v["depth_m"] = {{}, {}, "", {0}};
            }),
            (Texts{"scene.toml:20:13: lib.nc: depth_m(): is not of one dimension with values"}));
  EXPECT_EQ(problems([](Variables& v) {
              v["depth_m"] = {{"z"}, {501}, "", {}};
              for (int i = 0; i < 501; ++i) v["depth_m"].value.push_back(i);
            }),
            (Texts{"scene.toml:20:13: lib.nc: 501 depths with 2 wavelengths are too many: at most "
                   "500 depths, and "
                   "100000 pairs"}));
}

// --- Backscattering in a scene's own layers ------------------------------------------------------

std::string entries(const std::string& iop) { return edited({{24, 25, "iop = [" + iop + "]"}}); }

TEST(Backscattering, SetsThePhaseFunctionOfAnIopLayer) {
  const Scene scene = read_text(
      entries("{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1, bb_per_m = 0.002 }"));
  EXPECT_EQ(scene.sea.layer[1].iop[0].bb_per_m, 0.002);
  EXPECT_TRUE(read_text(write_scene(scene)) == scene);
}

TEST(Backscattering, IsInAllEntriesOrInNone) {
  EXPECT_EQ(diagnostics_of(entries(
                "{ wavelength_nm = 500, a_per_m = 0.06, b_per_m = 0.1, bb_per_m = 0.002 }, { "
                "wavelength_nm = 600, a_per_m = 0.06, b_per_m = 0.1 }")),
            (Texts{"scene.toml:24:82: 'bb_per_m' is in some entries of the iop and not in others "
                   "(give it in all or in none)"}));
}

TEST(Backscattering, ExcludesAPhaseFunction) {
  EXPECT_EQ(diagnostics_of(edited({{24, 24,
                                    "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1, "
                                    "bb_per_m = 0.002 }]"}})),
            (Texts{"scene.toml:25:18: 'bb_per_m' and 'phase_function' exclude each other in "
                   "[[sea.layer]] (keep one of them)"}));
}

}  // namespace
}  // namespace photic::scene
