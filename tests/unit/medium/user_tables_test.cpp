// What is found wrong with tables that users give, at the lines of their files.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "unit/medium/checked_scenes.hpp"

namespace photic::medium {
namespace {

/// A file of this process alone: tests run side by side.
class TableOfAUser : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  std::string file_ = testing::TempDir() + std::to_string(getpid()) + "photic_table.csv";
};

/// A CSV of wavelength_nm, a_m2_per_mg, b_m2_per_mg that a scene's phytoplankton goes by.
class PhytoplanktonTableOfAUser : public TableOfAUser {
 protected:
  std::vector<scene::Edit> with(const std::string& rows) const {
    std::ofstream(file_) << "wavelength_nm,a_m2_per_mg,b_m2_per_mg\n" << rows;
    return {
        {18, 18, "[optics]\nphytoplankton = \"table\"\nphytoplankton_file = \"" + file_ + "\""}};
  }
};

TEST_F(PhytoplanktonTableOfAUser, IsReadOnceItIsGood) {
  EXPECT_EQ(problems(with("500,0.04,0.3\n600,0.02,0.25\n")), Texts{});
  const auto scene = scene::read_scene_text(edited(with("500,0.04,0.3\n600,0.02,0.25\n")),
                                            "scene.toml", "/", {}, check)
                         .scene;
  const Medium m = medium_of(scene);
  const std::string listed = source_line(m.sources[2]);
  EXPECT_TRUE(listed.starts_with("a and b of phytoplankton, 532 nm: given in " + file_)) << listed;
}

TEST_F(PhytoplanktonTableOfAUser, IsRefusedAtItsLine) {
  EXPECT_EQ(problems(with("500,0.04,0.3\n500,0.02,0.25\n")),
            Texts{file_ + ":3:1: wavelength_nm 500 is not above the 500 before it (this column "
                          "must ascend)"});
  EXPECT_EQ(problems(with("500,-0.04,0.3\n600,0.02,0.25\n")),
            Texts{file_ + ":2:5: a_m2_per_mg -0.04 is negative"});
}

TEST_F(PhytoplanktonTableOfAUser, HasToReachAllLight) {
  auto edits = with("500,0.04,0.3\n600,0.02,0.25\n");
  edits.insert(edits.begin(), {16, 17, raman_channel});
  edits.push_back({23, 25, ""});
  EXPECT_EQ(problems(edits),
            Texts{"scene.toml:17:11: no phytoplankton data at 631.024 nm: given in " + file_ +
                  " cover 500-600 nm; channel \"r\" counts raman light there (choose another "
                  "wavelength, or give the layer's iop at this one)"});
}

/// A film of 10 um of an oil in a CSV, over the base scene.
class OilOfAUser : public TableOfAUser {
 protected:
  std::vector<scene::Edit> with(const std::string& text, const std::string& more = "") const {
    std::ofstream(file_) << text;
    return {{26, 26, "[oil]\nthickness_um = 10\nfile = \"" + file_ + "\"\n" + more + "[gates]"}};
  }
};

// Through the film and back: exp(-2 x 5e4 1/m x 1e-5 m).
// Seen red, each for itself: with a spectrum asked for that has an integral above 0; with one.
TEST_F(OilOfAUser, AbsorbsThoughItDoesNotShine) {
  for (const char* text :
       {"# yield: 0\n# lifetime_ns: 0\nwavelength_nm,n,a_per_m,emission_per_nm\n300,1.50,1e5,0\n"
        "532,1.48,5e4,0\n800,1.47,1e3,0\n",
        "# yield: 0\n# nm n a\n300 1.50 1e5\n532 1.48 5e4\n800 1.47 1e3\n",
        "wavelength_nm;n;a_per_m\n300;1,50;1e5\n532;1,48;5e4\n800;1,47;1e3\n"}) {
    SCOPED_TRACE(text);
    auto edits = with(text, "yield = 0\n");
    if (std::string(text).find("# nm") != std::string::npos)
      edits[0].text = "[oil]\nthickness_um = 10\nfile = { file = \"" + file_ +
                      "\", wavelength = \"nm\", a = 3 }\n[gates]";
    EXPECT_EQ(problems(edits), Texts{});
    const Film film =
        medium_of(scene::read_scene_text(edited(edits), "scene.toml", "/", {}, check).scene).film;
    EXPECT_TRUE(film.exists);
    EXPECT_EQ(film.index, (std::vector<double>{1.48}));
    EXPECT_NEAR(std::exp(-2 * film.optical_thickness.at(0)), 0.367879, 1e-6);
  }
}

TEST_F(OilOfAUser, NeedsASpectrumIfItShines) {
  EXPECT_EQ(problems(with("wavelength_nm,n,a_per_m\n300,1.5,1e5\n800,1.5,1e3\n",
                          "yield = 0.1\nlifetime_ns = 2\n")),
            Texts{file_ + ":1:1: no column \"emission_per_nm\" (there are, between commas: "
                          "wavelength_nm, n, a_per_m; with a yield of 0 it is not needed)"});
  EXPECT_EQ(problems({}, {"oil={ thickness_um = 1, yield = 0.1, lifetime_ns = 2, file = { "
                          "wavelength_nm = [300, 800], n = [1.5, 1.5], a_per_m = [1e5, 1e3] } }"}),
            Texts{"--set oil: no column \"emission_per_nm\" (there are: wavelength_nm, n, a_per_m; "
                  "with a yield of 0 it is not needed)"});
}

/// A CSV of angle_deg, phase_function_per_sr, and a scene whose second layer scatters by it.
class PhaseTableOfAUser : public TableOfAUser {
 protected:
  std::vector<scene::Edit> with(const std::string& rows) const {
    std::ofstream(file_) << "angle_deg,phase_function_per_sr\n" << rows;
    return {{25, 25, "phase_function = { model = \"table\", file = \"" + file_ + "\" }"}};
  }
};

TEST_F(PhaseTableOfAUser, IsRefusedAtItsLineAfterTheScene) {
  auto edits = with("0,0.0796\n90,x\n120,0.1;\n180,0.0796\n");
  edits.push_back({30, 30, "photons = 0"});
  EXPECT_EQ(problems(edits, {"gates.depth_step_m=-1"}),
            (Texts{"scene.toml:30:11: 'photons' must be a whole number, at least 1 and below 2^63, "
                   "not 0",
                   file_ + ":3:4: \"x\" is not a finite number",
                   file_ + ":4:5: \"0.1;\" is not a finite number",
                   "--set gates.depth_step_m: 'depth_step_m' must be a finite number, greater than "
                   "0, not -1"}));
}

TEST_F(PhaseTableOfAUser, IsReportedOnceWhereTwoLayersUseIt) {
  auto edits = with("0,0.5\n180,0.5\n");
  edits.insert(
      edits.begin(),
      {22, 22, "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]\n" + edits[0].text});
  EXPECT_EQ(problems(edits),
            Texts{file_ + ":2:3: integrates to 6.283 over the sphere, not 1 within "
                          "1 % (looks normalised to 1 "
                          "over the cosine of the angle, without the azimuth: divide it by 2 pi)"});
}

// Seen red: with the remark dropped.
TEST_F(PhaseTableOfAUser, IsRemarkedOnWhenItIsScaled) {
  EXPECT_EQ(remarks(with("0,0.0799\n180,0.0799\n")),
            Texts{"scene.toml:25:44: " + file_ +
                  ": the phase function integrates to 1.00405; scaled to 1"});
  EXPECT_EQ(remarks(with("0,0.0795774715\n180,0.0795774715\n")), Texts{});
}

// Seen red: with the place of the table for all that is wrong in it.
TEST_F(PhaseTableOfAUser, InTheSceneIsRefusedAtItsNumber) {
  const auto with_columns = [](const std::string& columns) {
    return std::vector<scene::Edit>{
        {25, 25, "phase_function = { model = \"table\", file = { " + columns + " } }"}};
  };
  EXPECT_EQ(problems(with_columns("angle_deg = [0, 90, 90, 180], phase_function_per_sr = [0.1, 0.1,"
                                  " 0.1, 0.1]")),
            Texts{"scene.toml:25:66: angle_deg 90 is not above the 90 before it (this column must "
                  "ascend)"});
  EXPECT_EQ(problems(with_columns("angle_deg = [0, 180], phase_function_per_sr = [\n0.1,\n-0.1]")),
            Texts{"scene.toml:27:1: a phase function is not negative"});
  EXPECT_EQ(problems({}, {"sea.layer.1.phase_function={ model = \"table\", file = { angle_deg = "
                          "[0, 180], phase_function_per_sr = [0.1, -0.1] } }"}),
            Texts{"--set sea.layer.1.phase_function: a phase function is not negative"});
}

TEST_F(PhaseTableOfAUser, IsFoundInAMixture) {
  auto edits = with("0,0.0799\n180,0.0799\n");
  edits[0].text =
      "phase_function = { model = \"mixture\", components = [{ fraction = 0.5, model = "
      "\"petzold\" }, { fraction = 0.5, model = \"table\", file = \"" +
      file_ + "\" }] }";
  EXPECT_EQ(remarks(edits), Texts{"scene.toml:25:134: " + file_ +
                                  ": the phase function integrates to 1.00405; scaled to 1"});
}

}  // namespace
}  // namespace photic::medium
