#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <span>

#include "core/error.hpp"
#include "io/netcdf.hpp"
#include "unit/io/netcdf_file.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using test::expect_same;
using test::NetcdfFile;

class WrittenResult : public testing::Test {
 protected:
  WrittenResult() : result_(test::sample_result()) {
    // What a double could not hold.
    result_.photons = (std::uint64_t{1} << 63) + 12345;
    result_.seed = (std::uint64_t{1} << 53) + 1;
    result_.scene_toml = fmt::format("{:x>300000}häß\n", "");  // g++ 12 sees an overrun in a sum
    result_.partial = true;
    write_netcdf(result_, folder_.file("out.nc"), {"then: photic run"});
  }

  test::TemporaryFolder folder_;
  tally::Result result_;
};

TEST_F(WrittenResult, Axes) {
  const NetcdfFile file(folder_.file("out.nc"));
  EXPECT_EQ(file.size("telescope"), 2u);
  EXPECT_EQ(file.size("channel"), 3u);
  EXPECT_EQ(file.size("process"), 3u);
  EXPECT_EQ(file.size("order"), 7u);
  EXPECT_EQ(file.size("gate"), 100u);
  EXPECT_EQ(file.size("depth"), 100u);
  EXPECT_EQ(file.size("bnds"), 2u);
  EXPECT_EQ(file.texts("telescope_name"), result_.telescope_name);
  EXPECT_EQ(file.texts("channel_name"), result_.channel_name);
  EXPECT_EQ(file.texts("process_name"), result_.process_names());
  expect_same(file.numbers("channel_wavelength"), result_.channel_wavelength_nm);
  expect_same(file.numbers("order"), std::vector<double>{0, 1, 2, 3, 4, 5, 6});
}

TEST_F(WrittenResult, Gates) {
  const NetcdfFile file(folder_.file("out.nc"));
  const auto time = file.numbers("gate_time"), time_bounds = file.numbers("gate_time_bounds");
  const auto depth = file.numbers("depth"), depth_bounds = file.numbers("depth_bounds");
  const auto gate_depth = file.numbers("gate_depth"),
             gate_bounds = file.numbers("gate_depth_bounds");
  ASSERT_EQ(gate_depth.size(), 600u);
  const auto& edges = result_.grid("echo_by_depth").grid.axes.front().edges;
  for (std::size_t k = 0; k < 100; ++k) {
    EXPECT_EQ(time_bounds[2 * k], result_.gate_time_edge_ns[k]);
    EXPECT_EQ(time_bounds[2 * k + 1], result_.gate_time_edge_ns[k + 1]);
    EXPECT_EQ(time[k], 0.5 * (result_.gate_time_edge_ns[k] + result_.gate_time_edge_ns[k + 1]));
    EXPECT_EQ(depth_bounds[2 * k], edges[k]);
    EXPECT_EQ(depth_bounds[2 * k + 1], edges[k + 1]);
    EXPECT_EQ(depth[k], 0.5 * (edges[k] + edges[k + 1]));
    for (std::size_t row = 0; row < 6; ++row) {
      const double* edge = &result_.gate_depth_edge_m[101 * row + k];
      EXPECT_EQ(gate_bounds[2 * (100 * row + k)], edge[0]);
      EXPECT_EQ(gate_bounds[2 * (100 * row + k) + 1], edge[1]);
      EXPECT_EQ(gate_depth[100 * row + k], 0.5 * (edge[0] + edge[1]));
    }
  }
  EXPECT_EQ(file.dimensions(file.variable("gate_depth")), (Names{"telescope", "channel", "gate"}));
}

// Seen red: writing the mean in the place of the standard error.
TEST_F(WrittenResult, Estimates) {
  const NetcdfFile file(folder_.file("out.nc"));
  std::map<std::string, const tally::Estimates*> all{{"echo", &result_.echo}};
  for (const tally::GridEstimates& grid : result_.grids) all[grid.grid.name] = &grid;
  EXPECT_EQ(all.size(), 4U);
  for (const auto& [name, estimates] : all) {
    SCOPED_TRACE(name);
    const bool single = name == "echo_by_depth";
    const auto stored = [&](const ZeroedVector<double>& numbers) {
      std::vector<double> out(numbers.begin(), numbers.end());
      for (double& x : out) x = single ? static_cast<float>(x) : x;
      return out;
    };
    expect_same(file.numbers(name), stored(estimates->mean));
    expect_same(file.numbers(name + "_standard_error"), stored(estimates->standard_error));
  }
  EXPECT_EQ(file.type(file.variable("echo_by_depth")), NC_FLOAT);
  EXPECT_EQ(file.dimensions(file.variable("echo")), (Names{"telescope", "channel", "gate"}));
  EXPECT_EQ(file.dimensions(file.variable("echo_by_process")),
            (Names{"telescope", "channel", "process", "gate"}));
  EXPECT_EQ(file.dimensions(file.variable("echo_by_order")),
            (Names{"telescope", "channel", "order", "gate"}));
  EXPECT_EQ(file.dimensions(file.variable("echo_by_depth")),
            (Names{"telescope", "channel", "gate", "depth"}));
}

