// The flag of scores too rare to have been seen, and what reported errors hold of these.
#include <algorithm>
#include <cmath>

#include "unit/tally/steady_batches.hpp"

namespace photic::tally {
namespace {

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

}  // namespace
}  // namespace photic::tally
