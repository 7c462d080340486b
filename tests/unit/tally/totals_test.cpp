// Means and errors of merged batches against direct formulas.
#include "tally/totals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

/// The score of one cell in a batch.
struct Sample {
  std::uint64_t photons;
  double score;
};

double direct_mean(const std::vector<Sample>& batches) {
  double score = 0, photons = 0;
  for (const Sample& b : batches) {
    score += b.score;
    photons += static_cast<double>(b.photons);
  }
  return score / photons;
}

/// Of the mean: batches weighted by their photons.
double direct_error(const std::vector<Sample>& batches) {
  const double mean = direct_mean(batches);
  double squares = 0, photons = 0;
  for (const Sample& b : batches) {
    const auto n = static_cast<double>(b.photons);
    squares += n * std::pow(b.score / n - mean, 2);
    photons += n;
  }
  return std::sqrt(squares / static_cast<double>(batches.size() - 1) / photons);
}

std::vector<Sample> random_batches(std::size_t count, std::uint64_t last_photons) {
  test::Random random(11);
  std::vector<Sample> batches;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t photons = i + 1 == count ? last_photons : 2000;
    batches.push_back({photons, static_cast<double>(photons) * random.between(1e-4, 3e-4)});
  }
  return batches;
}

// Seen red: with the number of batches for one less; with the batches' sum of squares not divided
// by their photons.
TEST(Totals, HaveTheMeansAndErrorsOfTheirBatches) {
  for (const std::uint64_t last :
       {std::uint64_t{2000}, std::uint64_t{2000}, std::uint64_t{137}, std::uint64_t{1}}) {
    const auto batches = random_batches(57, last);
    Tallies t;
    for (const Sample& b : batches) {
      t.score(2, b.score);  // too few in all to know what has not been seen
      t.end_batch(b.photons);
    }
    const Result r = t.result();
    EXPECT_NEAR(r.echo.mean[2] / direct_mean(batches), 1, 1e-12);
    EXPECT_NEAR(r.echo.standard_error[2] / direct_error(batches), 1, 1e-9);
    EXPECT_EQ(r.photons, 56U * 2000 + last);
    EXPECT_EQ(r.batches, 57U);
  }
}

// 1, 2, 3, 4, 5 per thousand photons: mean 3e-3, deviation sqrt(2.5) 1e-3, error of the mean
// sqrt(0.5) 1e-3.
TEST(Totals, AreThoseOfAnExampleByHand) {
  Tallies t;
  for (const double score : {1, 2, 3, 4, 5}) {
    t.score(0, score / 10);
    t.end_batch(100);
  }
  const Result r = t.result();
  EXPECT_NEAR(r.echo.mean[0], 3e-3, 1e-17);
  EXPECT_NEAR(r.echo.standard_error[0], std::sqrt(0.5) * 1e-3, 1e-16);
}

// Within what adding so many rounded numbers may lose at most: half a unit in the last place each.
// Seen red: with sums of floats.
TEST(Totals, AreExactToRoundingAtTenBillionScores) {
  constexpr int scores = 100000, batches = 100000;
  Tallies t;
  for (int k = 0; k < scores; ++k) t.score(0, 0.1);
  t.batch.photons = 2000;
  for (int k = 0; k < batches; ++k) t.totals.merge(t.batch);
  const double sum = t.result().echo.mean[0] * 2000 * batches;
  const double most = (scores + batches) * std::numeric_limits<double>::epsilon() / 2;
  EXPECT_NEAR(sum / (0.1 * scores * batches), 1, most);
}

/// Whether all of them are NaN.
bool unknown(std::span<const double> errors) {
  return !errors.empty() &&
         std::ranges::all_of(errors, [](double error) { return std::isnan(error); });
}

// Neither where something was scored nor where nothing was. Seen red: with an error of 0.
TEST(Totals, OfOneBatchKnowNoError) {
  Tallies t(0, 1);
  t.score(0, 1);
  t.end_batch(100);
  const Result r = t.result();
  for (const Estimates* of : {&r.echo, &r.environment_echo, &r.environment_difference})
    EXPECT_TRUE(unknown(of->standard_error));
  for (const GridEstimates& of : r.grids) EXPECT_TRUE(unknown(of.standard_error));
  EXPECT_TRUE(std::isnan(r.variance_of_variance[0]));
  EXPECT_TRUE(std::isnan(r.ledger_standard_error));
  EXPECT_EQ(r.convergence_flags[0], few_batches);
  EXPECT_EQ(r.convergence_flags[1], no_score);
  EXPECT_FALSE(t.totals.all_converged(0.99));
}

