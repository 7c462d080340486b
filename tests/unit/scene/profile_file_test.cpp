// Profiles in CSV files and in netCDF files such as floats write.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "optics/pressure.hpp"
#include "scene/profile.hpp"
#include "unit/scene/profile_scenes.hpp"

namespace photic::scene {
namespace {

// --- CSV -----------------------------------------------------------------------------------------

const std::string from_csv = "file = 'chl.csv', depth = 'depth_m', column = 'chl'";

TEST(CsvProfile, IsRead) {
  WrittenFiles files("csv_profile");
  files.write("chl.csv", "# a comment\ndepth_m, chl, other\n0, 0.2, x\n10, 0.4, y\n30, 0.0, z\n");
  const Scene scene = files.read(profiled(from_csv)).scene;
  EXPECT_NEAR(mean_chlorophyll(scene), (10 * 0.3 + 10 * 0.3) / 20, 1e-14);
  EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
}

TEST(CsvProfile, ProblemsAreReportedAtTheirLineAndColumn) {
  WrittenFiles files("csv_profile_problems");
  const auto problems = [&](const std::string& rows, const std::string& profile = from_csv) {
    files.write("chl.csv", "depth_m, chl\n" + rows);
    return files.problems(profiled(profile));
  };
  EXPECT_EQ(problems("0, 0.2\n30, -0.4\n"),
            (Texts{"chl.csv:3:4: must be a finite number, at least 0, not -0.4 (negative = "
                   "\"zero\" counts values below 0 as 0)"}));
  EXPECT_EQ(problems("0, 0.2\n10,\n30, nan\n"),
            (Texts{"chl.csv:3:4: \"\" is not a finite number (fill the gap, or leave the row out)",
                   "chl.csv:4:4: \"nan\" is not a finite number (fill the gap, or leave the row "
                   "out)"}));
  EXPECT_EQ(problems("10, 0.2\n10, 0.4\n"),
            (Texts{"chl.csv:2:4: all rows are at a depth of 10 m (a profile needs two depths)"}));
  EXPECT_EQ(problems("0, 0.2\n"), (Texts{"chl.csv:2:1: a profile needs at least two rows"}));
  EXPECT_EQ(problems("0, 0.2\n30, 0.4\n", "file = 'chl.csv', depth = 'depth_m', column = 'chla'"),
            (Texts{"chl.csv:1:1: no column \"chla\" (there are, between commas: depth_m, chl)"}));
  EXPECT_EQ(problems("0, 0.2\n15, 0.4\n"),
            (Texts{"scene.toml:22:21: 'chlorophyll_mg_m3' is known from 0 to 15 m, and its layer "
                   "goes from 0 to 20 m (below = \"constant\" holds its last value down to the "
                   "bottom; or let layers with a number begin and end where the profile "
                   "does)"}));
}

TEST(CsvProfile, KeysThatAreMissing) {
  WrittenFiles files("csv_profile_keys");
  files.write("chl.csv", "");
  EXPECT_EQ(files.problems(profiled("file = 'chl.csv', depth = 'z'")),
            (Texts{"scene.toml:22:21: 'chlorophyll_mg_m3' needs 'column' or 'variable'"}));
  EXPECT_EQ(
      files.problems(profiled("file = 'chl.csv', column = 'chl', variable = 'CHLA'")),
      (Texts{"scene.toml:22:21: 'depth' is missing in 'chlorophyll_mg_m3' (add it: the column "
             "of depths in m, by its name or its number from 1, or the variable of depths or "
             "pressures)",
             "scene.toml:22:57: 'column' and 'variable' exclude each other in "
             "'chlorophyll_mg_m3' (keep one of them)"}));
}

// --- netCDF --------------------------------------------------------------------------------------

// The check value of the source. Seen red: with the latitude in degrees for radians.
TEST(Pressure, GivesTheDepthOfTheSource) {
  EXPECT_NEAR(optics::depth_of_pressure_m(10000, 30), 9712.653, 5e-4);
  EXPECT_NEAR(optics::depth_of_pressure_m(500, 0), 496.65299, 5e-6);
  EXPECT_NEAR(optics::depth_of_pressure_m(5000, 90), 4889.13133, 5e-6);
  EXPECT_EQ(optics::depth_of_pressure_m(0, 45), 0);
}

// Seen red: with the first profile for the second; with pressures for depths.
TEST(FloatProfile, IsTheOneAskedForAtTheDepthsOfItsPressures) {
  WrittenFiles files("float");
  write_float(files);
  const Reading reading = files.read(profiled(from_float));
  EXPECT_EQ(reading.remarks, Texts{});
  std::vector<double> depth;
  for (const double p : {0.0, 5.0, 10.0, 20.0, 30.0})
    depth.push_back(optics::depth_of_pressure_m(p, 30));
  const LinearProfile expected(depth, {0.1, 0.2, 0.4, 0.3, 0.3});
  EXPECT_NEAR(mean_chlorophyll(reading.scene), expected.integral(0, 20) / 20, 1e-14);
  EXPECT_EQ(files.problems(profiled(from_float + ", profile = 1")),
            (Texts{"scene.toml:22:21: 'chlorophyll_mg_m3' is known from 0 to 3.96225 m, and its "
                   "layer goes from 0 to 20 m (below = \"constant\" holds its last value down to "
                   "the bottom; or let layers with a number begin and end where the "
                   "profile does)"}));
}

// Seen red: with the gap from its lower end.
TEST(FloatProfile, LevelsWithoutAValueAreLeftOutWithARemark) {
  WrittenFiles files("float_gaps");
  write_float(files);
  files.netcdf["CHLA"].value[1] = none;
  files.netcdf["PRES"].value[2] = none;
  const Reading reading = files.read(profiled(from_float));
  const LinearProfile expected(
      {0, optics::depth_of_pressure_m(20, 30), optics::depth_of_pressure_m(30, 30)},
      {0.1, 0.3, 0.3});
  EXPECT_NEAR(mean_chlorophyll(reading.scene), expected.integral(0, 20) / 20, 1e-14);
  ASSERT_EQ(reading.remarks.size(), 1U);
  EXPECT_EQ(files.without_folder(reading.remarks[0]),
            "scene.toml:22:21: float.nc: 2 of 5 levels of CHLA have no value or no depth and are "
            "left out; the widest gap is from 0 to 19.86 m");
}

TEST(FloatProfile, WithoutLatitudeIsTakenAt45Degrees) {
  WrittenFiles files("float_latitude");
  write_float(files);
  files.netcdf["LATITUDE"].value[0] = none;
  const Reading reading = files.read(profiled(from_float));
  ASSERT_EQ(reading.remarks.size(), 1U);
  EXPECT_EQ(files.without_folder(reading.remarks[0]),
            "scene.toml:22:21: float.nc: no LATITUDE in the file: depths are those of the "
            "pressures at 45 degrees");
  files.netcdf.erase("LATITUDE");
  EXPECT_EQ(files.read(profiled(from_float)).remarks, reading.remarks);
}

TEST(FloatProfile, OfOneDimensionInMetres) {
  WrittenFiles files("float_metres");
  files.write("float.nc", "");
  files.netcdf["z"] = {{"z"}, {3}, "m", {0, 10, 20}};
  files.netcdf["CHLA"] = {{"z"}, {3}, "mg/m3", {0.1, 0.3, 0.1}};
  const Reading reading = files.read(profiled("file = 'float.nc', depth = 'z', variable = 'CHLA'"));
  EXPECT_NEAR(mean_chlorophyll(reading.scene), 0.2, 1e-15);
  EXPECT_EQ(reading.remarks, Texts{});
}

// Seen red: with flag 2 for 3; with the flags of the first profile for those of the second; without
// the flags of depths.
TEST(FloatProfile, LevelsFlaggedBadAreLeftOutWithARemark) {
  WrittenFiles files("float_flags");
  write_float(files);
  const std::vector<std::string> dimensions{"N_PROF", "N_LEVELS"};
  files.netcdf["CHLA"].value[1] = -5;  // refused if it were taken
  files.netcdf["CHLA_QC"] = {dimensions, {2, 5}, "", {1, 4, 2, 3, 8, 4, 4, 4, 4, 4}};
  const auto expected_mean = [](std::vector<double> dbar, const std::vector<double>& value) {
    for (double& p : dbar) p = optics::depth_of_pressure_m(p, 30);
    return LinearProfile(dbar, value).integral(0, 20) / 20;
  };
  Reading reading = files.read(profiled(from_float));
  EXPECT_NEAR(mean_chlorophyll(reading.scene), expected_mean({0, 10, 30}, {0.1, 0.4, 0.3}), 1e-14);
  ASSERT_EQ(reading.remarks.size(), 2U);
  EXPECT_EQ(files.without_folder(reading.remarks[0]),
            "scene.toml:22:21: float.nc: CHLA_QC flags 2 of 5 levels of CHLA as bad (3, 4) or "
            "missing (9), which then have no value");
  EXPECT_EQ(files.without_folder(reading.remarks[1]),
            "scene.toml:22:21: float.nc: 2 of 5 levels of CHLA have no value or no depth and are "
            "left out; the widest gap is from 9.932 to 29.79 m");
  const auto of_second = files.problems(profiled(from_float + ", profile = 1"));
  ASSERT_EQ(of_second.size(), 1U);
  EXPECT_NE(of_second[0].find("profile 1 has values at 0 of 5 levels"), std::string::npos);
  files.netcdf["PRES_QC"] = {dimensions, {2, 5}, "", {1, 1, 9, none, 1, 1, 1, 1, 1, 1}};
  EXPECT_NEAR(mean_chlorophyll(files.read(profiled(from_float)).scene),
              expected_mean({0, 30}, {0.1, 0.3}), 1e-14);
}

TEST(FloatProfile, FlagsThatLeaveNothing) {
  WrittenFiles files("float_all_flagged");
  write_float(files);
  const std::vector<std::string> dimensions{"N_PROF", "N_LEVELS"};
  files.netcdf["CHLA_QC"] = {dimensions, {2, 5}, "", std::vector<double>(10, 4)};
  const std::string flagged =
      "scene.toml:22:30: float.nc: CHLA: profile 0 has values at 0 of 5 levels; it takes two: "
      "CHLA_QC flags 5 of 5 "
      "levels of CHLA as bad (3, 4) or missing (9), which then have no value";
  EXPECT_EQ(files.problems(profiled(from_float)), (Texts{flagged + " (no profile has values)"}));
  files.netcdf["CHLA_ADJUSTED"] = files.netcdf["CHLA"];
  EXPECT_EQ(files.problems(profiled(from_float)), (Texts{flagged + " (there is CHLA_ADJUSTED)"}));
  EXPECT_EQ(
      files.read(profiled("file = 'float.nc', depth = 'PRES', variable = 'CHLA_ADJUSTED'")).remarks,
      Texts{});
  files.netcdf["CHLA_QC"] = {{"N_PROF"}, {2}, "", {1, 1}};
  EXPECT_EQ(files.problems(profiled(from_float)),
            (Texts{"scene.toml:22:30: float.nc: CHLA_QC(N_PROF): should have a flag for each value "
                   "of CHLA(N_PROF, "
                   "N_LEVELS)"}));
}

// Seen red: with the reader's own functions handed on.
TEST(FloatProfile, IsReadOnceForAllEnvironments) {
  WrittenFiles files("float_once");
  write_float(files);
  files.netcdf["CHLA_QC"] = {{"N_PROF", "N_LEVELS"}, {2, 5}, "", std::vector<double>(10, 1)};
  const NetcdfFiles plain = files.netcdf_files();
  int lists = 0, variables = 0;
  const auto counting = [&](const auto& read) {
    return [&variables, read](const std::string& path, const std::string& name) {
      ++variables;
      return read(path, name);
    };
  };
  const NetcdfFiles counted{[&](const std::string& path) {
                              ++lists;
                              return plain.contents(path);
                            },
                            counting(plain.read), counting(plain.codes)};
  std::string text = profiled(from_float);
  for (int i = 1; i < 4; ++i)
    text += fmt::format("[[environment]]\nset = {{ 'sea.layer.1.iop.0.a_per_m' = 0.{} }}\n", i);
  const Scene scene = read_scene_text(text, "scene.toml", files.path(""), {}, {}, counted).scene;
  EXPECT_EQ(scene.environment.size(), 3U);
  EXPECT_EQ(lists, 1);
  EXPECT_EQ(variables, 4);  // CHLA, CHLA_QC, PRES, LATITUDE
}

TEST(FloatProfile, ProblemsNameVariableAndLevel) {
  WrittenFiles files("float_problems");
  const auto problems = [&](const auto& damage, const std::string& more = "") {
    files.netcdf.clear();
    write_float(files);
    damage(files.netcdf);
    return files.problems(profiled(from_float + more));
  };
  using Variables = std::map<std::string, NetcdfVariable>;
  EXPECT_EQ(
      problems([](Variables& v) { v.erase("CHLA"); }),
      (Texts{"scene.toml:22:30: float.nc: no variable \"CHLA\" (there are: LATITUDE, PRES)"}));
  EXPECT_EQ(problems([](Variables& v) {
              v["CHLA_ADJUSTED"] = v["CHL"] = v["CHLA"];
              v.erase("CHLA");
            }),
            (Texts{"scene.toml:22:30: float.nc: no variable \"CHLA\" (did you mean 'CHL'?)"}));
  EXPECT_EQ(problems([](Variables& v) { v["CHLA"].value[3] = -0.02; }),
            (Texts{"scene.toml:22:30: float.nc: CHLA[0, 3]: must be a finite number, at least 0, "
                   "not -0.02 (negative = \"zero\" counts values below 0 as 0)"}));
  EXPECT_EQ(problems([](Variables& v) {
              for (int i = 0; i < 5; ++i) v["CHLA"].value[i] = none;
            }),
            (Texts{"scene.toml:22:30: float.nc: CHLA: profile 0 has values at 0 of 5 levels; it "
                   "takes two (the first "
                   "profile with values is 1)"}));
  EXPECT_EQ(problems([](Variables& v) { v["CHLA"].value.assign(10, none); }),
            (Texts{"scene.toml:22:30: float.nc: CHLA: profile 0 has values at 0 of 5 levels; it "
                   "takes two (no "
                   "profile has values)"}));
  EXPECT_EQ(problems([](Variables&) {}, ", profile = 2"),
            (Texts{"scene.toml:22:30: float.nc: CHLA(N_PROF, N_LEVELS): there is no profile 2: it "
                   "has 2, counted "
                   "from 0"}));
  EXPECT_EQ(problems([](Variables& v) { v["PRES"].units = "fathom"; }),
            (Texts{"scene.toml:22:30: float.nc: PRES: is in units of \"fathom\" (depths are in "
                   "\"m\", pressures in "
                   "\"decibar\")"}));
  EXPECT_EQ(problems([](Variables& v) { v["PRES"].units = ""; }),
            (Texts{"scene.toml:22:30: float.nc: PRES: has no attribute units (depths are in \"m\", "
                   "pressures in "
                   "\"decibar\")"}));
  EXPECT_EQ(problems([](Variables& v) {
              v["PRES"] = {{"N_LEVELS"}, {2}, "m", {0, 30}};
            }),
            (Texts{"scene.toml:22:30: float.nc: PRES(N_LEVELS): has 2 levels where CHLA has 5"}));
  EXPECT_EQ(problems([](Variables& v) {
              v["CHLA"] = {{}, {}, "", {1}};
            }),
            (Texts{"scene.toml:22:30: float.nc: CHLA(): has 0 dimensions, not (levels) or "
                   "(profiles, levels)"}));
  EXPECT_EQ(problems([](Variables& v) {
              for (const char* name : {"CHLA", "PRES"}) {
                v[name].length = {1, 100001};
                v[name].value.resize(100001);
              }
            }),
            (Texts{"scene.toml:22:30: float.nc: CHLA(N_PROF, N_LEVELS): profile 0 has 100001 "
                   "levels; at most 100000 are read"}));
}

}  // namespace
}  // namespace photic::scene