TEST_F(WrittenResult, Convergence) {
  const NetcdfFile file(folder_.file("out.nc"));
  const std::vector<double> flags(result_.convergence_flags.begin(),
                                  result_.convergence_flags.end());
  expect_same(file.numbers("convergence_flags"), flags);
  std::vector<double> converged;
  for (const double flag : flags) converged.push_back(flag == 0 ? 1 : 0);
  expect_same(file.numbers("converged"), converged);
  const std::vector<double> photons(result_.channel_photons.begin(), result_.channel_photons.end());
  expect_same(file.numbers("channel_photons"), photons);
  expect_same(file.numbers("largest_score_share"), result_.largest_score_share);
  expect_same(file.numbers("variance_of_variance"), result_.variance_of_variance);
  expect_same(file.numbers("error_growth"), result_.error_growth);
  expect_same(file.numbers("order_cut_share"), result_.order_cut_share);
}

TEST_F(WrittenResult, ConvergenceOfParts) {
  const NetcdfFile file(folder_.file("out.nc"));
  for (const auto& [name, flags] : {std::pair<std::string, std::vector<std::int32_t>&>{
                                        "echo_by_process", result_.grid("echo_by_process").flags},
                                    {"echo_by_order", result_.grid("echo_by_order").flags}}) {
    EXPECT_EQ(file.dimensions(file.variable(name + "_convergence_flags")),
              file.dimensions(file.variable(name)));
    expect_same(file.numbers(name + "_convergence_flags"),
                std::vector<double>(flags.begin(), flags.end()));
    const auto converged = file.numbers(name + "_converged");
    ASSERT_EQ(converged.size(), flags.size());
    for (std::size_t i = 0; i < flags.size(); ++i) EXPECT_EQ(converged[i] != 0, flags[i] == 0);
  }
}

TEST_F(WrittenResult, FlagMeanings) {
  const NetcdfFile file(folder_.file("out.nc"));
  const int v = file.variable("convergence_flags");
  std::vector<std::int32_t> masks;
  std::string names;
  for (const auto& meaning : tally::flag_meanings()) {
    masks.push_back(meaning.flag);
    if (!names.empty()) names += ' ';
    names += meaning.name;
  }
  EXPECT_EQ(file.attribute<std::int32_t>(v, "flag_masks"), masks);
  EXPECT_EQ(file.text(v, "flag_meanings"), names);
  const int c = file.variable("converged");
  EXPECT_EQ(file.attribute<std::int8_t>(c, "flag_values"), (std::vector<std::int8_t>{0, 1}));
  EXPECT_EQ(file.text(c, "flag_meanings"), "no yes");
}

// Seen red: photons as a double.
TEST_F(WrittenResult, Run) {
  const NetcdfFile file(folder_.file("out.nc"));
  const auto count = [&](const char* name) {
    EXPECT_EQ(file.attribute_type(NC_GLOBAL, name), NC_UINT64) << name;
    return file.attribute<std::uint64_t>(NC_GLOBAL, name).at(0);
  };
  EXPECT_EQ(count("photons"), 9223372036854788153u);
  EXPECT_EQ(count("seed"), 9007199254740993u);
  EXPECT_EQ(count("batches"), result_.batches);
  EXPECT_EQ(count("collisions"), result_.collisions);
  EXPECT_EQ(count("photons_lost_too_many_events"), 2u);
  EXPECT_EQ(count("photons_lost_not_finite"), 1u);
  const auto number = [&](const char* name) {
    return file.attribute<double>(NC_GLOBAL, name).at(0);
  };
  EXPECT_EQ(number("wall_time_s"), 23.5);
  EXPECT_EQ(number("collisions_per_second"), 187'654'321 / 23.5);
  EXPECT_EQ(number("ledger_absorbed"), 0.71);
  EXPECT_EQ(number("ledger_escaped"), 0.08);
  EXPECT_EQ(number("ledger_sea_bed"), 0.015);
  EXPECT_EQ(number("ledger_oil"), 0.005);
  EXPECT_EQ(number("ledger_cut_by_time"), 0.18);
  EXPECT_EQ(number("ledger_cut_by_order"), 0.0099);
  EXPECT_EQ(number("ledger_cut_by_weight"), 1e-4);
  EXPECT_EQ(number("ledger_roulette"), 1e-5);
  EXPECT_EQ(number("ledger_lost"), 1.5e-7);
  const auto integer = [&](const char* name) {
    return file.attribute<std::int32_t>(NC_GLOBAL, name).at(0);
  };
  EXPECT_EQ(integer("photic_format"), 3);
  EXPECT_EQ(integer("partial"), 1);
  EXPECT_EQ(integer("threads"), 2);
}

