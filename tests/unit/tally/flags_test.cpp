// Why a gate is not converged: each flag is raised by what it is for, and by nothing else here.
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>

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

/// Scores above x with the chance (least / x)^index, a hundred in each batch.
void add_pareto(Tallies& t, int batches, double index, test::Random& random) {
  constexpr double least = 1e-6;
  for (int b = 0; b < batches; ++b) {
    for (int k = 0; k < 100; ++k)
      t.score(0, std::min(0.5, least * std::pow(random.uniform(), -1 / index)));
    t.end_batch(1000);
  }
}

/// Standard error of gate 0 as it is reported, over that of the batches alone.
double widening(const Tallies& t) {
  const Counted n = t.totals.counted(0);
  const Sums& echo = t.totals.state().echo[0].low;
  return t.result().echo.standard_error[0] / standard_error(echo, n);
}

// What has not been seen of scores that fall off slowly is in the reported error; of others it
// is little. Seen red: with the index of the tail greater by 1, or less by 0.5; without the unseen
// in the error.
TEST(Flags, HeavyTail) {
  test::Random random(11);
  constexpr int runs = 50;
  int heavy = 0, light = 0, widened = 0;
  for (int run = 0; run < runs; ++run) {
    Tallies t, u, v;
    add_pareto(t, 64, 1.05, random);
    add_pareto(u, 64, 4, random);
    add_pareto(v, 64, 1.5, random);
    heavy += flags(t) != 0;
    light += flags(u) != 0;
    widened += widening(v) > 1.1;
    EXPECT_LT(widening(u), 1.4);
  }
  EXPECT_GE(heavy, 0.9 * runs);
  EXPECT_EQ(light, 0);
  EXPECT_GE(widened, 0.8 * runs);
}

/// A gate whose batches differ by ten per cent times `spread`, as even points make them, although
/// its largest scores, from `least` up, fall off slowly.
void add_even(Tallies& t, double spread, double least = 2e-6) {
  constexpr int batches = 64, large = 4 * batches, others = 2000;
  for (int b = 0; b < batches; ++b) {
    double rest = 1e-3 * (1 + spread * (steady(b) / 1e-3 - 1));
    for (int k = b; k < large; k += batches) {
      t.score(0, least * falling_off(k, large, 2));
      rest -= least * falling_off(k, large, 2);
    }
    for (int k = 0; k < others; ++k) t.score(0, rest / others);
    t.end_batch(1000);
  }
}

// Batches that hardly differ, as even points make them: one score more would be several errors.
// 0.80 of what is unseen is in them: the tail's index is 1.77. Seen red: with 2 or 0.5 for 1 error;
// with all of the unseen in errors.
TEST(Flags, HeavyTailAboveOneError) {
  constexpr double spread = 0.1, in_error = 0.80;
  Tallies t, more, less;
  add_even(t, spread);
  const double unseen = std::sqrt(std::pow(widening(t), 2) - 1) / in_error;  // in batches' errors
  add_even(more, spread * unseen / 1.2);
  add_even(less, spread * unseen / 0.8);
  EXPECT_NEAR(widening(more), std::hypot(1, 1.2 * in_error), 0.02);
  EXPECT_EQ(flags(more), heavy_tail);
  EXPECT_NEAR(widening(less), std::hypot(1, 0.8 * in_error), 0.02);
  EXPECT_EQ(flags(less), 0);
}

// Batches of even points differ so little that any score is many errors. Where it would be no more
// than a thousandth of the echo, it is in the reported error, and raises no flag. Seen red:
// with a ten thousandth; with a hundredth; with what one run in twenty has in the error, for forty.
TEST(Flags, HeavyTailIsNoNegligiblePart) {
  for (const double least : {1.4e-6, 0.6e-6}) {
    Tallies t;
    add_even(t, 1e-3, least);
    const double share = t.result().echo.standard_error[0] / t.result().echo.mean[0];
    EXPECT_GT(widening(t), 10);
    EXPECT_NEAR(share, least > 1e-6 ? 0.92e-3 : 0.4e-3, 0.05e-3);
    EXPECT_EQ(flags(t), least > 1e-6 ? heavy_tail : 0);
  }
}

