// Echoes by groups of batches, in files.
#include <gtest/gtest.h>

#include "io/netcdf.hpp"
#include "unit/io/netcdf_file.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using Names = std::vector<std::string>;
using test::expect_same;
using test::NetcdfFile;

// Seen red: with the scene's means in the place of the environments'.
TEST(WrittenGroups, MeansAndPhotons) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result_in({"bloom", "no algae"});
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  const Names dimensions{"telescope", "channel", "batch_group", "gate"};
  const Names in_environments{"environment", "telescope", "channel", "batch_group", "gate"};
  EXPECT_EQ(file.numbers("group_photons"), result.by_group.photons);
  EXPECT_EQ(file.dimensions(file.variable("echo_by_group")), dimensions);
  EXPECT_EQ(file.dimensions(file.variable("environment_echo_by_group")), in_environments);
  const auto doubles = [](const ZeroedVector<float>& means) {
    return std::vector<double>(means.begin(), means.end());
  };
  expect_same(file.numbers("echo_by_group"), doubles(result.by_group.echo));
  expect_same(file.numbers("environment_echo_by_group"), doubles(result.by_group.environment_echo));
}

TEST(WrittenGroups, AreNotThereIfNoneAreKept) {
  const test::TemporaryFolder folder;
  tally::Result result = test::sample_result();
  result.by_group = {};
  write_netcdf(result, folder.file("out.nc"), {"test"});
  const NetcdfFile file(folder.file("out.nc"));
  for (const char* name : {"group_photons", "echo_by_group", "environment_echo_by_group"})
    EXPECT_FALSE(file.has_variable(name)) << name;
}

}  // namespace
}  // namespace photic::io
