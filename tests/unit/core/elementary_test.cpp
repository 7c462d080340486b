// exp and log of a walk.
#include "core/elementary.hpp"

#include <gtest/gtest.h>

#include "support/lanes4.hpp"
#include "support/random.hpp"

namespace photic {
namespace {

// Seen red: with the last term of the series left out; with `low` taken as 0.
TEST(ExpMinus, IsThatOfTheMathematicsLibrary) {
  test::Random random(1);
  for (int i = 0; i < 1000000; ++i) {
    const double y = random.scale(1e-12, 700);
    const auto exact = static_cast<double>(std::exp(-static_cast<long double>(y)));
    ASSERT_NEAR(exp_minus(y) / exact, 1, 5e-16) << y;
    const auto f = static_cast<float>(std::min(y, 79.0));
    ASSERT_NEAR(exp_minus(f) / std::exp(-f), 1, 5e-7) << y;
    ASSERT_NEAR(exp_minus(-f) / std::exp(f), 1, 5e-7) << -y;
  }
}

TEST(ExpMinus, EndsAtOneAndZero) {
  EXPECT_EQ(exp_minus(0.0), 1);
  EXPECT_EQ(exp_minus(701.0), 0);
  EXPECT_EQ(exp_minus(std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(exp_minus(81.0F), 0);
}

// Free paths are lengths: what counts is the absolute error. Seen red: with the last term of the
// series left out; with the octaves counted towards zero.
TEST(MinusLog, IsThatOfTheMathematicsLibrary) {
  test::Random random(2);
  for (int i = 0; i < 1000000; ++i) {
    const double u = i % 2 == 0 ? random.uniform() : random.scale(1e-12, 1);
    const auto exact = static_cast<double>(-std::log(static_cast<long double>(u)));
    ASSERT_NEAR(minus_log(u), exact, 4e-16 * (1 + exact)) << u;
    const auto f = static_cast<float>(u);
    ASSERT_NEAR(minus_log(f), -std::log(f), 3e-7F * (1 - std::log(f))) << u;
  }
}

TEST(MinusLog, OfTheEnds) {
  EXPECT_EQ(minus_log(1.0), 0);
  EXPECT_NEAR(minus_log(0.5 / 4294967296.0), 33 * std::numbers::ln2, 1e-14);
}

TEST(LanesOf, ElementaryFunctions) {
  test::Random random(3);
  for (int g = 0; g < 10000; ++g) {
    test::Lanes4 y, u;
    for (std::size_t i = 0; i < test::lanes; ++i) {
      y.set(i, random.chance(0.05) ? 1000.0 : random.scale(1e-6, 700));
      u.set(i, random.uniform());
    }
    const auto e = exp_minus(y);
    const auto l = minus_log(u);
    for (std::size_t i = 0; i < test::lanes; ++i) {
      ASSERT_EQ(e[i], exp_minus(y[i]));
      ASSERT_EQ(l[i], minus_log(u[i]));
    }
  }
}

}  // namespace
}  // namespace photic
