// What a batch scores in environments.
#include <gtest/gtest.h>

#include <array>

#include "tally/batch_tally.hpp"

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

}  // namespace
}  // namespace photic::tally
