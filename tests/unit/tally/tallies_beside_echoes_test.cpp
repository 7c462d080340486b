// Tallies beside echoes: scores of batches, what batches add up to, the balance, and flags.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

TallyGrid grid_of(const std::string& name, std::size_t cells, bool in_balance) {
  TallyGrid grid;
  grid.name = name;
  grid.dimensions = {{name, cells, {}}};
  grid.in_balance = in_balance;
  return grid;
}
/// A profile of two cells beside a grid of three ends, one that repeats a part of them, another end
/// and the balance.
Shape shape_with_tallies() {
  Shape shape = Tallies::make_shape(0, 0, 1);
  shape.tallies = {grid_of("profile", 2, false), grid_of("absorbed", 3, true),
                   grid_of("part", 1, false), grid_of("escaped", 1, true),
                   grid_of("balance", 1, false)};
  shape.tallies[0].factor = {0.5, 4};
  shape.tallies.back().is_balance = true;
  return shape;
}
constexpr std::size_t first_absorbed = 2, part_cell = 5, escaped_cell = 6, balance_cell = 7;

// Nothing but weights counts; what is cleared has no trace of them. Seen red: with scores that are
// no numbers added; without octaves cleared.
TEST(TallyScores, AddWhatIsPositive) {
  TallyScores scores(2);
  for (const double no_score : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    scores.add(0, no_score);
  EXPECT_EQ(scores.sums[0], 0);
  scores.add(0, 3);
  scores.add(0, 5);
  EXPECT_EQ(scores.sums[0], 8 * tally_score_unit);
  EXPECT_EQ(scores.largest[0], 5 * tally_score_unit);
  EXPECT_EQ(scores.sums[1], 0);
  const auto counted = [&] {
    std::uint64_t sum = 0;
    for (const auto count : scores.octaves[0]) sum += count;
    return sum;
  };
  EXPECT_EQ(counted(), 2U);
  scores.clear();
  EXPECT_EQ(scores.sums[0], 0);
  EXPECT_EQ(scores.largest[0], 0);
  EXPECT_EQ(counted(), 0U);
}

// Lengths of kilometres and weights of a billionth are kept apart in octaves.
TEST(TallyScores, AreOfAnySize) {
  TallyScores scores(1);
  for (const double score : {1e-9, 1e4}) scores.add(0, score);
  std::uint64_t octaves = 0;
  for (const auto count : scores.octaves[0]) octaves += count > 0;
  EXPECT_EQ(octaves, 2U);
  EXPECT_NEAR(scores.sums[0] / tally_score_unit, 1e4, 1e-8);
}

/// Batches of 100 photons, of which each is absorbed or escapes as chance has it.
void add_batches_of_ends(Tallies& t, int batches) {
  test::Random random(3);
  for (int b = 0; b < batches; ++b) {
    for (int i = 0; i < 100; ++i) {
      const double absorbed = random.uniform();
      t.batch.tallies.add(first_absorbed + static_cast<std::size_t>(random.below(3)), absorbed);
      t.batch.tallies.add(part_cell, absorbed / 2);
      t.batch.tallies.add(escaped_cell, 1 - absorbed);
      t.batch.tallies.add(0, 2 * absorbed);
    }
    t.end_batch(100);
  }
}

// Means are per photon and by the factors of cells; the balance is the sum of what is in it, batch
// by batch: exactly 1 here, so that its error is none, while its parts have some. Seen red: with
// the part that is not in it counted; without the last of its parts.
TEST(TalliesBesideEchoes, HaveABalance) {
  Tallies t(shape_with_tallies());
  add_batches_of_ends(t, 40);
  const Result r = t.result();
  ASSERT_EQ(r.tallies.size(), 5U);
  const auto& absorbed = r.tallies[1];
  const double all_absorbed = absorbed.mean[0] + absorbed.mean[1] + absorbed.mean[2];
  EXPECT_NEAR(all_absorbed, 0.5, 0.02);
  EXPECT_NEAR(r.tallies[2].mean[0], all_absorbed / 2, 1e-12);
  EXPECT_NEAR(r.tallies[0].mean[0], 0.5 * 2 * all_absorbed, 1e-12);
  EXPECT_EQ(r.tallies[0].mean[1], 0);
  EXPECT_NEAR(r.tallies[3].mean[0], 1 - all_absorbed, 1e-12);
  EXPECT_GT(r.tallies[3].standard_error[0], 1e-3);
  EXPECT_NEAR(r.tallies[4].mean[0], 1, 1e-12);
  EXPECT_LT(r.tallies[4].standard_error[0], 1e-9);
}

// The standard error is that of batches. For 100 photons each, uniform in 0 to 1 with variance
// 1/12; of a spread over 400 batches within four of its own errors, 1 in 28.
TEST(TalliesBesideEchoes, HaveTheErrorsOfBatches) {
  Tallies t(shape_with_tallies());
  add_batches_of_ends(t, 400);
  const double expected = std::sqrt(1.0 / 12 / 4e4);
  EXPECT_NEAR(t.result().tallies[3].standard_error[0], expected, 4.0 / 28 * expected);
}

// Flags are those of echoes, cell by cell; the balance has no single scores, and no tail. Seen red:
// with a balance that asks for its tail.
TEST(TalliesBesideEchoes, AreFlagged) {
  Tallies t(shape_with_tallies());
  add_batches_of_ends(t, 20);
  EXPECT_EQ(t.totals.tally_health(1, false).flags, no_score);
  EXPECT_EQ(t.totals.tally_health(escaped_cell, false).flags, few_batches);
  add_batches_of_ends(t, 20);
  EXPECT_EQ(t.totals.tally_health(escaped_cell, false).flags, 0);
  EXPECT_EQ(t.totals.tally_health(balance_cell, true).flags, 0);
  EXPECT_EQ(t.result().tallies[3].flags[0], 0);
  EXPECT_EQ(t.result().tallies[0].flags[1], no_score);
  EXPECT_TRUE(t.totals.all_converged(0.05));
  EXPECT_FALSE(t.totals.all_converged(1e-4));
}
TEST(TalliesBesideEchoes, AreFlaggedForAHeavyTail) {
  Tallies t(shape_with_tallies());
  for (int b = 0; b < 64; ++b) {
    for (int k = b; k < 6400; k += 64) t.batch.tallies.add(0, falling_off(k, 6400, 1.1));
    t.end_batch(100);
  }
  EXPECT_NE(t.totals.tally_health(0, false).flags & heavy_tail, 0);
  EXPECT_FALSE(t.totals.all_converged(10));
}

// Cells count in the progress of a run.
TEST(TalliesBesideEchoes, CountAsCells) {
  Tallies t(shape_with_tallies());
  add_batches_of_ends(t, 40);
  EXPECT_EQ(t.totals.scored_cells(), 7U);  // all but one of the profile
  EXPECT_EQ(t.totals.converged_cells(), 7U);
  EXPECT_GT(t.totals.worst_error(), 0);
}

// A run that goes on from a state ends as one that never stopped; of another shape it is a bug.
TEST(TalliesBesideEchoes, GoOn) {
  Tallies all(shape_with_tallies()), first(shape_with_tallies());
  add_batches_of_ends(first, 5);
  Totals later(first.shape, first.totals.state());
  add_batches_of_ends(all, 5);
  for (Totals* totals : {&all.totals, &later}) {
    BatchTally batch(first.shape, first.gates);
    batch.tallies.add(escaped_cell, 0.25);
    batch.photons = 100;
    totals->merge(batch);
  }
  Result one, other;
  all.totals.fill(one);
  later.fill(other);
  for (std::size_t i = 0; i < one.tallies.size(); ++i) {
    EXPECT_EQ(one.tallies[i].mean, other.tallies[i].mean);
    EXPECT_EQ(one.tallies[i].standard_error, other.tallies[i].standard_error);
  }
  const Tallies without;
  EXPECT_ANY_THROW(Totals(without.shape, first.totals.state()));
}

}  // namespace
}  // namespace photic::tally
