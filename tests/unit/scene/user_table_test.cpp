// Tables of numbers that users give: a file's become those of the scene, which needs it no more.
#include "scene/user_table.hpp"

#include <fmt/format.h>

#include "scene/compare.hpp"
#include "unit/scene/written_files.hpp"

namespace photic::scene {
namespace {

constexpr const char* angles = "angle_deg,phase_function_per_sr\n";

/// The base scene with the phase function of its second layer, or lines in [optics], or a channel.
std::string phase(const std::string& file) {
  return edited({{25, 25, "phase_function = { model = \"table\", file = " + file + " }"}});
}
std::string optics(const std::string& lines) { return edited({{18, 18, "[optics]\n" + lines}}); }
std::string channel(const std::string& file) {
  return edited({{16, 17, "name = \"f\"\ntransmission_file = " + file}});
}

/// What the scene is, written, and read where there are no files.
Scene elsewhere(const Scene& scene) {
  return read_scene_text(write_scene(scene), "out.nc", "/no/such/folder").scene;
}

class UserTableTest : public testing::Test {
 protected:
  UserTableTest() {
    files_.write("vsf.csv", angles + std::string("0,0.3\n30,0.1\n180,0.02\n"));
    files_.write(
        "algae.csv",
        "wavelength_nm,a_m2_per_mg,b_m2_per_mg\n500,0.1,0.30000000000000004\n600,1e-3,2\n");
    files_.write("eem.csv", "excitation_nm,emission_nm,yield_per_nm\n500,550,1e-5\n500,600,2e-5\n");
    files_.write("filter.csv", "wavelength_nm,transmission,note\n500,0,dark\n540,0.5,\"a, b\"\n");
  }
  WrittenFiles files_{"user_tables"};
};

// Seen red: with numbers of six digits; without the column that may lack.
TEST_F(UserTableTest, AWrittenSceneNeedsNoFile) {
  files_.write("exciting.csv",
               "wavelength_nm,a_m2_per_mg,b_m2_per_mg,a_exciting_m2_per_mg\n500,1,2,0.7\n600,1,2,"
               "0.1\n");
  const std::string mixture =
      "phase_function = { model = \"mixture\", components = [{ fraction = 0.5, model = "
      "\"petzold\" }, { fraction = 0.5, model = \"table\", file = \"vsf.csv\" }] }";
  const std::vector<std::string> texts{
      phase("\"vsf.csv\""),
      edited({{25, 25, mixture}}),
      optics("phytoplankton = \"table\"\nphytoplankton_file = \"algae.csv\""),
      optics("phytoplankton = \"table\"\nphytoplankton_file = \"exciting.csv\""),
      optics("cdom_fluorescence = \"table\"\ncdom_fluorescence_file = \"eem.csv\""),
      channel("\"filter.csv\"")};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const Scene scene = files_.read(text).scene;
    EXPECT_EQ(write_scene(scene).find(".csv"), std::string::npos) << write_scene(scene);
    EXPECT_EQ(write_scene(scene).find("note"), std::string::npos);
    EXPECT_EQ(write_scene(scene).find("a_exciting_m2_per_mg = [0.7, 0.1]") != std::string::npos,
              text.find("exciting.csv") != std::string::npos);
    EXPECT_TRUE(elsewhere(scene) == scene);
    EXPECT_EQ(differences(elsewhere(scene), scene), std::vector<Difference>{});
  }
}

// Seen red: with changes kept that name a file by its whole path.
TEST_F(UserTableTest, NorDoItsEnvironments) {
  for (const std::string& file : {std::string("vsf.csv"), files_.path("vsf.csv")}) {
    const std::string set =
        "[[environment]]\nset = { \"sea.layer.1.phase_function\" = { model = \"table\", file = '" +
        file + "' } }\n";
    const Scene scene = files_.read(edited({}) + set).scene;
    EXPECT_EQ(write_scene(scene).find(".csv"), std::string::npos) << write_scene(scene);
    EXPECT_TRUE(elsewhere(scene) == scene);
    const Scene changed = files_.read(phase("\"vsf.csv\"") + set).scene;
    EXPECT_TRUE(elsewhere(changed) == changed);
  }
}

TEST_F(UserTableTest, ColumnsInTheSceneAreTheSameTable) {
  const Scene of_file = files_.read(phase("\"vsf.csv\"")).scene;
  const Scene of_columns =
      files_.read(phase("{ phase_function_per_sr = [0.3, 0.1, 2e-2], angle_deg = [0, 30.0, 180] }"))
          .scene;
  EXPECT_TRUE(of_file == of_columns);
  EXPECT_EQ(of_columns.sea.layer[1].phase_function->table.data().place(1, "angle_deg"),
            (std::pair{25, 104}));
}

// Seen red: with the numbers compared one by one.
TEST_F(UserTableTest, AnotherTableIsAnotherScene) {
  const Scene before = files_.read(phase("\"vsf.csv\"")).scene;
  files_.write("vsf.csv", angles + std::string("0,0.3\n30,0.1\n180,0.03\n"));
  EXPECT_EQ(differences(before, files_.read(phase("\"vsf.csv\"")).scene),
            (std::vector<Difference>{
                {"sea.layer.1.phase_function.file.phase_function_per_sr.2", "0.02", "0.03"}}));
  std::string many = angles, others = angles;
  for (int k = 0; k < 6; ++k) {
    many += fmt::format("{},0.1\n", 36 * k);
    others += fmt::format("{},0.2\n", 36 * k);
  }
  files_.write("vsf.csv", many);
  const Scene left = files_.read(phase("\"vsf.csv\"")).scene;
  files_.write("vsf.csv", others);
  EXPECT_EQ(differences(left, files_.read(phase("\"vsf.csv\"")).scene),
            (std::vector<Difference>{{"sea.layer.1.phase_function.file.phase_function_per_sr",
                                      "an array of 6", "one with 6 other values"}}));
}

TEST_F(UserTableTest, WhatIsWrongIsReportedAtItsPlace) {
  EXPECT_EQ(files_.problems(phase("7")),
            Texts{"scene.toml:25:44: 'file' must be a file or a table, not 7 (name a CSV file, or "
                  "write { angle_deg = [ … ], … })"});
  EXPECT_EQ(files_.problems(phase("{ angle_deg = [0, 180] }")),
            Texts{"scene.toml:25:44: 'phase_function_per_sr' is missing in 'file' (add it: the "
                  "phase function there, in 1/sr)"});
  EXPECT_EQ(files_.problems(phase("{ angle = [0, 180], phase_function_per_sr = [1] }")),
            (Texts{"scene.toml:25:44: 'angle_deg' is missing in 'file' (add it: scattering angles "
                   "in degrees, ascending to 180)",
                   "scene.toml:25:46: unknown key 'angle' in 'file' (did you mean "
                   "'angle_deg'?)",
                   "scene.toml:25:88: 'phase_function_per_sr' must be two or more finite numbers "
                   "[a, b, …], not [1]"}));
  EXPECT_EQ(files_.problems(phase("{ angle_deg = [0, 9, 180], phase_function_per_sr = [1, nan] }")),
            Texts{"scene.toml:25:95: 'phase_function_per_sr' must be two or more finite numbers "
                  "[a, b, …], not [1, nan]"});
  EXPECT_EQ(files_.problems(phase("{ angle_deg = [0, 9, 180], phase_function_per_sr = [1, 2] }")),
            Texts{"scene.toml:25:44: 'file' has columns of different lengths: angle_deg 3, "
                  "phase_function_per_sr 2 (give one number a row in each)"});
  files_.write("bad.csv", angles + std::string("0,x\n180,1\n"));
  EXPECT_EQ(files_.problems(phase("\"bad.csv\"")),
            Texts{"bad.csv:2:3: \"x\" is not a finite number"});
  files_.write("bad.csv", "angle_deg,vsf\n0,1\n180,1\n");
  EXPECT_EQ(
      files_.problems(phase("\"bad.csv\"")),
      Texts{"bad.csv:1:1: no column \"phase_function_per_sr\" (there are, between "
            "commas: angle_deg, vsf; the scene may name it: { file = …, phase_function = … })"});
}

// Seen red: with every number on the line.
TEST_F(UserTableTest, LongColumnsTakeSeveralLines) {
  std::string rows = angles;
  for (int k = 0; k <= 12; ++k) rows += fmt::format("{},0.1\n", 15 * k);
  files_.write("vsf.csv", rows);
  const std::string text = write_scene(files_.read(phase("\"vsf.csv\"")).scene);
  EXPECT_NE(text.find("phase_function = { model = \"table\", file = { angle_deg = [\n"
                      "    0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0,\n"
                      "    150.0, 165.0, 180.0,\n  ], phase_function_per_sr = [\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace photic::scene
