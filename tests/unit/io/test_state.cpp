// The state of a run in a result file: back to the last bit, and nothing hostile taken for one.
#include <gtest/gtest.h>
#include <netcdf.h>

#include <functional>
#include <limits>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/netcdf.hpp"
#include "io/netcdf_image.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using Texts = std::vector<std::string>;

class WrittenState : public testing::Test {
 protected:
  WrittenState() : result_(test::sample_result()), path_(folder_.file("out.nc")) {}

  void write() { write_netcdf(result_, path_, {"then: photic run"}); }

  /// The message without the path before it and the suggestion behind it.
  std::string refusal(const tally::Shape& shape = test::sample_shape()) {
    try {
      read_state(path_, shape);
    } catch (const InputError& error) {
      const std::string text = error.what();
      const std::size_t end = text.rfind(test::wanted_result);
      if (text.rfind(path_ + ": ", 0) != 0 || end == std::string::npos) return "unlike: " + text;
      return text.substr(path_.size() + 2, end - path_.size() - 2);
    }
    return "none";
  }

  /// Changes the group of a file that was written.
  void edit(const std::function<void(int group)>& change) {
    int file = 0, group = 0;
    ASSERT_EQ(nc_open(path_.c_str(), NC_WRITE, &file), NC_NOERR);
    ASSERT_EQ(nc_inq_grp_ncid(file, "continuation", &group), NC_NOERR);
    change(group);
    ASSERT_EQ(nc_close(file), NC_NOERR);
  }

  test::TemporaryFolder folder_;
  tally::Result result_;
  std::string path_;
};

// Seen red: with by_depth written as floats; with the powers of the tail in another order in the
// reader; with the first photons of the snapshots lost.
TEST_F(WrittenState, ComesBackToTheLastBit) {
  result_.state->echo[7].power[3] = std::numeric_limits<double>::denorm_min();
  result_.state->grids[0][11].xx = std::numeric_limits<double>::max();
  result_.state->octaves[3][127] = std::numeric_limits<std::uint64_t>::max();
  write();
  EXPECT_EQ(read_state(path_, test::sample_shape()), *result_.state);
}

TEST_F(WrittenState, OfNoBatchYet) {
  result_.state = tally::TotalsState(test::sample_shape());
  write();
  EXPECT_EQ(read_state(path_, test::sample_shape()), *result_.state);
}

// Seen red: without the origin of the tail.
TEST_F(WrittenState, OfEnvironmentsComesBackToTheLastBit) {
  result_ = test::sample_result_in({"more algae", "no CDOM", "bloom"});
  result_.state->environment[5].of_differences.fourth = std::numeric_limits<double>::denorm_min();
  write();
  EXPECT_EQ(read_state(path_, test::sample_shape(3)), *result_.state);
  const std::string missing =
      "a damaged result: it has no variable environment_sums of the size of its scene";
  EXPECT_EQ(refusal(test::sample_shape(2)), missing);
  result_.state = tally::TotalsState(test::sample_shape(3));  // of no batch yet
  write();
  EXPECT_EQ(read_state(path_, test::sample_shape(3)), *result_.state);
}

// Seen red: with the dimension of the environments alone.
TEST_F(WrittenState, OfTangentsComesBackToTheLastBit) {
  for (const std::vector<std::string>& environments : {Texts{}, Texts{"more algae"}}) {
    result_ = test::sample_result_in(environments, {"sea.x", "sea.y"});
    write();
    EXPECT_EQ(read_state(path_, test::sample_shape(environments.size(), 2)), *result_.state);
  }
}

