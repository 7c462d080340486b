#include "core/interpolation.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace photic {
namespace {

TEST(LinearTable, IsExactAtItsPointsAndStraightBetween) {
  const LinearTable table({1, 2, 4}, {0.1, 0.3, -0.7});
  EXPECT_EQ(table(1), 0.1);
  EXPECT_EQ(table(2), 0.3);
  EXPECT_EQ(table(4), -0.7);
  EXPECT_NEAR(table(1.25), 0.15, 1e-15);
  EXPECT_NEAR(table(3), -0.2, 1e-15);
}

// Seen red: with the interval below at its upper end; without halves.
TEST(IntervalOf, IsTheFirstOrTheLastOutside) {
  const std::vector<double> x{1, 2, 4};
  const auto expect_interval = [&](double at, std::size_t upper, double t) {
    EXPECT_EQ(interval_of(x, at).upper, upper) << at;
    EXPECT_DOUBLE_EQ(interval_of(x, at).t, t) << at;
  };
  expect_interval(0, 1, -1);
  expect_interval(1, 1, 0);
  expect_interval(2, 2, 0);
  expect_interval(3, 2, 0.5);
  expect_interval(6, 2, 2);
  EXPECT_DOUBLE_EQ(interval_of({-1.7e308, 1.7e308}, 0).t, 0.5);
}

TEST(LinearTable, RefusesWhatItDoesNotCover) {
  const LinearTable table({1, 2}, {0, 1});
  EXPECT_FALSE(table.covers(0.999));
  EXPECT_FALSE(table.covers(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_THROW(static_cast<void>(table(2.001)), ContractViolation);
}

TEST(LinearTable, RefusesPointsOutOfOrder) {
  EXPECT_THROW(LinearTable({1, 1}, {0, 1}), ContractViolation);
  EXPECT_THROW(LinearTable({1, 2, 3}, {0, 1}), ContractViolation);
  EXPECT_THROW(LinearTable({1}, {0}), ContractViolation);
}

}  // namespace
}  // namespace photic
