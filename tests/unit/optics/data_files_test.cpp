// The tables that come with Photic: each one is read strictly and says where it comes from.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(data_folder)) {
    if (entry.path().extension() == ".csv") out.push_back(entry.path());
  }
  return out;
}

bool is_text(const std::string& column) {
  return column == "item" || column == "source" || column == "status" || column == "unit" ||
         column == "origin" || column == "component" || column == "class";
}

bool known_status(const std::string& status) {
  return status.starts_with("verified") || status.starts_with("from memory") ||
         status.starts_with("placeholder");
}

TEST(DataFiles, EachIsStrictAndHasItsSource) {
  ASSERT_EQ(files().size(), 36U);
  for (const fs::path& file : files()) {
    SCOPED_TRACE(file);
    const DataTable table = DataTable::read(file.string());
    EXPECT_FALSE(table.header("SOURCE").empty());
    EXPECT_FALSE(table.header("UNITS").empty());
    EXPECT_TRUE(known_status(table.header("STATUS"))) << table.header("STATUS");
    for (const std::string& column : table.columns()) {
      if (is_text(column)) {
        for (const std::string& text : table.texts(column)) EXPECT_FALSE(text.empty()) << column;
      } else if (column == table.columns().front() && column != "weight") {
        const bool altitude = column == "z_km";  // which may begin at the sea
        EXPECT_GE(table.ascending_numbers(column).front(), altitude ? 0 : 1e-9);
      } else {
        EXPECT_EQ(table.numbers(column).size(), table.rows());
      }
      if (column == "status") {
        for (const std::string& text : table.texts(column)) EXPECT_TRUE(known_status(text)) << text;
      }
    }
  }
}

TEST(DataFiles, TheReadmeNamesEach) {
  std::ifstream file(data_folder + "/README.md");
  std::stringstream readme;
  readme << file.rdbuf();
  for (const fs::path& path : files()) {
    expect_contains(readme.str(), fmt::format("`{}`", fs::relative(path, data_folder).string()));
  }
}

TEST(DataFiles, WhatIsFromMemorySaysSoToTheUser) {
  expect_contains(library().fluorescence.at("chlorophyll_excitation_min").source, "[from memory]");
  expect_contains(library().raman.at("bartlett_b_488_nm").source, "from memory; 20 %]");
}

class DamagedData : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::copy(data_folder, folder_, fs::copy_options::recursive);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What loading says once `file` holds `text`.
  std::string loading_with(const std::string& file, const std::string& text) {
    std::ofstream(folder_ / file) << text;
    return message<EnvironmentError>([&] { Library{folder_.string()}; });
  }

  fs::path folder_ = scratch_folder("photic_damaged_data");
};

TEST_F(DamagedData, IsAFailedEnvironmentWithFileAndLine) {
  expect_contains(
      loading_with("water_ioccg_2018.csv",
                   "# SOURCE: a\n# STATUS: verified\nwavelength_nm,a_per_m\n200,1\n200,2\n"),
      "water_ioccg_2018.csv:5:1: wavelength_nm 200 is not above the 200 before it");
  expect_contains(loading_with("water_ioccg_2018.csv",
                               "# SOURCE: a\n# STATUS: verified\nwavelength_nm,a_per_m\n200,1\n"),
                  "water_ioccg_2018.csv:4:1: a spectrum needs two rows or more");
  fs::copy_file(data_folder + "/water_ioccg_2018.csv", folder_ / "water_ioccg_2018.csv",
                fs::copy_options::overwrite_existing);
  expect_contains(loading_with("raman_parameters.csv",
                               "item,value,source,status\na,1,b,c\ndepolarisation,2,b,c\n"),
                  "raman_parameters.csv:3:16: a depolarisation is from 0 to 1");
}

TEST_F(DamagedData, WithoutASourceIsRefused) {
  expect_contains(loading_with("water_ioccg_2018.csv", "wavelength_nm,a_per_m\n200,1\n300,2\n"),
                  "water_ioccg_2018.csv:1:1: no line \"# STATUS: …\"");
}

TEST_F(DamagedData, AMissingFileIsNamed) {
  fs::remove(folder_ / "particles_petzold_average.csv");
  expect_contains(message<EnvironmentError>([&] { Library{folder_.string()}; }),
                  "particles_petzold_average.csv: cannot be read");
}

TEST_F(DamagedData, AMissingParameterIsNamed) {
  std::ofstream(folder_ / "fluorescence_parameters.csv")
      << "item,value,unit,source,status\nx,1,nm,a,verified\n";
  const Library damaged(folder_.string());
  expect_contains(message<EnvironmentError>([&] {
                    static_cast<void>(damaged.fluorescence.at("chlorophyll_emission_centre"));
                  }),
                  "fluorescence_parameters.csv: no item \"chlorophyll_emission_centre\"");
}

}  // namespace
}  // namespace photic::optics