// Seen red: with groups looked for in every file.
TEST_F(WrittenState, OfASceneThatKeepsNoGroupsIsAnother) {
  tally::Shape shape = test::sample_shape();
  shape.keeps_groups = false;
  result_.state = tally::TotalsState(shape);
  result_.state->batches = 1;
  result_.state->snapshot_photons.resize(shape.rows());
  result_.state->snapshot_batches.resize(shape.rows());
  result_.state->snapshot_echo.resize(shape.cells());
  write();
  EXPECT_EQ(read_state(path_, shape), *result_.state);
  EXPECT_EQ(refusal(test::sample_shape()),
            "a damaged result: it has no variable group_photons of the size of its scene");
}

TEST_F(WrittenState, WithoutTheEnvironmentsOfItsSceneIsRefused) {
  write();
  EXPECT_EQ(refusal(test::sample_shape(1)),
            "a damaged result: it has no variable environment_sums of the size of its scene");
}

TEST_F(WrittenState, KnowsItsRun) {
  result_.photons = (std::uint64_t{1} << 63) + 12345;
  write();
  const RunSoFar run = read_run(path_);
  EXPECT_EQ(run.scene_toml, result_.scene_toml);
  EXPECT_EQ(run.version, "0.1.0");
  EXPECT_EQ(run.history, "then: photic run");
  EXPECT_EQ(run.photons, result_.photons);
  EXPECT_EQ(run.wall_time_s, 23.5);
}

TEST_F(WrittenState, IsNotInEveryResult) {
  result_.state.reset();
  write();
  EXPECT_EQ(refusal(),
            "a result that no run can continue: it has no group continuation, which is lost where "
            "another program writes a result again");
}

// Seen red: without a look at the lengths of the dimensions.
TEST_F(WrittenState, OfAnotherShapeIsRefused) {
  write();
  using Shape = tally::Shape;
  for (const auto& [extent, variable] : {std::pair{&Shape::telescopes, "row_counts"},
                                         {&Shape::channels, "row_counts"},
                                         {&Shape::gates, "echo_sums"}}) {
    Shape shape = test::sample_shape();
    ++(shape.*extent);
    EXPECT_EQ(refusal(shape), std::string("a damaged result: it has no variable ") + variable +
                                  " of the size of its scene");
  }
  const auto grids = [](std::size_t orders, std::size_t processes, double depth) {
    Shape shape = test::sample_shape();
    shape.grids = tally::echo_grids(orders, std::vector<std::string>(processes, "some"),
                                    {0, depth / 2, depth});
    return shape;
  };
  EXPECT_EQ(refusal(grids(8, 3, 1)),
            "a damaged result: it has no variable echo_by_order_sums of the size of its scene");
  EXPECT_EQ(refusal(grids(7, 4, 1)),
            "a damaged result: it has no variable echo_by_process_sums of the size of its scene");
  EXPECT_EQ(refusal(grids(7, 3, 1)),
            "a damaged result: it has no variable echo_by_depth_sums of the size of its scene");
}

TEST_F(WrittenState, WithMoreBatchesThanSnapshotsIsRefused) {
  write();
  edit([](int group) {
    const auto batches = std::numeric_limits<std::uint64_t>::max();
    nc_put_att(group, NC_GLOBAL, "batches", NC_UINT64, 1, &batches);
  });
  EXPECT_EQ(refusal(),
            "a damaged result: it has no variable snapshot_photons of the size of its scene");
}

// Seen red: without the comparison.
TEST_F(WrittenState, OfMorePhotonsThanTheResultIsRefused) {
  result_.photons = result_.state->photons - 1;
  write();
  EXPECT_EQ(refusal(), "a damaged result: its state counts more photons than it does");
}

// Seen red: without a look at the number of values, as a write past the end.
TEST_F(WrittenState, WithOtherAttributesIsRefused) {
  write();
  edit([](int group) { nc_put_att_text(group, NC_GLOBAL, "collisions", 4, "many"); });
  EXPECT_EQ(refusal(), "a damaged result: it has no attribute collisions that is a count");
  write();
  edit([](int group) {
    const std::vector<unsigned long long> many(1000, 7);
    nc_put_att_ulonglong(group, NC_GLOBAL, "collisions", NC_UINT64, many.size(), many.data());
  });
  EXPECT_EQ(refusal(), "a damaged result: it has no attribute collisions that is a count");
  write();
  edit([](int group) { nc_del_att(group, NC_GLOBAL, "weight_lost"); });
  EXPECT_EQ(refusal(), "a damaged result: it has no attribute weight_lost that is a number");
}

