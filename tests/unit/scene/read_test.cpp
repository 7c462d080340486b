// What a good scene becomes: defaults, sets of optics, files, remarks; files that cannot be read.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

TEST(Read, FillsInDefaults) {
  const Scene scene = base_scene();
  EXPECT_EQ(scene.source.kind, SourceKind::laser);
  EXPECT_EQ(scene.source.profile, SourceProfile::disc);
  EXPECT_EQ(scene.telescope[0].detector_shift_m, 0.0);
  EXPECT_EQ(scene.optics.set, OpticsSet::modern);
  EXPECT_EQ(scene.optics.water_depolarisation, 0.039);
  EXPECT_EQ(scene.sea.salinity_psu, 35.0);
  EXPECT_FALSE(scene.sea.refractive_index);
  EXPECT_EQ(scene.sea.surface, Surface{});
  EXPECT_FALSE(scene.sea.surface.is_rough());
  EXPECT_EQ(scene.sea.layer[1].name, "layer1");
  EXPECT_FALSE(scene.sea.layer[1].bottom_depth_m);
  EXPECT_EQ(scene.gates.depth_m, (Gates::Interval{0.0, 50.0, 1.0}));
  EXPECT_EQ(scene.simulation.photons, 1'000'000U);
  EXPECT_FALSE(scene.simulation.max_order);
  EXPECT_EQ(scene.simulation.seed, 1U);
}

// Seen red: the set not filled in before the other keys are read.
TEST(Read, SetsOfOpticsGiveWhatIsNotGiven) {
  const Optics paper = base_scene({"optics.set=paper", "optics.raman=bartlett",
                                   "optics.phytoplankton_phase=petzold"})
                           .optics;
  EXPECT_EQ(paper.water_absorption, "smith-baker");
  EXPECT_EQ(paper.water_scattering, "smith-baker");
  EXPECT_EQ(paper.water_depolarisation, 0.17);
  EXPECT_EQ(paper.phytoplankton, "prieur-sathyendranath");
  EXPECT_EQ(paper.phytoplankton_phase, ParticlePhase::petzold);
  EXPECT_EQ(paper.minerals, MineralOptics::mie);
  EXPECT_EQ(paper.minerals_phase, ParticlePhase::mie);
  EXPECT_EQ(paper.raman, "bartlett");
}

TEST(Read, FilesAreRelativeToTheScene) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "photic_read_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "vsf.csv") << "angle_deg,phase_function_per_sr\n0,1\n180,1\n";
  std::ofstream(folder / "scene.toml")
      << edited({{25, 25, R"(phase_function = { model = "table", file = "vsf.csv" })"}});
  const Scene scene = read_scene((folder / "scene.toml").string()).scene;
  EXPECT_EQ(scene.sea.layer[1].phase_function->table.data().name(),
            (folder / "vsf.csv").lexically_normal());
  std::filesystem::remove_all(folder);
}

// In an environment, too.
TEST(Read, AFileOfPhytoplanktonIsRelativeToTheScene) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "photic_read_algae_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "algae.csv")
      << "wavelength_nm,a_m2_per_mg,b_m2_per_mg\n500,1,2\n600,1,2\n";
  std::ofstream(folder / "more.csv") << "wavelength_nm,a_m2_per_mg,b_m2_per_mg\n500,1,2\n600,1,2\n";
  std::ofstream(folder / "scene.toml")
      << edited({{18, 18,
                  "[optics]\nphytoplankton = \"table\"\nphytoplankton_file = \"algae.csv\""}}) +
             "[[environment]]\nset = { \"optics.phytoplankton_file\" = \"more.csv\" }\n";
  const Scene scene = read_scene((folder / "scene.toml").string()).scene;
  EXPECT_EQ(scene.optics.phytoplankton_table.data().name(),
            (folder / "algae.csv").lexically_normal());
  EXPECT_EQ(scene.environment[0].optics.phytoplankton_table.data().name(),
            (folder / "more.csv").lexically_normal());
  std::filesystem::remove_all(folder);
}