// Of accounts that differ from batch to batch by as much as the absorbed weight does: a thousand
// photons each, that lose 900, 1000 … 1300 of weight. Seen red: with half of the absorbed
// weight twice and without what is lost.
TEST(Totals, KnowTheErrorOfTheLedger) {
  Tallies t;
  for (const double absorbed : {200, 300, 400, 500, 600}) {
    t.batch.ledger = {absorbed, 100, 100, 100, 100, 100, 100, 100};
    t.end_batch(1000);
  }
  const Result r = t.result();
  EXPECT_NEAR(r.ledger.sum(), 1.1, 1e-14);
  EXPECT_NEAR(r.ledger_standard_error, std::sqrt(0.025 / 5), 1e-14);
}

// A batch that scored nothing counts like any other.
TEST(Totals, CountBatchesWithoutAScore) {
  Tallies t;
  for (int k = 0; k < 10; ++k) {
    if (k % 2 == 0) t.score(1, 0.02);
    t.end_batch(10);
  }
  const Result r = t.result();
  EXPECT_NEAR(r.echo.mean[1], 1e-3, 1e-17);
  EXPECT_NEAR(r.echo.standard_error[1], 1e-3 / 3,
              1e-16);  // deviation 1e-3 sqrt(10 / 9), over sqrt(10)
}

/// Fills every cell with something, a different thing in each batch.
void fill_at_random(Tallies& t, int batches) {
  test::Random random(12);
  for (int b = 0; b < batches; ++b) {
    for (int k = 0; k < 200; ++k) {
      t.batch.score({static_cast<std::size_t>(random.below(2)), random.below(3),
                     1 + random.below(5), random.between(0, 20),
                     random.between(t.gates.edge_path(0), t.gates.last_path()),
                     random.scale(1e-6, 1e-3)});
    }
    t.end_batch(1000);
  }
}

// Seen red: with gates and orders swapped in the result; with the last order left out.
TEST(Totals, SplitTheEchoByOrderAndByProcess) {
  Tallies t;
  fill_at_random(t, 40);
  const Result r = t.result();
  ASSERT_EQ(r.echo.mean.size(), 24U);
  ASSERT_EQ(r.grid("echo_by_order").mean.size(), 96U);
  ASSERT_EQ(r.grid("echo_by_process").mean.size(), 72U);
  ASSERT_EQ(r.grid("echo_by_depth").mean.size(), 96U);
  for (std::size_t tc = 0; tc < 6; ++tc) {
    for (std::size_t g = 0; g < 4; ++g) {
      const double echo = r.echo.mean[tc * 4 + g];
      double orders = 0, processes = 0, depths = 0;
      for (std::size_t k = 0; k < 4; ++k)
        orders += r.grid("echo_by_order").mean[(tc * 4 + k) * 4 + g];
      for (std::size_t k = 0; k < 3; ++k)
        processes += r.grid("echo_by_process").mean[(tc * 3 + k) * 4 + g];
      for (std::size_t k = 0; k < 4; ++k)
        depths += r.grid("echo_by_depth").mean[(tc * 4 + g) * 4 + k];
      EXPECT_GT(echo, 0);
      EXPECT_NEAR(orders / echo, 1, 1e-12);
      EXPECT_NEAR(processes / echo, 1, 1e-12);
      EXPECT_NEAR(depths / echo, 1, 1e-12);
      // Channel 0 sees line 0 alone, channel 1 line 1, channel 2 lines 1 and 2.
      const auto process = [&](std::size_t k) {
        return r.grid("echo_by_process").mean[(tc * 3 + k) * 4 + g];
      };
      EXPECT_EQ(process(0) > 0, tc % 3 == 0);
      EXPECT_EQ(process(1) > 0, tc % 3 > 0);
      EXPECT_EQ(process(2) > 0, tc % 3 == 2);
    }
  }
}