// Its depths are others. Seen red: without that look.
TEST_F(WrittenState, OfAnEarlierFormatIsRefused) {
  write();
  edit([](int group) {
    int file = 0, format = 1;
    nc_inq_grp_parent(group, &file);
    nc_put_att_int(file, NC_GLOBAL, "photic_format", NC_INT, 1, &format);
  });
  EXPECT_EQ(refusal(),
            "written by Photic 0.1.0 in result format 1; this program continues format 3: start "
            "anew");
}

/// A result that is nothing but attributes, and what `add` puts into the group.
void write_bare(const std::string& path, const std::function<void(NetcdfImage& file)>& add) {
  NetcdfImage file;
  file.add_global("photic_format", photic_format);
  file.add_global("photons", std::uint64_t{2000});
  file.add_dimension("telescope", 2);
  file.add_dimension("channel", 3);
  file.add_dimension("gate", 100);
  file.enter_group("continuation");
  file.add_dimension("tail_sum", 8);
  for (const char* name :
       {"photons", "batches", "collisions", "scores", "local_estimates", "facets", "vertex_pairs",
        "ray_pairs", "meetings", "free_meetings", "meetings_by_waves",
        "photons_lost_too_many_events", "photons_lost_not_finite"})
    file.add_global(name, std::uint64_t{0});
  for (const char* name : {"absorbed", "escaped", "sea_bed", "oil", "cut_by_time", "cut_by_order",
                           "cut_by_weight", "roulette", "lost"})
    file.add_global(std::string("weight_") + name, 0.0);
  for (const char* name : {"weight_excess", "weight_excess_squares", "resting_target"})
    file.add_global(name, 0.0);
  file.add_dimension("row_count", 4);
  const std::vector<std::uint64_t> rows(std::size_t{2} * 3 * 4);
  file.add_variable("row_counts", {"telescope", "channel", "row_count"}, rows, {});
  add(file);
  write_atomically(path, file.finish());
}

// Seen red: without a look at the type.
TEST_F(WrittenState, WithOtherVariablesIsRefused) {
  const std::vector<std::string> dimensions{"telescope", "channel", "gate", "tail_sum"};
  const std::string missing =
      "a damaged result: it has no variable echo_sums of the size of its scene";
  write_bare(path_, [](NetcdfImage&) {});
  EXPECT_EQ(refusal(), missing);
  write_bare(path_, [&](NetcdfImage& file) {
    const std::vector<std::uint64_t> counts(2 * 3 * 100 * 8);
    file.add_variable("echo_sums", dimensions, counts, {});
  });
  EXPECT_EQ(refusal(), missing);
  write_bare(path_, [&](NetcdfImage& file) {  // the next one is what is missing now
    const std::vector<double> sums(2 * 3 * 100 * 8);
    file.add_variable("echo_sums", dimensions, sums, {});
  });
  EXPECT_EQ(refusal(),
            "a damaged result: it has no variable echo_by_order_sums of the size of its scene");
}

TEST_F(WrittenState, TornAnywhereIsRefused) {
  write();
  // Without the zeros at its end, which nobody needs.
  std::string whole = test::read_file(path_);
  whole.resize(whole.find_last_not_of('\0') + 1);
  for (std::size_t k = 0; k < 40; ++k) {
    test::write_file(path_, whole.substr(0, whole.size() * k / 40));
    EXPECT_THROW(read_state(path_, test::sample_shape()), InputError) << k;
  }
}

}  // namespace
}  // namespace photic::io