TEST_F(WrittenResult, Texts) {
  const NetcdfFile file(folder_.file("out.nc"));
  EXPECT_EQ(file.text("Conventions"), "CF-1.10");
  EXPECT_EQ(file.text("title"), result_.title);
  EXPECT_EQ(file.text("source"),
            "Photic 0.1.0: Monte Carlo simulation of an oceanographic lidar, forward estimator");
  EXPECT_EQ(file.text("history"), "then: photic run");
  EXPECT_EQ(file.text("version"), "0.1.0");
  EXPECT_EQ(file.text("engine"), "scalar");
  EXPECT_EQ(file.text("estimator"), "forward");
  EXPECT_EQ(file.text("stopped_by"), "photons");
  EXPECT_EQ(file.text("warnings"), result_.warnings.at(0));
  EXPECT_EQ(file.text("strategies"), result_.strategies.at(0) + "\n" + result_.strategies.at(1));
  EXPECT_EQ(file.text("optics_sources"), result_.sources.at(0) + "\n" + result_.sources.at(1));
  EXPECT_NE(file.text("references").find("Barbini"), std::string::npos);
}

// Seen red: as an attribute of characters, which netCDF-4 limits to 64 kB, the long scene is lost.
TEST_F(WrittenResult, SceneOfAnyLength) {
  EXPECT_EQ(read_scene_attribute(folder_.file("out.nc")), result_.scene_toml);
}

// Seen red: with the difference's error in the place of the echo's; with the scene's flags; with
// the dimension environment after the telescope.
TEST(WrittenEnvironments, EchoesDifferencesAndFlags) {
  const test::TemporaryFolder folder;
  const tally::Result result = test::sample_result_in({"more algae", "häß \"CDOM\""});
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  EXPECT_EQ(file.texts("environment_name"), result.environment_name);
  for (const auto& [name, estimates] :
       {std::pair{"environment_echo", &result.environment_echo},
        {"environment_difference", &result.environment_difference}}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(file.dimensions(file.variable(name)),
              (Names{"environment", "telescope", "channel", "gate"}));
    expect_same(file.numbers(name), estimates->mean);
    expect_same(file.numbers(std::string(name) + "_standard_error"), estimates->standard_error);
  }
  const auto& flags = result.environment_convergence_flags;
  const std::vector<double> bits(flags.begin(), flags.end());
  expect_same(file.numbers("environment_convergence_flags"), bits);
  const auto converged = file.numbers("environment_converged");
  for (std::size_t i = 0; i < flags.size(); ++i) EXPECT_EQ(converged[i] != 0, flags[i] == 0);
}

// Seen red: with the dimensions the other way round.
TEST(WrittenEnvironments, NumbersThatTheySet) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result_in({"more algae", "less", "bloom"});
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  EXPECT_EQ(file.texts("environment_path_name"), result.environment_path);
  EXPECT_EQ(file.dimensions(file.variable("environment_value")),
            (Names{"environment", "environment_path"}));
  expect_same(file.numbers("environment_value"), result.environment_value);
}

// Seen red: with a dimension of no length, which netCDF takes for one without end.
TEST(WrittenEnvironments, ThatSetNoNumbers) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result_in({"data of the paper"});
  result.environment_path.clear();
  result.environment_value.clear();
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  EXPECT_FALSE(file.has_variable("environment_value"));
  int id = 0;
  EXPECT_EQ(nc_inq_dimid(file.id(), "environment_path", &id), NC_EBADDIM);
}

// Seen red, each for itself: with the logarithmic derivative in the place of the other; without
// flags.
TEST(WrittenSensitivities, DerivativesAndFlags) {
  const test::TemporaryFolder folder;
  const tally::Result result = test::sample_result_in({"bloom"}, {"sea.x", "sea.\"häß\".y"});
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  EXPECT_EQ(file.texts("parameter_name"), result.parameter_name);
  EXPECT_EQ(file.numbers("parameter_value"), result.parameter_value);
  EXPECT_EQ(file.texts("environment_name"), result.environment_name);
  for (const auto& [name, estimates] :
       {std::pair{"sensitivity", &result.sensitivity},
        {"logarithmic_sensitivity", &result.logarithmic_sensitivity}}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(file.dimensions(file.variable(name)),
              (Names{"parameter", "telescope", "channel", "gate"}));
    expect_same(file.numbers(name), estimates->mean);
    expect_same(file.numbers(std::string(name) + "_standard_error"), estimates->standard_error);
  }
  const auto& flags = result.sensitivity_convergence_flags;
  const std::vector<double> bits(flags.begin(), flags.end());
  expect_same(file.numbers("sensitivity_convergence_flags"), bits);
  const auto converged = file.numbers("sensitivity_converged");
  for (std::size_t i = 0; i < flags.size(); ++i) EXPECT_EQ(converged[i] != 0, flags[i] == 0);
}