TEST(Totals, PutASingleScoreWhereItBelongs) {
  Tallies t;
  t.batch.score({1, 1, 2, 12.0, t.path_in(3), 0.5});
  t.end_batch(10);
  const Result r = t.result();
  const auto only = [](std::span<const double> values, std::vector<std::size_t> at) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool here = std::find(at.begin(), at.end(), i) != at.end();
      EXPECT_EQ(values[i], here ? 0.05 : 0) << i;
    }
  };
  only(r.echo.mean, {(1 * 3 + 1) * 4 + 3, (1 * 3 + 2) * 4 + 3});
  only(r.grid("echo_by_order").mean,
       {((1 * 3 + 1) * 4 + 2) * 4 + 3, ((1 * 3 + 2) * 4 + 2) * 4 + 3});
  only(r.grid("echo_by_process").mean,
       {((1 * 3 + 1) * 3 + 1) * 4 + 3, ((1 * 3 + 2) * 3 + 1) * 4 + 3});
  only(r.grid("echo_by_depth").mean,
       {((1 * 3 + 1) * 4 + 3) * 4 + 2, ((1 * 3 + 2) * 4 + 3) * 4 + 2});
}

// The same batches in the same order give the same bits, from one tally used again as from a fresh
// one each.
TEST(Totals, AreTheSameBitsForTheSameBatches) {
  Tallies once, again;
  fill_at_random(once, 40);
  fill_at_random(again, 40);
  const Result a = once.result();
  const Result b = again.result();
  EXPECT_EQ(a.echo.mean, b.echo.mean);
  EXPECT_EQ(a.echo.standard_error, b.echo.standard_error);
  EXPECT_EQ(a.variance_of_variance, b.variance_of_variance);
  EXPECT_EQ(a.grid("echo_by_depth").standard_error, b.grid("echo_by_depth").standard_error);
}

// Merging in another order is the same up to rounding, and no more than that.
TEST(Totals, DependOnTheOrderOfBatchesByRoundingOnly) {
  const auto batches = random_batches(40, 2000);
  Tallies forward, backward;
  for (std::size_t i = 0; i < batches.size(); ++i) {
    forward.score(0, batches[i].score);
    forward.end_batch(2000);
    backward.score(0, batches[batches.size() - 1 - i].score);
    backward.end_batch(2000);
  }
  EXPECT_NEAR(forward.result().echo.mean[0] / backward.result().echo.mean[0], 1, 1e-14);
  EXPECT_NEAR(forward.result().echo.standard_error[0] / backward.result().echo.standard_error[0], 1,
              1e-10);
}

TEST(Totals, ShareTheLedgerAmongThePhotons) {
  Tallies t;
  for (int b = 0; b < 2; ++b) {
    t.batch.ledger = {10, 20, 24, 6, 15, 5, 4, 12, 8};
    t.batch.collisions = 7;
    t.batch.operations = {1, 2, 3, 4, 5, 6, 7};
    t.batch.too_many_events = 1;
    t.batch.not_finite = 2;
    t.end_batch(100);
  }
  const Result r = t.result();
  const Ledger& l = r.ledger;
  EXPECT_NEAR(l.absorbed, 0.10, 1e-15);
  EXPECT_NEAR(l.escaped, 0.20, 1e-15);
  EXPECT_NEAR(l.sea_bed, 0.24, 1e-15);
  EXPECT_NEAR(l.oil, 0.06, 1e-15);
  EXPECT_NEAR(l.cut_by_time, 0.15, 1e-15);
  EXPECT_NEAR(l.cut_by_order, 0.05, 1e-15);
  EXPECT_NEAR(l.cut_by_weight, 0.04, 1e-15);
  EXPECT_NEAR(l.roulette, 0.12, 1e-15);
  EXPECT_NEAR(l.lost, 0.08, 1e-15);
  EXPECT_EQ(r.collisions, 14U);
  EXPECT_EQ(t.totals.operations(), (Operations{2, 4, 6, 8, 10, 12, 14}));
  EXPECT_EQ(r.lost_too_many_events, 2U);
  EXPECT_EQ(r.lost_not_finite, 4U);
}

}  // namespace
}  // namespace photic::tally