std::string refusal_of_file(const std::string& path) {
  try {
    read_scene(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

// Seen red: with an EnvironmentError.
TEST(Read, WhatIsNoFileIsBadInput) {
  EXPECT_EQ(refusal_of_file("/no/such/scene.toml"),
            "/no/such/scene.toml: there is no such file (photic new ship -o FILE writes a scene)");
  EXPECT_EQ(refusal_of_file("/dev/null/scene.toml"),
            "/dev/null/scene.toml: there is no such file (photic new ship -o FILE writes a scene)");
  EXPECT_EQ(refusal_of_file(PHOTIC_SOURCE_DIR),
            PHOTIC_SOURCE_DIR ": this is a folder and not a scene (name a scene file in it)");
}

// Seen red: with CDF version 2 not recognised.
TEST(Read, WhatIsNoTextIsReportedInOneLine) {
  const auto folder = std::filesystem::temp_directory_path() / "photic_no_text";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "my.nc").string();
  const auto refusal = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return refusal_of_file(path);
  };
  const std::string netcdf =
      path + ": this is a result, or another netCDF file, not a scene (for a result, photic show " +
      path + " prints the scene and photic run --continue " + path + " continues it)";
  for (const std::string start : {"\x89HDF\r\n\x1a\n", "CDF\x01", "CDF\x02", "CDF\x05"})
    EXPECT_EQ(refusal(start + std::string("\0abc", 4)), netcdf);
  EXPECT_EQ(refusal(std::string("\x7f"
                                "ELF\0\0\n",
                                7)),
            path +
                ": this is not a text in UTF-8, and so not a scene (scenes are TOML files: photic "
                "new ship prints one)");
  EXPECT_NE(refusal("CDF = 1").find("unknown key 'CDF'"), std::string::npos);
  std::filesystem::remove_all(folder);
}

// Seen red: without units; with metres for every unit.
TEST(Read, RemarksOnWhatIsNotWrong) {
  const auto remarks = [](const std::string& text) {
    return read_scene_text(text, "scene.toml", "/").remarks;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(remarks(edited({})), Texts{});
  EXPECT_EQ(
      remarks(edited({{28, 28, "depth_step_m = 3"}})),
      Texts{"scene.toml:28:16: steps of 3 m do not fill the 50 m from 0 to 50 m: the 17 gates are "
            "2.94118 m long instead"});
  EXPECT_EQ(
      remarks(edited({{27, 28, "range_min_m = 8\nrange_max_m = 100\nrange_step_m = 10"}})),
      Texts{
          "scene.toml:29:16: steps of 10 m do not fill the 92 m from 8 to 100 m: the 10 gates are "
          "9.2 m long instead"});
  EXPECT_EQ(
      remarks(edited({{27, 28, "start_ns = 90\nstop_ns = 200\nstep_ns = 100"}})),
      Texts{
          "scene.toml:29:11: steps of 100 ns do not fill the 110 ns from 90 to 200 ns: the 2 gates "
          "are 55 ns long instead"});
  EXPECT_EQ(remarks(edited({{11, 11, "direction = [0, 0, 1]"},
                            {27, 28, "start_ns = 90\nstop_ns = 200\nstep_ns = 1"}})),
            Texts{"scene.toml:11:13: this telescope in the air looks away from the sea"});
}

// Seen red: with a limit of 100 m; without the detector.
TEST(Read, RemarksOnDiametersInMillimetres) {
  const auto remarks = read_scene_text(edited({{6, 6, "diameter_m = 20"},
                                               {12, 12, "diameter_m = 400"},
                                               {14, 14, "detector_diameter_m = 40"}}),
                                       "scene.toml", "/")
                           .remarks;
  const std::string why =
      " m is more than a lidar has (mirrors have up to 10 m): are the units right?";
  EXPECT_EQ(remarks, (std::vector<std::string>{"scene.toml:12:14: a diameter of 400" + why,
                                               "scene.toml:14:23: a diameter of 40" + why}));
  EXPECT_EQ(read_scene_text(edited({{6, 6, "diameter_m = 40"}}), "scene.toml", "/").remarks,
            std::vector<std::string>{"scene.toml:6:14: a diameter of 40" + why});
}

TEST(Read, BordersOfTheRangesAreInside) {
  EXPECT_TRUE(diagnostics_of(edited({}), {"source.half_divergence_mrad=0"}).empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"simulation.orders_kept=1000", "simulation.max_order=1"})
                  .empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"simulation.photons=9223372036854775807"}).empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"simulation.photons=9.2e18"}).empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"gates.depth_min_m=-12"}).empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"source.wavelength_nm=533"}).empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"gates.depth_step_m=50"}).empty());
  EXPECT_TRUE(diagnostics_of(edited({}), {"sea.layer.1.iop.0.b_per_m=0"}).empty());
}

// Seen red: without the millionth of a step.
TEST(Gates, CountsWholeAndPartialSteps) {
  const auto count = [](double min, double max, double step) {
    Gates gates;
    gates.range_m = Gates::Interval{min, max, step};
    return gates.count();
  };
  EXPECT_EQ(count(0.0, 50.0, 0.5), 100);
  EXPECT_EQ(count(0.0, 2.1, 0.3), 7);  // 2.1 / 0.3 is above 7 in doubles
  EXPECT_EQ(count(0.0, 0.6, 0.2), 3);  // and 0.6 / 0.2 below 3
  EXPECT_EQ(count(0.0, 10.0, 3.0), 4);
  EXPECT_EQ(count(-2.0, 1.0, 3.0), 1);
}

TEST(Telescope, DetectorFromItsFieldOfView) {
  Telescope telescope;
  telescope.focal_length_m = 2.0;
  telescope.half_field_of_view_mrad = 10.0;
  EXPECT_NEAR(telescope.effective_detector_diameter_m(), 0.040001333387, 1e-12);  // 4 tan(0.01)
  telescope.detector_diameter_m = 0.03;
  EXPECT_EQ(telescope.effective_detector_diameter_m(), 0.03);
}

// f^2 / (d - f). Seen red: with the detector in the focal plane; with the focus for its distance
// from the focal plane.
TEST(Telescope, DetectorFromItsFocus) {
  Telescope telescope;
  telescope.focal_length_m = 2.0;
  telescope.detector_shift_m = -0.1;
  EXPECT_EQ(telescope.effective_detector_shift_m(), -0.1);
  EXPECT_EQ(telescope.detector_distance_m(), 1.9);
  telescope.detector_shift_m = 0;
  telescope.focus_m = 12.0;
  EXPECT_EQ(telescope.effective_detector_shift_m(), 0.4);
  EXPECT_EQ(telescope.detector_distance_m(), 2.4);
  telescope.focus_m = 705e3;
  EXPECT_NEAR(telescope.effective_detector_shift_m(), 4 / 704998.0, 1e-20);
  telescope.focus_m = 1e300;
  EXPECT_EQ(telescope.detector_distance_m(), 2);
}

}  // namespace
}  // namespace photic::scene
