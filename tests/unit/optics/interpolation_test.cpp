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
