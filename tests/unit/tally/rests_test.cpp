// Rows of gates that have met their target rest, and keep what they have.
#include <cmath>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

/// Row 0 in every batch, with many scores; rows 1 and 2 with one that scatters.
void add_batches(Tallies& t, int count, test::Random& random) {
  t.batch.rests = t.totals.resting(false);
  for (int b = 0; b < count; ++b) {
    for (int k = 0; k < 50; ++k) t.score(1, 1e-4 * random.between(0.5, 1.5));
    for (int k = 0; k < 10; ++k) t.score(2, 1e-4 * random.between(0, 2), 1, 1);
    t.end_batch(1000);
  }
}

/// A hundred batches, after which row 0 rests.
void let_the_first_rest(Tallies& t, test::Random& random) {
  t.totals.let_rest_at(0.01);
  add_batches(t, 100, random);
  t.totals.decide_rests();
  t.totals.decide_rests();
}

std::vector<bool> only_the_first(const Tallies& t) {
  std::vector<bool> rests(t.shape.rows());
  rests[0] = true;
  return rests;
}

// Seen red: without the second look; with rows that nothing was scored in.
TEST(Rests, BeginAtTheLookAfter) {
  Tallies t;
  test::Random random(3);
  const std::vector<bool> none(t.shape.rows());
  t.totals.let_rest_at(0.01);
  add_batches(t, 100, random);
  EXPECT_EQ(t.totals.resting(true), none);
  t.totals.decide_rests();
  EXPECT_EQ(t.totals.resting(false), none);
  EXPECT_EQ(t.totals.resting(true), only_the_first(t));
  t.totals.decide_rests();
  EXPECT_EQ(t.totals.resting(false), only_the_first(t));
}

// Seen red: with the photons of all; with the depths of rows that rest.
TEST(Rests, KeepARowAsItWas) {
  Tallies t;
  test::Random random(3);
  let_the_first_rest(t, random);
  const Result before = t.result();
  add_batches(t, 200, random);
  const Result after = t.result();
  EXPECT_EQ(after.photons, 300'000U);
  EXPECT_EQ(after.channel_photons[0], 100'000U);
  EXPECT_EQ(after.channel_photons[1], 300'000U);
  for (std::size_t cell = 0; cell < t.shape.gates; ++cell) {
    EXPECT_EQ(after.echo.mean[cell], before.echo.mean[cell]);
    EXPECT_EQ(after.echo.standard_error[cell], before.echo.standard_error[cell]);
    EXPECT_EQ(after.convergence_flags[cell], before.convergence_flags[cell]);
    EXPECT_EQ(after.variance_of_variance[cell], before.variance_of_variance[cell]);
  }
  EXPECT_EQ(after.error_growth[1], before.error_growth[1]);
  for (std::size_t k = 0; k < t.shape.gates * t.shape.grids[2].size(); ++k)
    EXPECT_EQ(after.grid("echo_by_depth").mean[k], before.grid("echo_by_depth").mean[k]);
  const std::size_t other = t.shape.gates + 2;
  EXPECT_NE(after.echo.mean[other], before.echo.mean[other]);
  EXPECT_NEAR(after.echo.mean[other] / 1e-6, 1, 0.05);
}

// However many batches others have. Seen red: with an error of 0.
TEST(Rests, LeaveARowOfOneBatchWithoutAnError) {
  Tallies t;
  test::Random random(3);
  add_batches(t, 1, random);
  t.batch.rests = only_the_first(t);
  for (int b = 0; b < 50; ++b) {
    t.score(1, 1e-4);
    t.score(2, 1e-4, 1, 1);
    t.end_batch(1000);
  }
  const Result r = t.result();
  EXPECT_GT(r.echo.mean[1], 0);
  EXPECT_TRUE(std::isnan(r.echo.standard_error[1]));
  EXPECT_NE(r.convergence_flags[1] & few_batches, 0);
  EXPECT_GT(r.echo.standard_error[t.shape.gates + 2], 0);
}

// Awake again, it is compared with what it had then. Seen red: with the photons of all in
// snapshots.
TEST(Rests, LeaveTheGrowthOfErrorsAsItIs) {
  Tallies t;
  test::Random random(3);
  let_the_first_rest(t, random);
  add_batches(t, 200, random);
  t.totals.let_rest_at(0);
  add_batches(t, 400, random);
  const Result r = t.result();
  EXPECT_EQ(r.channel_photons[0], 500'000U);
  EXPECT_NEAR(r.error_growth[1], 1, 0.15);
}

// Seen red: without a look at the target of before.
TEST(Rests, EndWithAnotherTarget) {
  Tallies t;
  test::Random random(3);
  const std::vector<bool> none(t.shape.rows());
  t.totals.decide_rests();
  EXPECT_EQ(t.totals.resting(true), none);
  t.totals.let_rest_at(0.01);
  add_batches(t, 100, random);
  t.totals.decide_rests();
  t.totals.let_rest_at(0.01);
  EXPECT_EQ(t.totals.resting(true), only_the_first(t));
  t.totals.let_rest_at(1e-6);
  EXPECT_EQ(t.totals.resting(true), none);
  t.totals.decide_rests();
  EXPECT_EQ(t.totals.resting(true), none);
}

// A line that two channels count is wanted until both rest. Seen red: with all of them for any.
TEST(Rests, AreAskedForByLine) {
  Tallies t;
  EXPECT_TRUE(t.batch.wants(1, 1));
  t.batch.rests[t.shape.channels + 1] = true;
  EXPECT_TRUE(t.batch.wants(1, 1));
  t.batch.rests[t.shape.channels + 2] = true;
  EXPECT_FALSE(t.batch.wants(1, 1));
  EXPECT_FALSE(t.batch.wants(1, 2));
  EXPECT_TRUE(t.batch.wants(0, 1));
  EXPECT_TRUE(t.batch.wants(1, 0));
}

}  // namespace
}  // namespace photic::tally
