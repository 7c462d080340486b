// Several casts in one dimension of a netCDF file, and dimensions that do not count.
#include <gtest/gtest.h>

#include "optics/pressure.hpp"
#include "unit/scene/profile_scenes.hpp"

namespace photic::scene {
namespace {

/// Two casts that follow each other.
class CastsFile {
 public:
  CastsFile() : files("netcdf_casts") {
    write_depths(files, {0, 10, 20, 0, 10, 20}, {0.1, 0.1, 0.1, 2, 2, 2});
  }

  void add(const std::string& name, const std::vector<double>& value,
           const std::string& dimension = "z") {
    files.netcdf[name] = {{dimension}, {value.size()}, "", value};
  }
  void add_words(const std::string& name, const std::string& letters) {
    NetcdfCodes& codes = files.codes[name] = {{"z"}, {letters.size()}};
    codes.text = {"A", "D"};
    for (const char letter : letters) codes.value.push_back(letter == 'A' ? 0 : 1);
  }
  std::string& attribute(const std::string& variable, const std::string& name) {
    return files.attributes[variable][name];
  }

  [[nodiscard]] Reading read(const std::string& more = "") const {
    return files.read(profiled(from_depths + more));
  }
  [[nodiscard]] double mean(const std::string& more) const {
    return std::round(1e3 * mean_chlorophyll(read(more).scene)) / 1e3;
  }
  [[nodiscard]] std::string problem(const std::string& more = "") const {
    const Texts problems = files.problems(profiled(from_depths + more));
    const std::string head = "scene.toml:22:30: float.nc: ";
    return problems.size() == 1 && problems[0].starts_with(head) ? problems[0].substr(head.size())
                                                                 : "another number of problems";
  }

