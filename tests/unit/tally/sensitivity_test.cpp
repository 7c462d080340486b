// Derivatives of echoes: what the sums of tangents, which are environments to the tallies, come to.
#include <cmath>
#include <vector>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

/// One environment and behind it the tangent of one parameter.
struct Tangent : Tallies {
  explicit Tangent(double value) : Tallies(with_a_tangent()), value_(value) {}

  /// In gate 0; `change` is p d score / d p.
  void add(double score, double change) {
    const double ratios[EnvironmentScores::size] = {2.0, 1 + change / score};
    const Score one{0, 0, 1, 2.5, path_in(0), score};
    batch.score(one, batch.bins(one.path, one.depth), ratios);
  }

  [[nodiscard]] Result result() const {
    Result out;
    out.parameter_value = {value_};
    totals.fill(out);
    return out;
  }

 private:
  static Shape with_a_tangent() {
    Shape shape = make_shape(0, 2, 1);
    shape.tangents = 1;
    return shape;
  }

  double value_;
};

/// What batches scored.
struct ChangedSample {
  double photons, echo, change;
};

std::vector<ChangedSample> correlated_batches() {
  test::Random random(5);
  std::vector<ChangedSample> batches;
  for (int i = 0; i < 40; ++i) {
    const double photons = i == 39 ? 500 : 2000;
    const double echo = photons * random.between(1e-4, 3e-4);
    batches.push_back({photons, echo, -1.5 * echo + photons * random.between(-1e-4, 1e-4)});
  }
  return batches;
}

/// Standard error of the mean of weighted batches, of echo * a + change * b.
double direct_error(const std::vector<ChangedSample>& batches, double a, double b) {
  double sum = 0, photons = 0, squares = 0;
  for (const ChangedSample& s : batches) {
    sum += a * s.echo + b * s.change;
    photons += s.photons;
  }
  for (const ChangedSample& s : batches)
    squares += s.photons * std::pow((a * s.echo + b * s.change) / s.photons - sum / photons, 2);
  return std::sqrt(squares / static_cast<double>(batches.size() - 1) / photons);
}

// The error of the ratio is that of its residuals, change - ratio * echo. Seen red, each for
// itself: without the covariance; with its sign changed; with the value's sign in the error; with
// the environment taken for the tangent.
TEST(Sensitivity, AndItsErrorAreThoseOfTheResiduals) {
  const auto batches = correlated_batches();
  Tangent t(-0.2);
  double echo = 0, change = 0, photons = 0;
  for (const ChangedSample& s : batches) {
    t.add(s.echo, s.change);  // too few in all to know what has not been seen
    t.end_batch(static_cast<std::uint64_t>(s.photons));
    echo += s.echo;
    change += s.change;
    photons += s.photons;
  }
  const Result r = t.result();
  ASSERT_EQ(r.sensitivity.mean.size(), t.shape.cells());
  EXPECT_NEAR(r.sensitivity.mean[0] / (change / photons / -0.2), 1, 1e-12);
  EXPECT_NEAR(r.sensitivity.standard_error[0] / (direct_error(batches, 0, 1) / 0.2), 1, 1e-9);
  const double ratio = change / echo;
  EXPECT_NEAR(r.logarithmic_sensitivity.mean[0] / ratio, 1, 1e-12);
  EXPECT_NEAR(r.logarithmic_sensitivity.standard_error[0] /
                  (direct_error(batches, -ratio, 1) / (echo / photons)),
              1, 1e-9);
  // The environment before it stays what it was.
  ASSERT_EQ(r.environment_echo.mean.size(), t.shape.cells());
  EXPECT_NEAR(r.environment_difference.mean[0] / r.echo.mean[0], 1, 1e-12);
}

// An echo that is proportional to a parameter is so in every batch. Seen red: without the
// covariance.
TEST(Sensitivity, OfAnEchoThatIsProportionalIsCertain) {
  Tangent t(0.5);
  for (const ChangedSample& s : correlated_batches()) {
    t.add(s.echo, s.echo);
    t.end_batch(2000);
  }
  const Result r = t.result();
  EXPECT_NEAR(r.logarithmic_sensitivity.mean[0], 1, 1e-14);
  EXPECT_NEAR(r.logarithmic_sensitivity.standard_error[0], 0, 1e-7);
  EXPECT_NEAR(r.sensitivity.mean[0] / r.echo.mean[0], 2, 1e-14);
  EXPECT_NEAR(r.sensitivity.standard_error[0] / r.echo.standard_error[0], 2, 1e-12);
}

