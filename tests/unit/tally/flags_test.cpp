// Why a gate is not converged: each flag is raised by what it is for, and by nothing else here.
#include <algorithm>
#include <cmath>
#include <functional>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

/// Batches of 1000 photons, each with `scores` equal scores in gate 0 that add up to
/// `total(batch)`.
void add_batches(Tallies& t, int batches, int scores, const std::function<double(int)>& total) {
  for (int b = 0; b < batches; ++b) {
    for (int k = 0; k < scores; ++k) t.score(0, total(b) / scores);
    t.end_batch(1000);
  }
}

/// What a well-behaved gate does: batches that differ by ten per cent, made of many scores.
double steady(int batch) {
  test::Random random(static_cast<std::uint64_t>(batch) + 100);
  return 1e-3 * random.between(0.9, 1.1);
}

std::int32_t flags(const Tallies& t) { return t.totals.health(0).flags; }

TEST(Flags, AreNotRaisedByASteadyGate) {
  Tallies t;
  add_batches(t, 64, 50, steady);
  EXPECT_EQ(flags(t), 0);
  EXPECT_EQ(t.totals.converged_cells(), 1U);
  EXPECT_EQ(t.totals.scored_cells(), 1U);
}

TEST(Flags, NoScore) {
  Tallies t;
  add_batches(t, 64, 50, steady);
  EXPECT_EQ(t.totals.health(1).flags, no_score);
  const Result r = t.result();
  EXPECT_EQ(r.convergence_flags[1], no_score);
  EXPECT_EQ(r.convergence_flags[0], 0);
  EXPECT_EQ(r.echo.mean[1], 0);
  EXPECT_EQ(r.order_cut_share[1], 0);
}

// Seen red: with the limit at 20.
TEST(Flags, FewBatches) {
  Tallies t;
  add_batches(t, 29, 50, steady);
  EXPECT_EQ(flags(t), few_batches);
  add_batches(t, 1, 50, steady);
  EXPECT_EQ(flags(t), 0);
}

// Batches of 0 or 2: a relative error of 1 / sqrt(batches - 1). Seen red: with the error compared
// to the sum.
TEST(Flags, LargeError) {
  const auto coin = [](int batch) { return batch % 2 == 0 ? 2e-3 : 0.0; };
  Tallies t;
  add_batches(t, 100, 50, coin);
  EXPECT_EQ(flags(t), large_error);
  add_batches(t, 4, 50, coin);
  EXPECT_EQ(flags(t), 0);  // 1 / sqrt(103) is below a tenth
}

// One score of 2.4 % of the echo. Seen red: with the limit at 5 %.
TEST(Flags, LargeScore) {
  Tallies t;
  add_batches(t, 63, 50, steady);
  EXPECT_EQ(flags(t), 0);
  const double echo = 64e-3;
  t.score(0, 0.019 * echo);
  t.end_batch(1000);
  EXPECT_EQ(flags(t) & large_score, 0);
  t.score(0, 0.025 * echo);
  t.end_batch(1000);
  EXPECT_NE(flags(t) & large_score, 0);
  EXPECT_NEAR(t.totals.health(0).largest_score_share, 0.025 * 64 / 66, 0.002);
}

/// (sum of fourth over squared sum of second powers of the deviations) - 1 / batches.
double variance_of_variance(const std::vector<double>& batches) {
  double mean = 0, second = 0, fourth = 0;
  for (const double x : batches) mean += x / static_cast<double>(batches.size());
  for (const double x : batches) second += std::pow(x - mean, 2);
  for (const double x : batches) fourth += std::pow(x - mean, 4);
  return fourth / (second * second) - 1 / static_cast<double>(batches.size());
}

// One batch far from the others carries the variance. Seen red: without the division by the
// batches; with 3 for 4 in the fourth moment.
TEST(Flags, UncertainVariance) {
  const auto outlier = [](int batch) { return batch == 40 ? 2e-3 : steady(batch); };
  std::vector<double> calm, wild;
  for (int b = 0; b < 64; ++b) calm.push_back(steady(b));
  for (int b = 0; b < 64; ++b) wild.push_back(outlier(b));
  Tallies t, u;
  add_batches(t, 64, 50, steady);
  add_batches(u, 64, 50, outlier);
  EXPECT_NEAR(t.totals.health(0).variance_of_variance, variance_of_variance(calm), 1e-8);
  EXPECT_NEAR(u.totals.health(0).variance_of_variance, variance_of_variance(wild), 1e-8);
  EXPECT_LT(variance_of_variance(calm), 0.1);
  EXPECT_GT(variance_of_variance(wild), 0.1);
  EXPECT_EQ(flags(t) & uncertain_variance, 0);
  EXPECT_NE(flags(u) & uncertain_variance, 0);
}

