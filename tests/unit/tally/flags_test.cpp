// Why a gate is not converged: each flag is raised by what it is for, and by nothing else here.
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>

#include "unit/tally/steady_batches.hpp"

namespace photic::tally {
namespace {

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

// An error that would be large with all that is unseen, of which it has four fifths. Seen red: with
// the reported error.
TEST(Flags, LargeErrorOfAllThatIsUnseen) {
  Tallies t;
  for (int b = 0; b < 50; ++b) {
    for (int k = b; k < 200; k += 50) t.score(0, 1e-4 * falling_off(k, 200, 2));
    for (int k = 0; k < 100; ++k) t.score(0, 2e-6);
    t.end_batch(1000);
  }
  const double error = t.totals.health(0).relative_error;
  EXPECT_GT(error, 0.08);
  EXPECT_LT(error, 0.099);
  EXPECT_EQ(flags(t), large_error | heavy_tail);
}

// One score of 2.5 % of the echo is reported, and no flag: it picks runs that lack it.
TEST(Flags, ALargeScoreIsReported) {
  Tallies t;
  add_batches(t, 63, 50, steady);
  t.score(0, 0.025 * 64e-3);
  t.end_batch(1000);
  EXPECT_EQ(flags(t), 0);
  EXPECT_NEAR(t.result().largest_score_share[0], 0.025, 0.002);
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
TEST(Flags, VarianceOfVariance) {
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

// Telescopes' walks that have hardly ever come near the beam, or never; there is nothing that only
// they could find in light scattered once. Seen red: with any number of their scores enough.
TEST(Flags, BeamMissed) {
  const auto flags_of = [](int scores, std::int32_t max_order) {
    test::Random random(14);
    Tallies t(max_order, 0, kinds_of_technique);
    add_beside_quiet_scores(t, 4, scores, random);
    return flags(t);
  };
  EXPECT_EQ(flags_of(0, 0), beam_missed);
  EXPECT_EQ(flags_of(4, 0), beam_missed);
  EXPECT_EQ(flags_of(5, 0), 0);
  EXPECT_EQ(flags_of(0, 1), 0);
}

/// Of a gate in 64 batches: a hundred scores of no walk that add up to an echo, and so many of each
/// of the given walks that add up to a share of it.
std::int32_t flags_beside_histories(double share, int scores,
                                    std::initializer_list<Technique> walks) {
  Tallies t(0, 0, kinds_of_technique);
  for (int b = 0; b < 64; ++b) {
    for (int k = 0; k < 100; ++k) t.score(0, steady(b) / 100, Technique::none);
    for (const Technique technique : walks)
      for (int k = 0; k < scores; ++k) t.score(0, share * steady(b) / scores, technique);
    t.end_batch(1000);
  }
  return flags(t);
}

// Light that no walk carries asks for no walk of a telescope. The rest of a gate's light does,
// where it is no negligible part. Seen red: with histories counted as walks of the laser, as it
// was; with any rest judged; with the scores of telescopes' walks left out of the rest.
TEST(Flags, BeamMissedJudgesTheLightOfWalks) {
  EXPECT_EQ(flags_beside_histories(0, 0, {}), 0);
  EXPECT_EQ(flags_beside_histories(4e-4, 10, {Technique::laser}), 0);
  EXPECT_EQ(flags_beside_histories(3e-3, 10, {Technique::laser}), beam_missed);
  EXPECT_EQ(flags_beside_histories(3e-3, 10, {Technique::laser, Technique::both}), 0);
  EXPECT_EQ(flags_beside_histories(4e-4, 3, {Technique::telescope}), 0);
  EXPECT_EQ(flags_beside_histories(3e-3, 3, {Technique::telescope}), beam_missed);
}

// Calm batches, then ones that scatter ten times as much. Seen red: with the error not scaled by
// the photons; with the last snapshot; with the division by no error.
TEST(Flags, ErrorGrowth) {
  const auto late = [](int batch) {
    test::Random random(static_cast<std::uint64_t>(batch) + 7);
    const double spread = batch < 16 ? 0.02 : 0.2;
    return 1e-3 * random.between(1 - spread, 1 + spread);
  };
  Tallies t, u, few;
  add_batches(t, 64, 50, steady);
  add_batches(u, 64, 50, late);
  add_batches(few, 3, 50, late);
  EXPECT_NEAR(t.result().error_growth[0], 1, 0.1);
  EXPECT_NEAR(u.result().error_growth[0], 10, 3);
  EXPECT_TRUE(std::isnan(few.result().error_growth[0]));
  t.score(1, 1e-6);  // a gate that had nothing to compare with
  add_batches(t, 1, 50, steady);
  EXPECT_TRUE(std::isnan(t.result().error_growth[1]));
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
  EXPECT_EQ(known, no_score | few_batches | large_error | uncertain_variance | heavy_tail |
                       among_flagged | beam_missed);
}

}  // namespace
}  // namespace photic::tally
