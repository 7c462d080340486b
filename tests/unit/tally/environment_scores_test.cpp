// What a batch scores in environments.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

// Seen red: with the fourth power of scores for that of differences.
TEST(EnvironmentScores, AreAddedEachByItsRatio) {
  EnvironmentScores sums;
  const std::array<float, EnvironmentScores::size> ratio{1, 2, 0, 3, -1, 0.5, 1, 1};
  sums.add(3.0, ratio.data());
  sums.add(1.0, ratio.data());
  EXPECT_EQ(sums.echo, (EnvironmentScores::Each{4, 8, 0, 12, -4, 2, 4, 4}));
  EXPECT_EQ(sums.difference, (EnvironmentScores::Each{0, 4, -4, 8, -8, -2, 0, 0}));
  EXPECT_EQ(sums.largest, (EnvironmentScores::Each{3, 6, 0, 9, 0, 1.5, 3, 3}));
  EXPECT_EQ(sums.squares[1], 40);
  EXPECT_EQ(sums.fourths[1], 1312);
  EXPECT_EQ(sums.squares_of_differences[1], 10);
  EXPECT_EQ(sums.fourths_of_differences[1], 82);
}

// What has not been seen goes with the scores: errors of an environment and of its difference are
// those of the echo times what the scores are. Seen red: with the unseen of the echo itself in
// both; with none.
TEST(EnvironmentScores, HaveTheirShareOfWhatHasNotBeenSeen) {
  Tallies t(0, 1);
  test::Random random(33);
  std::array<double, EnvironmentScores::size> ratio{};
  ratio.fill(1.2);
  for (int batch = 0; batch < 40; ++batch) {
    for (int k = 0; k < 100; ++k) {
      const double value = 1e-6 * std::pow(random.uniform(), -1 / 1.5);
      const Score score{0, 0, 1, 2.5, t.path_in(0), value};
      t.batch.score(score, t.batch.bins(score.path, score.depth), ratio.data());
    }
    t.end_batch(2000);
  }
  const Result r = t.result();
  const double error = r.echo.standard_error[0];
  EXPECT_GT(error, 1.2 * standard_error(t.totals.state().echo[0].low, t.totals.counted(0)));
  EXPECT_NEAR(r.environment_echo.standard_error[0] / error, 1.2, 0.12);
  EXPECT_NEAR(r.environment_difference.standard_error[0] / error, 0.2, 0.02);
}

// What is negligible in an echo may be all of a difference. Seen red: with a thousandth of the echo
// for one of the difference.
TEST(EnvironmentFlags, WhatIsNegligibleIsMeasuredByTheDifference) {
  for (const double odd : {1.1, 0.9}) {
    Tallies t(0, 1);
    std::array<double, EnvironmentScores::size> ratio{};
    for (int batch = 0; batch < 40; ++batch) {
      for (int k = 0; k < 8000 + 8 * (batch % 2); ++k) {
        ratio.fill(k % 2 == 0 || k >= 8000 ? 1.1 : odd);
        const double value = k < 4 ? 4e-6 * falling_off(40 * k + batch, 160, 4) : 1e-6;
        const Score score{0, 0, 1, 2.5, t.path_in(0), value};
        t.batch.score(score, t.batch.bins(score.path, score.depth), ratio.data());
      }
      t.end_batch(2000);
    }
    const Result r = t.result();
    EXPECT_EQ(r.convergence_flags[0], 0);
    EXPECT_EQ(r.environment_convergence_flags[0], odd > 1 ? 0 : heavy_tail);
  }
}

/// The flags of an environment in four gates, all with steady echoes, but for some where once it
/// has a very large score.
std::vector<std::int32_t> flags_with_large_scores_in(const std::vector<std::int32_t>& gates) {
  Tallies t(0, 1);
  test::Random random(32);
  for (int batch = 0; batch < 40; ++batch) {
    for (std::int32_t gate = 0; gate < 4; ++gate) {
      for (int k = 0; k < 100; ++k) {
        const bool large = batch == 20 && k == 0 && std::ranges::find(gates, gate) != gates.end();
        const std::array<double, EnvironmentScores::size> ratio{large ? 1e4 : 1.1 + 1e-3 * k};
        const Score score{
            0, 0, 1, 5.0 * gate + 2.5, t.path_in(gate), random.between(0.5e-3, 1.5e-3)};
        t.batch.score(score, t.batch.bins(score.path, score.depth), ratio.data());
      }
    }
    t.end_batch(2000);
  }
  const auto all = t.result().environment_convergence_flags;
  return {all.begin(), all.begin() + 4};
}

// The others have no score. Seen red: without the look at the gates around; with half of them for
// most.
TEST(EnvironmentFlags, GatesAmongFlaggedOnesAreFlagged) {
  const auto none = flags_with_large_scores_in({});
  EXPECT_EQ(none, (std::vector<std::int32_t>(4, 0)));
  const auto one = flags_with_large_scores_in({1});
  EXPECT_NE(one[1] & heavy_tail, 0);
  EXPECT_EQ(one[0], 0);  // one of three
  EXPECT_EQ(one[2], 0);
  const auto two = flags_with_large_scores_in({1, 2});
  EXPECT_EQ(two[1] & among_flagged, 0);  // for what it is itself
  EXPECT_EQ(two[0], among_flagged);      // two of three
  EXPECT_EQ(two[3], among_flagged);
  const auto of_four = flags_with_large_scores_in({0, 3});
  EXPECT_EQ(of_four[1], 0);  // half of them
}

}  // namespace
}  // namespace photic::tally