// Of gates so quiet that raw fourth powers have no digits left, and of gates that many batches
// miss. Seen red: with raw moments (quiet); with the batches that miss left out (missed).
TEST(Flags, TheVarianceOfTheVarianceKeepsItsDigits) {
  const auto quiet = [](int batch) { return 1e-3 * (1 + 1e-5 * (steady(batch) / 1e-3 - 1)); };
  const auto missed = [](int batch) { return batch % 3 == 1 ? steady(batch) : 0.0; };
  for (const auto& gate : {std::function<double(int)>(quiet), std::function<double(int)>(missed)}) {
    std::vector<double> batches;
    Tallies t;
    for (int b = 0; b < 64; ++b) {
      batches.push_back(gate(b));
      if (gate(b) > 0) t.score(0, gate(b));
      t.end_batch(1000);
    }
    const double expected = variance_of_variance(batches);
    EXPECT_NEAR(t.totals.health(0).variance_of_variance / expected, 1, 1e-6);
  }
}

/// 64 batches that all have the same scores: `small` of 2^-20, and in every other one a large one.
void add_tail(Tallies& t, int small, double large) {
  for (int b = 0; b < 64; ++b) {
    for (int k = 0; k < small; ++k) t.score(0, std::ldexp(1.0, -20));
    if (b % 2 == 0) t.score(0, large);
    t.end_batch(1000);
  }
}

// The thirty largest scores carry the second moment: what is larger still has been drawn by chance
// or not. Seen red: with the first for the second moment; with the scores counted from the
// smallest.
TEST(Flags, HeavyTail) {
  Tallies light, heavy;
  add_tail(light, 1000, std::ldexp(1.0, -17));  // 32 x 64 of 64000 + 2048: 3 %
  add_tail(heavy, 1000, std::ldexp(1.0, -12));  // 32 x 65536 of nearly as much
  EXPECT_EQ(flags(light) & heavy_tail, 0);
  EXPECT_NE(flags(heavy) & heavy_tail, 0);
}

// Calm batches, then ones that scatter four times as much: the error does not fall between 16 and
// 64 batches. Seen red: with the error not scaled by the photons; with the last snapshot.
TEST(Flags, ErrorNotFalling) {
  const auto late = [](int batch) {
    test::Random random(static_cast<std::uint64_t>(batch) + 7);
    const double spread = batch < 16 ? 0.02 : 0.2;
    return 1e-3 * random.between(1 - spread, 1 + spread);
  };
  Tallies t, u;
  add_batches(t, 64, 50, steady);
  add_batches(u, 64, 50, late);
  EXPECT_EQ(flags(t) & error_not_falling, 0);
  EXPECT_EQ(flags(u), error_not_falling);
}

// Few batches scatter so much that their errors grow by chance. Seen red: with 1.4 for any number
// of batches (65 of 400).
TEST(Flags, ErrorNotFallingIsNoMatterOfChance) {
  test::Random random(5);
  int flagged = 0;
  for (int run = 0; run < 400; ++run) {
    Tallies t;
    add_batches(t, 50, 50, [&](int) { return 1e-3 * random.between(0.9, 1.1); });
    flagged += (flags(t) & error_not_falling) != 0 ? 1 : 0;
  }
  EXPECT_LE(flagged, 8);
}

TEST(Flags, DecideWhetherATargetIsReached) {
  Tallies t;
  EXPECT_TRUE(t.totals.all_converged(0.01));  // nothing scored, nothing to wait for
  add_batches(t, 64, 50, steady);
  const Result r = t.result();
  const double relative = r.echo.standard_error[0] / r.echo.mean[0];
  EXPECT_TRUE(t.totals.all_converged(1.01 * relative));
  EXPECT_FALSE(t.totals.all_converged(0.99 * relative));
  t.score(1, 1e-6);  // another gate with one score only
  add_batches(t, 1, 50, steady);
  EXPECT_FALSE(t.totals.all_converged(1.01 * relative));
  EXPECT_EQ(t.totals.scored_cells(), 2U);
  EXPECT_EQ(t.totals.converged_cells(), 1U);
}

TEST(Flags, AreAllExplained) {
  std::int32_t known = 0;
  for (const FlagMeaning& meaning : flag_meanings()) {
    known |= meaning.flag;
    EXPECT_GT(std::string(meaning.name).size(), 0U);
    EXPECT_GT(std::string(meaning.explanation).size(), 0U);
  }
  EXPECT_EQ(known, no_score | few_batches | large_error | large_score | uncertain_variance |
                       heavy_tail | error_not_falling | among_flagged);
}

}  // namespace
}  // namespace photic::tally