// Seen red: with the larger of 0 and NaN, which std::max takes for 0.
TEST(Sensitivity, OfOneBatchHasNoKnownError) {
  Tangent t(0.5);
  t.add(1e-4, 1e-5);
  t.end_batch(2000);
  const Result r = t.result();
  EXPECT_NEAR(r.logarithmic_sensitivity.mean[0], 0.1, 1e-14);
  EXPECT_TRUE(std::isnan(r.sensitivity.standard_error[0]));
  EXPECT_TRUE(std::isnan(r.logarithmic_sensitivity.standard_error[0]));
}

// Seen red: with 0 for what is not known.
TEST(Sensitivity, WithoutLightIsZeroAndUnknown) {
  Tangent t(0.5);
  for (int batch = 0; batch < 2; ++batch) {
    t.add(1e-4, 1e-5);
    t.end_batch(2000);
  }
  const Result r = t.result();
  EXPECT_EQ(r.sensitivity.mean[1], 0);
  EXPECT_EQ(r.sensitivity.standard_error[1], 0);
  EXPECT_TRUE(std::isnan(r.logarithmic_sensitivity.mean[1]));
  EXPECT_TRUE(std::isnan(r.logarithmic_sensitivity.standard_error[1]));
  EXPECT_EQ(r.sensitivity_convergence_flags[1], no_score);
  EXPECT_EQ(r.sensitivity_convergence_flags[0] & few_batches, few_batches);
}

/// A steady echo of many scores in each batch, `change` being that of each score.
template <class Change>
std::int32_t flags_of_steady_echo(const Change& change) {
  Tangent t(0.5);
  test::Random random(9);
  for (int batch = 0; batch < 64; ++batch) {
    for (int k = 0; k < 50; ++k)
      t.add(1e-5 * random.between(0.9, 1.1), change(batch, k) * random.between(0.5, 1.5));
    t.end_batch(1000);
  }
  const Result r = t.result();
  EXPECT_EQ(r.convergence_flags[0], 0);
  return r.sensitivity_convergence_flags[0];
}

// The line through the scene's echo crosses 0, and is no echo that could be flagged. Seen red: with
// the tangent flagged as an environment is.
TEST(Sensitivity, OfASteadyEchoHasConvergedWhateverItsSize) {
  EXPECT_EQ(flags_of_steady_echo([](int, int) { return -1e-5; }), 0);
  EXPECT_EQ(flags_of_steady_echo([](int, int) { return -7e-5; }), 0);
  EXPECT_EQ(flags_of_steady_echo([](int batch, int k) { return (batch + k) % 2 ? 1e-6 : -1e-6; }),
            0);
}

// Seen red, each for itself: without the fourth powers of differences; without their variance of
// variance.
TEST(Sensitivity, IsFlaggedForItsOwnTail) {
  const auto rare = [](int batch, int k) { return batch == 20 && k == 0 ? 1e-3 : 1e-8; };
  const std::int32_t flags = flags_of_steady_echo(rare);
  EXPECT_EQ(flags & heavy_tail, heavy_tail);
  EXPECT_EQ(flags & uncertain_variance, uncertain_variance);
  const auto odd_batch = [](int batch, int) { return batch == 20 ? 1e-3 : 1e-8; };
  EXPECT_EQ(flags_of_steady_echo(odd_batch), uncertain_variance);
}

// Seen red: with the tangent's own flags alone.
TEST(Sensitivity, IsFlaggedWhereTheEchoIs) {
  Tangent t(0.5);
  test::Random random(10);
  for (int batch = 0; batch < 64; ++batch) {
    for (int k = 0; k < 50; ++k)
      t.add(batch == 20 && k == 0 ? 1e-2 : 1e-5, 1e-6 * random.between(0.5, 1.5));
    t.end_batch(1000);
  }
  const Result r = t.result();
  EXPECT_NE(r.convergence_flags[0], 0);
  EXPECT_EQ(r.sensitivity_convergence_flags[0], r.convergence_flags[0]);
}

}  // namespace
}  // namespace photic::tally
