// What a batch scores in environments.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "tally/batch_tally.hpp"

namespace photic::tally {
namespace {

// Seen red: with the fourth power of scores for that of differences; with what is not finite added.
TEST(EnvironmentScores, AreAddedEachByItsRatio) {
  EnvironmentScores sums;
  const std::array<float, EnvironmentScores::size> ratio{
      1, 2, 0, std::numeric_limits<float>::infinity(), -1, 0.5, 1, 1};
  sums.add(3.0, ratio.data());
  sums.add(1.0, ratio.data());
  EXPECT_EQ(sums.echo, (EnvironmentScores::Each{4, 8, 0, 0, -4, 2, 4, 4}));
  EXPECT_EQ(sums.difference, (EnvironmentScores::Each{0, 4, -4, 0, -8, -2, 0, 0}));
  EXPECT_EQ(sums.largest, (EnvironmentScores::Each{3, 6, 0, 0, 0, 1.5, 3, 3}));
  EXPECT_EQ(sums.not_finite, (EnvironmentScores::Each{0, 0, 0, 2, 0, 0, 0, 0}));
  EXPECT_EQ(sums.squares[1], 40);
  EXPECT_EQ(sums.fourths[1], 1312);
  EXPECT_EQ(sums.squares_of_differences[1], 10);
  EXPECT_EQ(sums.fourths_of_differences[1], 82);
}

}  // namespace
}  // namespace photic::tally
