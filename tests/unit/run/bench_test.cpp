// The arithmetic of comparing estimators, on made-up numbers.
#include "run/bench.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace photic::run {
namespace {

TEST(Merit, IsOfTheDistanceFromTheReferenceNotOfTheRepeatsOwnSpread) {
  // Two repeats that agree well, both 10 % too low: the square of 10 %, not their spread.
  // Seen red: with the mean of the repeats in place of the reference; without the time.
  const Merit merit = merit_of({0.9, 0.9}, {.mean = 1.0, .standard_error = 0.0}, 4.0);
  EXPECT_TRUE(merit.known);
  EXPECT_NEAR(merit.relative_variance, 0.01, 1e-15);
  EXPECT_NEAR(merit.figure_of_merit, 25.0, 1e-12);
}

TEST(Merit, DoesNotDependOnTheUnitOfTheEcho) {
  // Seen red: with the variance over the reference instead of its square.
  const Merit one = merit_of({0.9, 1.2, 1.1}, {.mean = 1.0, .standard_error = 0.01}, 2.0);
  const Merit other = merit_of({9e-9, 12e-9, 11e-9}, {.mean = 1e-8, .standard_error = 1e-10}, 2.0);
  EXPECT_NEAR(other.figure_of_merit, one.figure_of_merit, 1e-9 * one.figure_of_merit);
  EXPECT_NEAR(one.relative_variance, 0.02 - 1e-4, 1e-15);
}

TEST(Merit, TakesTheReferencesOwnErrorOffIfItIsSmall) {
  // Mean squared distance 4, error of the reference 1: 4 - 1, over 100.
  // Seen red: with nothing taken off.
  const Merit merit = merit_of({12.0, 8.0}, {.mean = 10.0, .standard_error = 1.0}, 1.0);
  EXPECT_TRUE(merit.known);
  EXPECT_NEAR(merit.relative_variance, 0.03, 1e-15);
}

TEST(Merit, IsNotKnownBelowTheErrorOfTheReference) {
  // Seen red: with every merit known.
  const Merit merit = merit_of({12.0, 8.0}, {.mean = 10.0, .standard_error = 1.01}, 1.0);
  EXPECT_FALSE(merit.known);
  EXPECT_NEAR(merit.relative_variance, 0.04, 1e-15);
  EXPECT_FALSE(merit_of({1.0, 1.0}, {.mean = 1.0, .standard_error = 0.0}, 1.0).known);
}

TEST(Merit, OfTwelveRepeatsIsUncertainByFortyPercent) {
  EXPECT_NEAR(relative_uncertainty(12), 0.41, 0.005);
}

TEST(MeritIn, IsTheGeometricMeanOverTheComparedGates) {
  // Seen red: with the arithmetic mean; with gates that are not compared.
  Candidate candidate;
  for (const double f : {1.0, 100.0, 1e6}) candidate.merit.push_back({1.0, f, true});
  Comparison comparison;
  comparison.compared = {true, true, false};
  const auto merit = [&](std::size_t first, Aim aim) {
    return merit_in(comparison, candidate, first, 3, aim);
  };
  EXPECT_NEAR(merit(0, Aim::all_gates).value(), 10.0, 1e-12);
  EXPECT_NEAR(merit(1, Aim::all_gates).value(), 100.0, 1e-12);
  EXPECT_FALSE(merit(2, Aim::all_gates).has_value());
  EXPECT_NEAR(merit(0, Aim::worst_gates).value(), 1.0, 1e-12);
}

/// Two gates, of which the first one is compared on demand.
class BestOf : public testing::Test {
 protected:
  void enter(const char* name, bool exact, double first, double second) {
    comparison_.candidates.push_back({.name = name, .exact = exact, .simulation = {}});
    comparison_.candidates.back().merit = {{1.0, first, true}, {1.0, second, true}};
  }
  Comparison comparison_;
};

TEST_F(BestOf, IsExactAndHasTheLargestMean) {
  // Seen red: with the approximate one; with the least mean.
  comparison_.compared = {false, true};
  enter("slow", true, 1e9, 1.0);
  enter("fast", true, 1e9, 3.0);
  enter("approximate", false, 1e9, 9.0);
  enter("medium", true, 1e9, 2.0);
  EXPECT_EQ(best_of(comparison_)->name, "fast");
  comparison_.compared = {false, false};
  EXPECT_EQ(best_of(comparison_), nullptr);
}

TEST_F(BestOf, IsByTheWorstGatesIfThereIsATarget) {
  // The rule of `auto`. Seen red: by all gates.
  comparison_.compared = {true, true};
  enter("mostly", true, 1e6, 1.0);
  enter("evenly", true, 1e3, 10.0);
  EXPECT_EQ(best_of(comparison_)->name, "mostly");
  comparison_.aim = Aim::worst_gates;
  EXPECT_EQ(best_of(comparison_)->name, "evenly");
}

}  // namespace
}  // namespace photic::run
