// Levels as instruments write them: in any order, at one depth, below 0, short of the surface,
// flagged in many ways.
#include <gtest/gtest.h>

#include "scene/profile.hpp"
#include "unit/scene/profile_scenes.hpp"

namespace photic::scene {
namespace {

// --- Order ---------------------------------------------------------------------------------------

// Seen red: with the first of the values at one depth.
TEST(MeasuredLevels, AtOneDepthBecomeOne) {
  WrittenFiles files("measured_twice");
  write_depths(files, {0, 9, 9, 9, 12, 12, 30}, {0.1, 0.20, 0.22, 0.24, 0.3, 0.1, 0.2});
  const Reading reading = files.read(profiled(from_depths));
  const LinearProfile expected({0, 9, 12, 30}, {0.1, 0.22, 0.2, 0.2});
  EXPECT_NEAR(mean_chlorophyll(reading.scene), expected.integral(0, 20) / 20, 1e-14);
  EXPECT_EQ(remarks_of(files, reading),
            (Texts{"3 of 7 levels are at the depth of another one, the first at 9 m: they are "
                   "merged into one, with the mean of CHLA"}));
}

// Seen red: with the order of the file.
TEST(MeasuredLevels, ThatDoNotAscendAreSorted) {
  WrittenFiles files("measured_order");
  const LinearProfile expected({0, 5, 10, 30}, {0.1, 0.2, 0.4, 0.3});
  for (const auto& [depth, value] :
       {std::pair<std::vector<double>, std::vector<double>>{{30, 10, 5, 0}, {0.3, 0.4, 0.2, 0.1}},
        {{0, 10, 5, 30}, {0.1, 0.4, 0.2, 0.3}}}) {
    write_depths(files, depth, value);
    const Reading reading = files.read(profiled(from_depths));
    EXPECT_NEAR(mean_chlorophyll(reading.scene), expected.integral(0, 20) / 20, 1e-14);
    EXPECT_EQ(remarks_of(files, reading),
              (Texts{"levels do not ascend in z, and have been sorted"}));
  }
}

// Both casts of one profile, with a gap.
TEST(MeasuredLevels, OfADownAndAnUpCast) {
  WrittenFiles files("measured_casts");
  write_depths(files, {0, 10, 30, 10, 0}, {0.1, 0.3, none, 0.5, 0.3});
  const Reading reading = files.read(profiled(from_depths + ", below = 'constant'"));
  const LinearProfile expected({0, 10, 20}, {0.2, 0.4, 0.4});
  EXPECT_NEAR(mean_chlorophyll(reading.scene), expected.integral(0, 20) / 20, 1e-14);
  EXPECT_EQ(remarks_of(files, reading).size(), 4U);
}

TEST(MeasuredLevels, AtOneDepthAloneAreNoProfile) {
  WrittenFiles files("measured_one");
  write_depths(files, {9, none, 9}, {0.1, 0.2, 0.3});
  EXPECT_EQ(
      files.problems(profiled(from_depths)),
      (Texts{"scene.toml:22:30: float.nc: CHLA[0]: all levels are at a depth of 9 m (a profile "
             "needs two depths)"}));
}

TEST(MeasuredLevels, ProblemsNameTheLevelOfTheFile) {
  WrittenFiles files("measured_index");
  write_depths(files, {30, 10, none, 0}, {0.3, 0.2, 0.1, -0.1});
  EXPECT_EQ(files.problems(profiled(from_depths)),
            (Texts{"scene.toml:22:30: float.nc: CHLA[3]: must be a finite number, at least 0, not "
                   "-0.1 (negative = \"zero\" counts values below 0 as 0)"}));
}

TEST(MeasuredLevels, RowsOfCsvLikewise) {
  WrittenFiles files("measured_csv");
  files.write("chl.csv", "z, chl\n30, 0.3\n10, 0.2\n10, 0.4\n0, -0.1\n");
  const Reading reading =
      files.read(profiled("file = 'chl.csv', depth = 'z', column = 'chl', negative = 'zero'"));
  const LinearProfile expected({0, 10, 30}, {0, 0.3, 0.3});
  EXPECT_NEAR(mean_chlorophyll(reading.scene), expected.integral(0, 20) / 20, 1e-14);
  EXPECT_EQ(remarks_of(files, reading),
            (Texts{"1 of 4 values of chl are below 0, the smallest of them -0.1, and count as 0",
                   "rows do not ascend in z, and have been sorted",
                   "1 of 4 rows are at the depth of another one, the first at 10 m: they are "
                   "merged into one, with the mean of chl"}));
}

// --- Below 0 -------------------------------------------------------------------------------------

// Seen red: with such values reported and kept.
TEST(MeasuredLevels, BelowZeroCountAsZeroWhereAskedFor) {
  WrittenFiles files("measured_negative");
  write_depths(files, {0, 10, 20, 30}, {0.1, 0.2, -0.007, -0.012});
  const Reading reading = files.read(profiled(from_depths + ", negative = 'zero'"));
  EXPECT_NEAR(mean_chlorophyll(reading.scene), (10 * 0.15 + 10 * 0.1) / 20, 1e-14);
  EXPECT_EQ(
      remarks_of(files, reading),
      (Texts{"2 of 4 values of CHLA are below 0, the smallest of them -0.012, and count as 0"}));
  write_depths(files, {0, 30}, {0.1, 0.2});
  EXPECT_EQ(files.read(profiled(from_depths + ", negative = 'zero'")).remarks, Texts{});
}

TEST(MeasuredLevels, TemperaturesMayBeBelowZero) {
  WrittenFiles files("measured_temperature");
  write_depths(files, {0, 30}, {1, -1});
  files.netcdf["CHLA"].units = "degC";
  EXPECT_EQ(files.problems(
                edited({{22, 22, "temperature_c = { " + from_depths + ", negative = 'zero' }"}})),
            (Texts{"scene.toml:22:81: 'temperature_c' may be below 0: 'negative' is not for it"}));
}

// --- Short of the layer --------------------------------------------------------------------------

// Seen red: with a straight line to 0; without the remark.
TEST(MeasuredLevels, HoldBeyondTheirEndsWhereAskedFor) {
  WrittenFiles files("measured_ends");
  write_depths(files, {4, 10, 15}, {0.1, 0.2, 0.3});
  const std::string both = ", above = 'constant', below = 'constant'";
  const double mean = (4 * 0.1 + 6 * 0.15 + 5 * 0.25 + 5 * 0.3) / 20;
  const Reading of_netcdf = files.read(profiled(from_depths + both));
  EXPECT_NEAR(mean_chlorophyll(of_netcdf.scene), mean, 1e-14);
  EXPECT_EQ(remarks_of(files, of_netcdf),
            (Texts{"'chlorophyll_mg_m3' is held constant from 0 to 4 m, at the 0.1 of 4 m",
                   "'chlorophyll_mg_m3' is held constant from 15 to 20 m, at the 0.3 of 15 m"}));
  files.write("chl.csv", "z, chl\n4, 0.1\n10, 0.2\n15, 0.3\n");
  const Reading of_csv =
      files.read(profiled("file = 'chl.csv', depth = 'z', column = 'chl'" + both));
  const Reading of_points =
      files.read(profiled("depth_m = [4, 10, 15], value = [0.1, 0.2, 0.3]" + both));
  for (const Reading& reading : {of_csv, of_points}) {
    EXPECT_EQ(reading.scene, of_netcdf.scene);
    EXPECT_EQ(reading.remarks, of_netcdf.remarks);
  }
  const std::string text = write_scene(of_netcdf.scene);
  EXPECT_EQ(text.find("float.nc"), std::string::npos);
  EXPECT_TRUE(read_scene_text(text, "written.toml", "/elsewhere").scene == of_netcdf.scene);
}

TEST(MeasuredLevels, KeysOfEndsAreNamedWhereTheyHelp) {
  WrittenFiles files("measured_ends_named");
  const auto problem = [&](const std::vector<double>& depth, const std::string& more = "") {
    write_depths(files, depth, {0.1, 0.2});
    const Texts texts = files.problems(profiled(from_depths + more));
    return texts.size() == 1 ? texts[0].substr(texts[0].find('(')) : "";
  };
  const std::string above = "above = \"constant\" holds its first value up to the top; ";
  const std::string below = "below = \"constant\" holds its last value down to the bottom; ";
  const std::string layers = "or let layers with a number begin and end where the profile does)";
  EXPECT_EQ(problem({4, 20}), "(" + above + layers);
  EXPECT_EQ(problem({0, 15}), "(" + below + layers);
  EXPECT_EQ(problem({4, 15}), "(" + above + below + layers);
  EXPECT_EQ(problem({4, 15}, ", above = 'constant'"), "(" + below + layers);
}

// A layer that lies beyond all levels. Seen red: with a value of 0 at its top.
TEST(MeasuredLevels, HoldThroughAWholeLayer) {
  WrittenFiles files("measured_beyond");
  write_depths(files, {30, 40}, {0.1, 0.2});
  const Reading reading = files.read(profiled(from_depths + ", above = 'constant'"));
  EXPECT_EQ(reading.scene.sea.layer[0].chlorophyll_mg_m3, 0.1);
  EXPECT_EQ(remarks_of(files, reading),
            (Texts{"'chlorophyll_mg_m3' is held constant from 0 to 20 m, at the 0.1 of 30 m"}));
}

TEST(MeasuredLevels, KeysHaveOneWordEach) {
  WrittenFiles files("measured_words");
  write_depths(files, {0, 30}, {0.1, 0.2});
  EXPECT_EQ(files.problems(profiled(from_depths + ", negative = 0, above = 'linear'")),
            (Texts{"scene.toml:22:85: 'negative' must be \"zero\", not 0",
                   "scene.toml:22:96: 'above' must be \"constant\", not text \"linear\" (choose "
                   "from: constant)"}));
  EXPECT_EQ(files.problems(profiled("depth_m = [0, 20], value = [1, 2], negative = 'zero'")),
            (Texts{"scene.toml:22:58: unknown key 'negative' in 'chlorophyll_mg_m3' (known here: "
                   "depth_m, value, above, below)"}));
}

// Seen red: with a leap by any length; with upward leaps alone.
TEST(MeasuredLevels, ThatStartOverAreSaidToDoSo) {
  WrittenFiles files("measured_restarts");
  const std::string sorted = "levels do not ascend in z, and have been sorted";
  const auto remark = [&](const std::vector<double>& depth) {
    write_depths(files, depth, std::vector<double>(depth.size(), 0.2));
    return remarks_of(files, files.read(profiled(from_depths))).front();
  };
  const std::string several =
      sorted + ", as if all were of one cast, although they start over like those of several";
  EXPECT_EQ(remark({0, 10, 30, 1, 11, 29}), several);
  EXPECT_EQ(remark({30, 10, 0, 29, 11, 1}), several);
  EXPECT_EQ(remark({0, 10, 30, 29, 11, 1}), sorted);
  EXPECT_EQ(remark({30, 10, 0}), sorted);
  EXPECT_EQ(remark({0, 10, 8, 12, 11, 30}), sorted);
}

// --- Flags ---------------------------------------------------------------------------------------

// Seen red: with Argo's numbers whatever the file says.
TEST(MeasuredFlags, MeanWhatTheFileSays) {
  WrittenFiles files("measured_meanings");
  write_depths(files, {0, 10, 20, 30}, {0.1, 5, 0.3, 0.3});
  NetcdfCodes& flags = files.codes["CHLA_QC"];
  flags = WrittenFiles::as_codes({{"z"}, {4}, "", {3, 1, 0, none}});
  flags.flag_values = {"0", "1", "3"};
  flags.flag_meanings = {"good Bad_data interpolated"};
  const Reading reading = files.read(profiled(from_depths));
  EXPECT_NEAR(mean_chlorophyll(reading.scene), 0.2, 1e-14);
  EXPECT_EQ(remarks_of(files, reading)[0],
            "CHLA_QC flags 1 of 4 levels of CHLA as bad or missing, which then have no value");
}

// Seen red: with the adjusted chlorophyll offered for pressures that are flagged.
TEST(MeasuredFlags, ThatLeaveNothingHaveTheRightVariableOffered) {
  WrittenFiles files("measured_hints");
  const std::vector<std::string> dimensions{"N_PROF", "N_LEVELS"};
  const NetcdfVariable all_bad{dimensions, {2, 5}, "", std::vector<double>(10, 4)};
  const auto hint = [&](const std::vector<std::string>& flagged,
                        const std::vector<std::string>& adjusted,
                        const std::vector<std::string>& empty = {}) {
    files.netcdf.clear();
    write_float(files);
    for (const std::string& name : adjusted) files.netcdf[name + "_ADJUSTED"] = files.netcdf[name];
    for (const std::string& name : flagged) files.netcdf[name + "_QC"] = all_bad;
    for (const std::string& name : empty) files.netcdf[name].value.assign(10, none);
    const Texts texts = files.problems(profiled(from_float));
    return texts.size() == 1 ? texts[0].substr(texts[0].rfind('(')) : "";
  };
  EXPECT_EQ(hint({"PRES"}, {"PRES", "CHLA"}), "(there is PRES_ADJUSTED)");
  EXPECT_EQ(hint({"CHLA"}, {"PRES", "CHLA"}), "(there is CHLA_ADJUSTED)");
  EXPECT_EQ(hint({"CHLA", "PRES"}, {"PRES", "CHLA"}), "(there is CHLA_ADJUSTED and PRES_ADJUSTED)");
  EXPECT_EQ(hint({"PRES"}, {"CHLA"}), "(no profile has values)");
  EXPECT_EQ(hint({"PRES"}, {"PRES"}, {"PRES_ADJUSTED"}), "(no profile has values)");
  EXPECT_EQ(hint({"PRES", "PRES_ADJUSTED"}, {"PRES"}), "(no profile has values)");
  write_float(files);
  files.netcdf.erase("PRES_ADJUSTED");
  files.netcdf.erase("PRES_ADJUSTED_QC");
  files.netcdf["PRES_QC"].value = {4, 4, 4, 4, 4, 1, 1, 1, 1, 1};
  const Texts texts = files.problems(profiled(from_float));
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_TRUE(texts[0].ends_with("(the first profile with values is 1)")) << texts[0];
}

// Seen red: with the levels of two profiles taken for two levels.
TEST(MeasuredLevels, TurnedDimensionsAreRefused) {
  WrittenFiles files("measured_turned");
  write_float(files);
  files.netcdf["CHLA"] = {{"N_LEVELS", "N_PROF"}, {2, 2}, "mg/m3", {1, 2, 3, 4}};
  EXPECT_EQ(files.problems(profiled(from_float)),
            (Texts{"scene.toml:22:30: float.nc: CHLA(N_LEVELS, N_PROF): has its levels first, and "
                   "PRES(N_PROF, N_LEVELS) has them last (dimensions are (profiles, levels))"}));
  write_depths(files, {0, 30}, {});
  files.netcdf["CHLA"] = {{"z", "time"}, {2, 2}, "mg/m3", {1, 2, 3, 4}};
  EXPECT_EQ(files.problems(profiled(from_depths)),
            (Texts{"scene.toml:22:30: float.nc: CHLA(z, time): has its levels first, and z(z) has "
                   "them last (dimensions are (profiles, levels))"}));
}

}  // namespace
}  // namespace photic::scene