// Seen red: with the dimension added in any case.
TEST(WrittenEnvironments, AreNotInTheFilesOfOtherScenes) {
  const test::TemporaryFolder folder;
  write_netcdf(test::sample_result(), folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  for (const std::string& name : file.variables())
    for (const char* part : {"environment", "parameter", "sensitivity"})
      EXPECT_EQ(name.find(part), std::string::npos) << name;
  int id = 0, group = 0;
  ASSERT_EQ(nc_inq_grp_ncid(file.id(), "continuation", &group), NC_NOERR);
  EXPECT_EQ(nc_inq_dimid(file.id(), "environment", &id), NC_EBADDIM);
  EXPECT_EQ(nc_inq_dimid(file.id(), "parameter", &id), NC_EBADDIM);
  EXPECT_EQ(nc_inq_dimid(group, "other_water", &id), NC_EBADDIM);
  EXPECT_EQ(nc_inq_dimid(group, "environment_sum", &id), NC_EBADDIM);
  EXPECT_EQ(nc_inq_varid(group, "environment_sums", &id), NC_ENOTVAR);
}

TEST(WrittenEnvironments, OneThatDoesNotFitIsABug) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result_in({"more algae"});
  result.environment_name.emplace_back("of no echo");
  EXPECT_THROW(write_netcdf(result, folder.file("out.nc"), {"test"}), ContractViolation);
  result = test::sample_result_in({}, {"sea.x"});
  result.parameter_name.emplace_back("of no derivative");
  EXPECT_THROW(write_netcdf(result, folder.file("out.nc"), {"test"}), ContractViolation);
}

TEST(WriteNetcdf, IsCompressed) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result();
  result.state.reset();  // made up of numbers that nothing compresses
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const std::size_t raw_bytes = 2 * result.grid("echo_by_depth").mean.size() * sizeof(double);
  EXPECT_LT(std::filesystem::file_size(folder.file("out.nc")), raw_bytes / 2);
}

// Seen red: made by nc_create_mem.
TEST(WriteNetcdf, OtherProgramsCanAddToTheFile) {
  const test::TemporaryFolder folder;
  write_netcdf(test::sample_result(), folder.file("out.nc"), {"test"});
  EXPECT_EQ(NetcdfFile(folder.file("out.nc")).variables().front(),
            "telescope_name");  // not by alphabet
  int file = 0;
  ASSERT_EQ(nc_open(folder.file("out.nc").c_str(), NC_WRITE, &file), NC_NOERR);
  EXPECT_EQ(nc_put_att_text(file, NC_GLOBAL, "comment", 5, "added"), NC_NOERR);
  EXPECT_EQ(nc_close(file), NC_NOERR);
  EXPECT_EQ(NetcdfFile(folder.file("out.nc")).text("comment"), "added");
}

// Seen red: with a dimension of no depths, which netCDF takes for one without end.
TEST(WriteNetcdf, DepthsOfTheLastScatteringAreLeftOutWhereTheyAreNotTallied) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result();
  result.grids.pop_back();
  result.state->grids.pop_back();
  write_netcdf(result, folder.file("out.nc"), {"test"});
  for (const auto& name : NetcdfFile(folder.file("out.nc")).variables())
    EXPECT_TRUE(name.rfind("gate_", 0) == 0 || name.find("depth") == std::string::npos) << name;
}

TEST(WriteNetcdf, RangeIsCalledRange) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result();
  result.gate_depth_is_range = true;
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  const int v = file.variable("gate_depth");
  EXPECT_EQ(file.text(v, "long_name").rfind("range along the axis of the telescope", 0), 0u);
  EXPECT_FALSE(file.has_attribute(v, "standard_name"));
  EXPECT_FALSE(file.has_attribute(v, "positive"));
}

TEST(WriteNetcdf, AResultThatDoesNotFitIsABug) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result();
  result.grid("echo_by_order").mean.pop_back();
  EXPECT_THROW(write_netcdf(result, folder.file("out.nc"), {"test"}), ContractViolation);
  EXPECT_TRUE(folder.files().empty());
}

TEST(HistoryLine, TimeInUtcAndCommand) {
  std::string line = history_line("photic run a.toml");
  std::replace_if(
      line.begin(), line.begin() + 20, [](unsigned char c) { return std::isdigit(c) != 0; }, '9');
  EXPECT_EQ(line, "9999-99-99T99:99:99Z: photic run a.toml");
}

}  // namespace
}  // namespace photic::io
