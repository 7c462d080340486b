#include <gtest/gtest.h>
#include <netcdf.h>

#include "core/error.hpp"
#include "io/netcdf.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using test::TemporaryFolder;

template <class Error>
std::string error_of(const std::string& path) {
  try {
    return "no error: " + read_scene_attribute(path);
  } catch (const Error& error) {
    return error.what();
  }
}

/// A netCDF file whose photic_format is `format`, or that has none if that is 0; with no scene.
void write_other(const std::string& path, int format) {
  int file = 0;
  ASSERT_EQ(nc_create(path.c_str(), NC_NETCDF4, &file), NC_NOERR);
  if (format > 0) {
    ASSERT_EQ(nc_put_att_int(file, NC_GLOBAL, "photic_format", NC_INT, 1, &format), NC_NOERR);
  }
  ASSERT_EQ(nc_close(file), NC_NOERR);
}

TEST(ReadScene, ReturnsTheText) {
  const TemporaryFolder folder;
  const tally::Result result = test::sample_result();
  write_netcdf(result, folder.file("out.nc"), {"test"});
  EXPECT_EQ(read_scene_attribute(folder.file("out.nc")), result.scene_toml);
}

TEST(ReadScene, MissingFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none.nc");
  EXPECT_EQ(
      error_of<InputError>(path),
      path + ": there is no such file (a result is what `photic run SCENE -o out.nc` writes)");
}

TEST(ReadScene, Directory) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      error_of<InputError>(folder.file(".")),
      folder.file(".") + ": not a file (a result is what `photic run SCENE -o out.nc` writes)");
}

TEST(ReadScene, NotNetcdf) {
  const TemporaryFolder folder;
  const std::string path = folder.file("notes.nc");
  test::write_file(path, "these are notes");
  EXPECT_EQ(error_of<InputError>(path), path + ": not a netCDF file" + test::wanted_result);
}

TEST(ReadScene, Torn) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.nc");
  write_netcdf(test::sample_result(), path, {"test"});
  std::filesystem::resize_file(path, 3000);
  const std::string error = error_of<InputError>(path);
  EXPECT_EQ(error.rfind(path + ": a damaged netCDF file: ", 0), 0u) << error;
}

TEST(ReadScene, SomeoneElsesNetcdf) {
  const TemporaryFolder folder;
  const std::string path = folder.file("sst.nc");
  write_other(path, 0);
  EXPECT_EQ(error_of<InputError>(path),
            path +
                ": a netCDF file, but not a result of Photic: it has no attribute photic_format" +
                test::wanted_result);
}

TEST(ReadScene, NewerFormat) {
  const TemporaryFolder folder;
  const std::string path = folder.file("new.nc");
  write_other(path, 4);
  EXPECT_EQ(error_of<InputError>(path),
            path +
                ": written by a newer Photic (result format 4; this program reads up to 3) "
                "(use the newer Photic)");
}

TEST(ReadScene, WithoutScene) {
  const TemporaryFolder folder;
  const std::string path = folder.file("bare.nc");
  write_other(path, 1);
  EXPECT_EQ(
      error_of<InputError>(path),
      path + ": a damaged result: it has no attribute scene that is a text" + test::wanted_result);
}

}  // namespace
}  // namespace photic::io
