// The arithmetic of comparing estimators, on made-up numbers.
#include "engine/bench.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace photic::engine {
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

TEST(MeanMerit, IsGeometricOverTheComparedGates) {
  // Seen red: with the arithmetic mean; with gates that are not compared.
  Candidate candidate;
  for (const double f : {1.0, 100.0, 1e6}) candidate.merit.push_back({1.0, f, true});
  Comparison comparison;
  comparison.compared = {true, true, false};
  EXPECT_NEAR(mean_merit(comparison, candidate, 0, 3).value(), 10.0, 1e-12);
  EXPECT_NEAR(mean_merit(comparison, candidate, 1, 3).value(), 100.0, 1e-12);
  EXPECT_FALSE(mean_merit(comparison, candidate, 2, 3).has_value());
}

TEST(BestOf, IsExactAndHasTheLargestMean) {
  // Seen red: with the approximate one; with the least mean.
  Comparison comparison;
  comparison.compared = {false, true};
  const auto enter = [&](const char* name, bool exact, double figure_of_merit) {
    comparison.candidates.push_back({.name = name, .exact = exact, .simulation = {}});
    comparison.candidates.back().merit = {{1.0, 1e9, true}, {1.0, figure_of_merit, true}};
  };
  enter("slow", true, 1.0);
  enter("fast", true, 3.0);
  enter("approximate", false, 9.0);
  enter("medium", true, 2.0);
  EXPECT_EQ(best_of(comparison)->name, "fast");
  comparison.compared = {false, false};
  EXPECT_EQ(best_of(comparison), nullptr);
}

}  // namespace
}  // namespace photic::engine