// Scores that are all about as large as the largest one have a bound, and lack nothing, however
// little batches differ; also where larger ones are of another kind. Seen red: without the chance
// of no larger score (both); with the largest score of all kinds for their own (the second).
TEST(Flags, BoundedScoresLackNothing) {
  const auto even = [](int b) { return 1e-3 * (1 + 1e-3 * (steady(b) / 1e-3 - 1)); };
  Tallies t;
  add_batches(t, 64, 50, even);
  EXPECT_NEAR(widening(t), 1, 1e-3);
  EXPECT_EQ(flags(t), 0);
  Tallies u(0, 0, kinds_of_technique);
  for (int b = 0; b < 64; ++b) {
    for (int k = 0; k < 50; ++k) u.score(0, even(b) / 50, Technique::laser);
    for (int k = 0; k < 50; ++k) u.score(0, even(b) / 5000, Technique::both);
    u.end_batch(1000);
  }
  EXPECT_NEAR(widening(u), 1, 1e-3);
  EXPECT_EQ(flags(u), 0);
}

/// 240 equal scores, each batch that has some with so many, among many more in each that are small.
void add_together(Tallies& t, int together) {
  for (int b = 0; b < 100; ++b) {
    for (int k = 0; k < together && b * together < 240; ++k) t.score(0, 1.5e-5);
    for (int k = 0; k < 1000; ++k) t.score(0, 1e-7);
    t.end_batch(1000);
  }
}

// Twelve walks of twenty equal scores each are twelve scores, not 240: so few that are close to
// each other show no bound. Seen red: with each score for one; with chances below 0.5 unlikely;
// without the chance of no larger score.
TEST(Flags, ScoresThatComeTogetherShowNoBound) {
  Tallies one_by_one, together;
  add_together(one_by_one, 3);
  add_together(together, 20);
  EXPECT_NEAR(widening(one_by_one), 1, 1e-5);
  EXPECT_NEAR(widening(together), 1.0028, 4e-4);
}

// A run is no better for lacking the scores that are to come. Seen red: with 0.5 for 1 error; with
// the index of the tail less by 0.5.
TEST(Flags, HeavyTailDoesNotPickRunsThatLackLargeScores) {
  test::Random random(12);
  constexpr double index = 1.8, mean = 0.1 * 1e-6 * index / (index - 1);
  constexpr int runs = 1000;
  int passed = 0, covered = 0;
  for (int run = 0; run < runs; ++run) {
    Tallies t;
    add_pareto(t, 64, index, random);
    if ((flags(t) & heavy_tail) != 0) continue;
    ++passed;
    const Result r = t.result();
    covered += std::abs(r.echo.mean[0] - mean) < 1.96 * r.echo.standard_error[0];
  }
  EXPECT_GT(passed, runs / 20);
  EXPECT_GT(covered, 0.88 * passed);
}

// Too few scores to know how they are distributed.
TEST(Flags, HeavyTailOfFewScores) {
  Tallies t;
  add_batches(t, 64, 1, steady);
  EXPECT_EQ(flags(t) & heavy_tail, heavy_tail);
}

/// A quiet gate, made of the laser's walks, and of so many smaller scores a batch of both walks,
/// whose tail has such an index.
void add_beside_quiet_scores(Tallies& t, double index, int scores, test::Random& random) {
  for (int b = 0; b < 64; ++b) {
    for (int k = 0; k < 100; ++k) t.score(0, 1e-4 * random.between(0.9, 1.1), Technique::laser);
    for (int k = 0; k < scores; ++k)
      t.score(0, std::min(0.5, 3e-7 * std::pow(random.uniform(), -1 / index)), Technique::both);
    t.end_batch(1000);
  }
}

// The largest scores of a gate may be those of walks that say nothing of what others are to find.
// Most runs are flagged; in others a large score has come, which is in the error. Seen red: with
// the octaves of all walks together, and so where one kind, here no walk, has none.
TEST(Flags, HeavyTailOfSomeWalksIsNotHiddenByOthers) {
  test::Random random(13);
  constexpr double index = 1.2, least = 3e-7, most = 0.5;
  const double mean_score =  // of scores up to the most
      least * (index - std::pow(least / most, index - 1)) / (index - 1);
  const double expected = 0.1 * (1e-4 + mean_score);
  constexpr int runs = 50;
  int heavy = 0, light = 0, wrong = 0;
  for (int run = 0; run < runs; ++run) {
    Tallies t(0, 0, kinds_of_technique), u(0, 0, kinds_of_technique);
    add_beside_quiet_scores(t, index, 100, random);
    add_beside_quiet_scores(u, 4, 100, random);
    const Result r = t.result();
    heavy += flags(t) == heavy_tail;
    wrong += flags(t) == 0 && std::abs(r.echo.mean[0] - expected) > 2 * r.echo.standard_error[0];
    light += flags(u) != 0;
  }
  EXPECT_GE(heavy, 0.6 * runs);
  EXPECT_LE(wrong, 0.05 * runs);
  EXPECT_LE(light, 0.05 * runs);
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
