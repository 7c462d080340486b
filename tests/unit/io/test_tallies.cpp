// Quantities beside echoes in result files, which a run can continue.
#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "io/netcdf.hpp"
#include "unit/io/netcdf_file.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/sample_tallies.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using test::NetcdfFile;
using Names = std::vector<std::string>;

class WrittenTallies : public testing::Test {
 protected:
  static tally::Result beside_echoes() {
    tally::Result result = test::sample_result();
    test::add_sample_tallies(result);
    return result;
  }
  void write() { write_netcdf(result_, path_, {"a test"}); }

  test::TemporaryFolder folder_;
  tally::Result result_ = beside_echoes();
  std::string path_ = folder_.file("out.nc");
};

// Seen red: with the mean in the place of the error; without flags.
TEST_F(WrittenTallies, ValuesErrorsAndFlags) {
  write();
  const NetcdfFile file(path_);
  for (const tally::TallyEstimates& tally : result_.tallies) {
    const std::string& name = tally.grid.name;
    SCOPED_TRACE(name);
    EXPECT_EQ(file.numbers(name), std::vector<double>(tally.mean.begin(), tally.mean.end()));
    EXPECT_EQ(file.numbers(name + "_standard_error"),
              std::vector<double>(tally.standard_error.begin(), tally.standard_error.end()));
    EXPECT_EQ(file.numbers(name + "_convergence_flags"),
              std::vector<double>(tally.flags.begin(), tally.flags.end()));
    Names dimensions;
    for (const tally::Dimension& each : tally.grid.dimensions) dimensions.push_back(each.name);
    for (const char* end : {"", "_standard_error", "_converged", "_convergence_flags"})
      EXPECT_EQ(file.dimensions(file.variable(name + end)), dimensions);
    const int v = file.variable(name);
    EXPECT_EQ(file.text(v, "long_name"), tally.grid.long_name);
    EXPECT_EQ(file.text(v, "units"), tally.grid.units);
    EXPECT_EQ(file.text(v, "normalisation"), "per unit irradiance across the beam");
    EXPECT_EQ(file.attribute<double>(v, "strength_scale"), std::vector<double>{50});
    EXPECT_EQ(file.text(v, "strength_units"), tally.grid.by_strength->units);
    EXPECT_EQ(file.text(v, "ancillary_variables"),
              name + "_standard_error " + name + "_converged " + name + "_convergence_flags");
  }
  EXPECT_EQ(file.attribute<double>(NC_GLOBAL, "source_strength"), std::vector<double>{50});
  EXPECT_EQ(file.text("source_strength_units"), "W m-2");
}

// Seen red: with the edges' start in the place of the centre.
TEST_F(WrittenTallies, Coordinates) {
  write();
  const NetcdfFile file(path_);
  EXPECT_EQ(file.numbers("level_depth"), (std::vector<double>{-10, 0, 2, 5, 10, 20, 40, 60}));
  EXPECT_EQ(file.text(file.variable("level_depth"), "positive"), "down");
  EXPECT_EQ(file.numbers("direction_zenith"), (std::vector<double>{0, 30, 180}));
  EXPECT_EQ(file.texts("layer_name"), (Names{"upper", "lower", "haze"}));
  EXPECT_EQ(file.numbers("escape_zenith").at(8), 85);
  EXPECT_EQ(file.text(file.variable("escape_zenith"), "bounds"), "escape_zenith_bounds");
  EXPECT_EQ(file.numbers("escape_zenith_bounds").at(17), 90);
  EXPECT_EQ(file.text(file.variable("absorbed"), "coordinates"), "layer_name constituent_name");
  EXPECT_EQ(file.text(file.variable("irradiance_up"), "coordinates"), "level_depth");
  EXPECT_FALSE(file.has_attribute(file.variable("balance"), "coordinates"));
}

// Seen red: with a strength of 0 where there is none.
TEST_F(WrittenTallies, WithoutAStrength) {
  result_.source_strength.reset();
  for (tally::TallyEstimates& tally : result_.tallies) tally.grid.by_strength.reset();
  write();
  const NetcdfFile file(path_);
  EXPECT_FALSE(file.has_attribute(NC_GLOBAL, "source_strength"));
  EXPECT_FALSE(file.has_attribute(NC_GLOBAL, "source_strength_units"));
  EXPECT_FALSE(file.has_attribute(file.variable("balance"), "strength_scale"));
}

TEST_F(WrittenTallies, ThatDoNotFitAreABug) {
  result_.tallies[1].grid.dimensions[0].coordinates[0].values[0] = -11;
  EXPECT_THROW(write(), ContractViolation);  // the dimension of the tally before it
  result_ = beside_echoes();
  result_.tallies[2].mean.pop_back();
  EXPECT_THROW(write(), ContractViolation);
}

// Seen red: with telescopes written in any case, "a dimension of at least 1".
TEST_F(WrittenTallies, WithoutEchoes) {
  result_ = test::sample_tallies_alone();
  EXPECT_EQ(result_.gates(), 0u);
  write();
  const NetcdfFile file(path_);
  for (const std::string& name : file.variables())
    for (const char* part : {"echo", "gate", "telescope", "channel", "order", "process"})
      EXPECT_EQ(name.find(part), std::string::npos) << name;
  int id = 0;
  for (const char* name : {"telescope", "channel", "gate", "order", "process"})
    EXPECT_EQ(nc_inq_dimid(file.id(), name, &id), NC_EBADDIM) << name;
  EXPECT_TRUE(file.has_variable("irradiance_down"));
  EXPECT_EQ(read_scene_attribute(path_), result_.scene_toml);
  EXPECT_EQ(read_run(path_).photons, 2'000'000u);
}

// Seen red: without the largest score; with the fields of the tail in another order in the reader.
TEST_F(WrittenTallies, StateComesBackToTheLastBit) {
  result_.state->tallies[5].scored.power[3] = std::numeric_limits<double>::denorm_min();
  result_.state->tally_octaves[7][127] = std::numeric_limits<std::uint64_t>::max();
  write();
  tally::Shape shape = test::sample_shape();
  shape.tallies = test::sample_tally_grids();
  EXPECT_EQ(read_state(path_, shape), *result_.state);
  result_.state = tally::TotalsState(shape);  // of no batch yet
  write();
  EXPECT_EQ(read_state(path_, shape), *result_.state);
}

// Seen red: with the sums of echoes described in any case.
TEST_F(WrittenTallies, StateWithoutEchoesComesBackToTheLastBit) {
  result_ = test::sample_tallies_alone();
  write();
  EXPECT_EQ(read_state(path_, test::sample_shape_of_tallies_alone()), *result_.state);
}

// Seen red: with the number of cells of the file taken for the scene's.
TEST_F(WrittenTallies, StateOfOtherTalliesIsRefused) {
  write();
  tally::Shape shape = test::sample_shape();
  shape.tallies = test::sample_tally_grids();
  shape.tallies.pop_back();
  EXPECT_THROW(read_state(path_, shape), InputError);
  write_netcdf(test::sample_result(), path_, {"a test"});  // as an older program writes it
  EXPECT_THROW(read_state(path_, shape), InputError);
}

}  // namespace
}  // namespace photic::io