  WrittenFiles files;
};

const std::vector<double> two{0, 0, 0, 1, 1, 1};
const std::string first = ", profile = 0", second = ", profile = 1";
const std::string choice = " (choose one of them: profile = 0 or 1)";

// --- Names ---------------------------------------------------------------------------------------

// Seen red: without a search for such variables; with the first cast for none.
TEST(NetcdfCasts, AreDividedByNumbersAndNames) {
  for (const char* name : {"profile_index", "cycle_number", "CYCLE_NUMBER", "profile_id", "cast",
                           "station", "trajectory", "ProfileNumber"}) {
    CastsFile file;
    file.add(name, two);
    EXPECT_EQ(file.problem(),
              "CHLA(z): holds 2 casts, divided by " + std::string(name) + " (0, 1)" + choice);
    EXPECT_EQ(file.mean(first), 0.1);
    EXPECT_EQ(file.mean(second), 2);
    EXPECT_EQ(file.problem(", profile = 2"),
              "CHLA(z): there is no profile 2: it has 2, counted from 0" + choice);
  }
  CastsFile file;
  file.add("anything", two);
  file.attribute("anything", "cf_role") = "profile_id";
  EXPECT_EQ(file.problem(), "CHLA(z): holds 2 casts, divided by anything (0, 1)" + choice);
}

// Whatever the order of the file is. Seen red: with casts in the order of the file.
TEST(NetcdfCasts, AreNumberedInTheOrderOfTheirNames) {
  CastsFile file;
  file.add("cycle_number", {58, 58, 58, 7, 7, 7});
  EXPECT_EQ(file.problem(), "CHLA(z): holds 2 casts, divided by cycle_number (7, 58)" + choice);
  EXPECT_EQ(file.mean(first), 2);
  EXPECT_EQ(remarks_of(file.files, file.read(second)),
            (Texts{"profile 1 is that of cycle_number 58"}));
  file.add("cycle_number", {58, 7, 58, 7, 58, 7});
  file.files.netcdf["CHLA"].value = {0.1, 2, 0.1, 2, 0.1, 2};
  file.files.netcdf["z"].value = {0, 0, 10, 10, 20, 20};
  EXPECT_EQ(remarks_of(file.files, file.read(second)).size(), 1U);
  EXPECT_EQ(file.mean(second), 0.1);
}

// Seen red: with the first of these variables alone.
TEST(NetcdfCasts, AreDividedByAllThatDiffers) {
  CastsFile file;
  file.add("cycle_number", {5, 5, 5, 5, 5, 5});
  file.add_words("direction", "AAADDD");
  file.add("wind_direction", {0, 10, 20, 30, 40, 50});
  EXPECT_EQ(file.problem(), "CHLA(z): holds 2 casts, divided by direction (\"A\", \"D\")" + choice);
  EXPECT_EQ(file.mean(second), 2);
  file.add("cycle_number", {5, 5, 6, 6, 6, 6});
  EXPECT_EQ(file.problem(),
            "CHLA(z): holds 3 casts, divided by cycle_number and direction (choose one of them: "
            "profile = 0 to 2)");
  EXPECT_EQ(remarks_of(file.files, file.read(", profile = 2")).front(),
            "profile 2 is that of cycle_number 6 and direction \"D\"");
}

// Seen red: with values of no cast in the first one; with a profile for every half.
TEST(NetcdfCasts, LeaveOutWhatIsBetweenThem) {
  CastsFile file;
  for (const double between : {none, 0.5}) {
    file.add("profile_index", {0, between, 0, 1, 1, 1});
    file.files.netcdf["CHLA"].value[1] = 9;
    EXPECT_EQ(
        remarks_of(file.files, file.read(first)),
        (Texts{"1 of 6 values of CHLA belong to no cast by profile_index (0, 1), and are left "
               "out",
               "profile 0 is that of profile_index 0"}));
    EXPECT_EQ(file.mean(first), 0.1);
  }
}

TEST(NetcdfCasts, OfOneAreNotChosen) {
  CastsFile file;
  write_depths(file.files, {0, 10, 20}, {0.1, 0.2, 0.3});
  for (const std::vector<double>& index : {std::vector<double>{3, 3, 3}, {none, none, none}}) {
    file.add("profile_index", index);
    EXPECT_EQ(remarks_of(file.files, file.read()), Texts{});
    EXPECT_EQ(file.mean(first), 0.2);
    EXPECT_EQ(file.problem(second), "CHLA(z): there is no profile 1: it has 1, counted from 0");
  }
}

// Where each variable has a dimension of its own. Seen red: with variables of other dimensions
// never looked at.
TEST(NetcdfCasts, AreFoundInFilesWithADimensionForEachVariable) {
  CastsFile file;
  file.files.netcdf["CHLA"].dimension = {"chla"};
  file.add("profile_index", two, "index");
  EXPECT_EQ(file.problem(), "CHLA(chla): holds 2 casts, divided by profile_index (0, 1)" + choice);
}

// --- Times and places ----------------------------------------------------------------------------

// Seen red: without times; with every time a cast, as samples of one have them.
TEST(NetcdfCasts, AreDividedByTimesThatCoverTheSameDepths) {
  CastsFile file;
  file.add("time", {3, 3, 3, 4.5, 4.5, 4.5});
  EXPECT_EQ(file.problem(), "CHLA(z): holds 2 casts, divided by time (3, 4.5)" + choice);
  EXPECT_EQ(file.mean(second), 2);
  file.files.netcdf.erase("time");
  file.add("y", {30, 30, 30, 40, 40, 40});
  file.attribute("y", "standard_name") = "latitude";
  EXPECT_EQ(file.problem(), "CHLA(z): holds 2 casts, divided by y (30, 40)" + choice);
  file.files.netcdf.erase("y");
  for (const std::vector<double>& samples :
       {std::vector<double>{1, 2, 3, 4, 5, 6}, {1, 1, 2, 2, 3, 3}}) {
    file.files.netcdf["z"].value = {0, 4, 8, 12, 16, 20};
    file.add("time", samples);
    EXPECT_EQ(remarks_of(file.files, file.read()), Texts{});
  }
}

// A ship's stations, of which each sample has its own time; floats with several casts each. Seen
// red: with times and places together alone; with those of one float not divided.
TEST(NetcdfCasts, AreDividedByWhatIsTheSameInACast) {
  CastsFile file;
  file.add("time", {1, 2, 3, 4, 5, 6});
  file.add("latitude", {30, 30, 30, 40, 40, 40});
  EXPECT_EQ(file.problem(), "CHLA(z): holds 2 casts, divided by latitude (30, 40)" + choice);
  write_depths(file.files, {0, 20, 0, 20, 0, 20}, {1, 1, 2, 2, 3, 3});
  file.add("platform", {7, 7, 7, 7, 8, 8});
  file.add("time", {1, 1, 2, 2, 1, 1});
  file.files.netcdf.erase("latitude");
  EXPECT_EQ(file.problem(),
            "CHLA(z): holds 3 casts, divided by platform and time (choose one of them: profile = 0 "
            "to 2)");
  EXPECT_EQ(file.mean(second), 2);
}

// --- Ragged arrays (CF-1.10, section 9.3) --------------------------------------------------------

// Seen red: without the attribute; with casts numbered by those that have values.
TEST(NetcdfCasts, AreCounted) {
  CastsFile file;
  file.add("rowSize", {3, 0, 3}, "cast");
  file.attribute("rowSize", "sample_dimension") = "z";
  EXPECT_EQ(file.problem(),
            "CHLA(z): holds 3 casts, divided by rowSize (choose one of them: profile = 0 to 2)");
  EXPECT_EQ(file.mean(first), 0.1);
  EXPECT_EQ(file.mean(", profile = 2"), 2);
  EXPECT_EQ(file.problem(second),
            "CHLA: profile 1 has values at 0 of 0 levels; it takes two (the first profile with "
            "values is 0)");
  EXPECT_EQ(remarks_of(file.files, file.read(first)), Texts{});
}

// Seen red: with sums, fractions and second counts not looked at.
TEST(NetcdfCasts, CountsThatAreWrong) {
  CastsFile file;
  const auto problem = [&](const std::vector<double>& counts) {
    file.add("rowSize", counts, "cast");
    return file.problem(first);
  };
  file.attribute("rowSize", "sample_dimension") = "z";
  const auto sum = [](const std::string& total) {
    return "rowSize: its counts add up to " + total +
           ", and the dimension z has 6 values (each value belongs to one cast)";
  };
  EXPECT_EQ(problem({3, 2}), sum("5"));
  EXPECT_EQ(problem({3, 4}), sum("7"));
  EXPECT_EQ(problem({1e300, 3}), sum("1e+300"));
  EXPECT_EQ(problem({-1, 7}), "rowSize[0]: must be a whole number, at least 0, not -1");
  EXPECT_EQ(problem({2.5, 3.5}), "rowSize[0]: must be a whole number, at least 0, not 2.5");
  EXPECT_EQ(problem({3, none}), "rowSize[1]: must be a whole number, at least 0, not nan");
  file.add("others", {6}, "cast");
  file.attribute("others", "sample_dimension") = "z";
  EXPECT_EQ(problem({3, 3}),
            "rowSize: counts the values of z, as others does (one variable has the attribute "
            "sample_dimension)");
}

// Seen red: without the attribute; with casts numbered by the indices that appear.
TEST(NetcdfCasts, AreIndexed) {
  CastsFile file;
  file.add("latitude", {30, 40, 50}, "station");
  file.add("parent", {2, 2, 2, 0, 0, 0});
  file.attribute("parent", "instance_dimension") = "station";
  EXPECT_EQ(file.problem(),
            "CHLA(z): holds 3 casts, divided by parent (choose one of them: profile = 0 to 2)");
  EXPECT_EQ(file.mean(", profile = 2"), 0.1);
  EXPECT_EQ(file.mean(first), 2);
  file.add("parent", {2, none, 2, 0, 0, 0});
  EXPECT_EQ(remarks_of(file.files, file.read(", profile = 2")),
            (Texts{"1 of 6 values of CHLA belong to no cast by parent, and are left out"}));
}

// Seen red: with each of the checks left out.
TEST(NetcdfCasts, IndicesThatPointOutside) {
  CastsFile file;
  file.add("latitude", {30, 40}, "station");
  file.attribute("parent", "instance_dimension") = "station";
  for (const auto& [index, text] :
       {std::pair{2.0, "2"}, std::pair{-1.0, "-1"}, std::pair{0.5, "0.5"}}) {
    file.add("parent", {0, 0, 0, 1, 1, index});
    EXPECT_EQ(file.problem(first), "parent[5]: " + std::string(text) +
                                       " is no index of station, which has 2, counted from 0");
  }
  file.add("parent", two);
  file.attribute("parent", "instance_dimension") = "stations";
  EXPECT_EQ(file.problem(first),
            "parent: its instance_dimension is \"stations\", which the file does not have");
}

// A glider's dives in a ragged array of its missions. Seen red: with missions for dives.
TEST(NetcdfCasts, MayBePartsOfRaggedArrays) {
  CastsFile file;
  file.add("rowSize", {6}, "mission");
  file.attribute("rowSize", "sample_dimension") = "z";
  file.add("profile_index", two);
  EXPECT_EQ(file.problem(),
            "CHLA(z): holds 2 casts, divided by rowSize and profile_index" + choice);
  EXPECT_EQ(file.mean(second), 2);
}

// Seen red: with the first latitude for all casts, of values and of casts.
TEST(NetcdfCasts, HaveTheirOwnLatitudes) {
  CastsFile file;
  file.files.netcdf["z"].units = "decibar";
  file.add("cycle_number", two);
  const auto layer = [&](const std::string& more) {
    const Texts problems = file.files.problems(profiled(from_depths + more));
    const std::size_t at = problems.at(0).find("from 0 to ");
    return std::stod(problems[0].substr(at + 10));
  };
  file.add("latitude", {10, 10, 10, 80, 80, 80});
  EXPECT_NEAR(layer(second), optics::depth_of_pressure_m(20, 80), 1e-4);
  file.files.netcdf["latitude"] = {{"cast"}, {2}, "", {80, 10}};
  EXPECT_NEAR(layer(second), optics::depth_of_pressure_m(20, 10), 1e-4);
}

// --- Two dimensions ------------------------------------------------------------------------------

// Each row a glider's mission. Seen red: with the dives of a row averaged.
TEST(NetcdfCasts, MayShareRows) {
  CastsFile file;
  file.files.netcdf["z"] = {{"mission", "obs"}, {2, 3}, "m", {0, 20, 0, 20, 0, 20}};
  file.files.netcdf["CHLA"] = {{"mission", "obs"}, {2, 3}, "mg/m3", {1, 1, 2, 2, 3, 3}};
  EXPECT_EQ(file.mean(first), 1.25);
  file.files.netcdf["profile_index"] = {{"mission", "obs"}, {2, 3}, "", {0, 0, 1, 1, 0, 0}};
  EXPECT_EQ(
      file.problem(),
      "CHLA(mission, obs): holds 4 casts, divided by mission and profile_index (choose one of "
      "them: profile = 0 to 3)");
  EXPECT_EQ(file.mean(first), 1);
  EXPECT_EQ(file.mean(", profile = 2"), 3);
}

// Seen red: with the number of dimensions compared.
TEST(NetcdfCasts, DimensionsOfLengthOneDoNotCount) {
  CastsFile file;
  file.files.netcdf["z"] = {{"depth"}, {3}, "m", {0, 10, 20}};
  file.files.netcdf["CHLA"] = {
      {"time", "depth", "latitude", "longitude"}, {1, 3, 1, 1}, "mg/m3", {0.1, 0.2, 0.3}};
  EXPECT_EQ(file.mean(""), 0.2);
  file.files.netcdf["CHLA"].value[1] = -1;
  EXPECT_EQ(file.problem(),
            "CHLA[0, 1, 0, 0]: must be a finite number, at least 0, not -1 (negative = \"zero\" "
            "counts values below 0 as 0)");
  file.files.netcdf["CHLA"].value[1] = 0.2;
  file.files.netcdf["z"].dimension = {"depth", "station"};
  file.files.netcdf["z"].length = {3, 1};
  EXPECT_EQ(file.mean(""), 0.2);
  file.add("chla_qc", {1, 4, 1}, "depth");
  EXPECT_EQ(remarks_of(file.files, file.read()).size(), 2U);
}

// But levels do: five profiles of one level are no profile of five. Seen red: with every
// dimension of length one dropped.
TEST(NetcdfCasts, ProfilesOfOneLevelAreNoProfile) {
  CastsFile file;
  for (const char* name : {"z", "CHLA"}) {
    file.files.netcdf[name].dimension = {"N_PROF", "N_LEVELS"};
    file.files.netcdf[name].length = {6, 1};
  }
  EXPECT_EQ(file.problem(),
            "CHLA: profile 0 has values at 1 of 1 levels; it takes two (no profile has values)");
}

TEST(NetcdfCasts, DimensionsThatAreNotUnderstood) {
  CastsFile file;
  auto& variable = file.files.netcdf["CHLA"];
  variable = {{"time", "z", "lat"}, {2, 6, 2}, "mg/m3", std::vector<double>(24, 1)};
  EXPECT_EQ(file.problem(),
            "CHLA(time, z, lat): has 3 dimensions longer than one, not (levels) or (profiles, "
            "levels) (one place or one time has to be cut out of it)");
  variable = {{"z", "z"}, {6, 6}, "mg/m3", std::vector<double>(36, 1)};
  EXPECT_EQ(file.problem(),
            "CHLA(z, z): has its levels first, and z(z) has them last (dimensions are (profiles, "
            "levels))");
  for (const char* name : {"z", "CHLA"})
    file.files.netcdf[name] = {{"depth", "time"}, {2, 3}, "m", {0, 0, 0, 20, 20, 20}};
  EXPECT_EQ(file.problem(),
            "CHLA(depth, time): has its levels first (dimensions are (profiles, levels))");
  variable = {{"time"}, {3}, "mg/m3", {1, 1, 1}};
  EXPECT_EQ(file.problem(), "z(depth, time): has a dimension that CHLA(time) lacks");
}

}  // namespace
}  // namespace photic::scene
