#include "optics/data_folder.hpp"

#include <cstdlib>
#include <filesystem>

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

namespace fs = std::filesystem;

class DataFolder : public testing::Test {
 protected:
  void SetUp() override { unsetenv("PHOTIC_DATA"); }
  void TearDown() override { unsetenv("PHOTIC_DATA"); }
};

TEST_F(DataFolder, IsTheSourceTreesForAProgramThatIsNotInstalled) {
  EXPECT_TRUE(fs::equivalent(find_data_folder(), data_folder));
}

TEST_F(DataFolder, IsTheOneTheEnvironmentNames) {
  const fs::path folder = scratch_folder("photic_data_folder");
  fs::create_directories(folder);
  fs::copy_file(data_folder + "/water_mason_2016.csv", folder / "water_mason_2016.csv",
                fs::copy_options::overwrite_existing);
  setenv("PHOTIC_DATA", folder.c_str(), 1);
  EXPECT_EQ(find_data_folder(), folder.string());
  fs::remove_all(folder);
}

// A wrong folder is never passed over in silence. Seen red: with the throw removed (the source
// tree's was taken).
TEST_F(DataFolder, IsNotGuessedWhenTheEnvironmentNamesAWrongOne) {
  setenv("PHOTIC_DATA", "/nowhere", 1);
  EXPECT_EQ(message<EnvironmentError>([] { find_data_folder(); }),
            "no data tables in /nowhere (named by PHOTIC_DATA): it has no water_mason_2016.csv");
}

}  // namespace
}  // namespace photic::optics
