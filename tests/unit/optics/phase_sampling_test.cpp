// Samples of every phase function against its formula: chi-squared, 1 % over the whole family.
#include <numeric>
#include <random>

#include "support/chi_squared.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

constexpr int samples = 400000;

/// Edges of bins in x: four inside the core, then three in each octave.
std::vector<double> edges() {
  std::vector<double> x{0, 0.25 * PhaseView::x_core, 0.5 * PhaseView::x_core,
                        0.75 * PhaseView::x_core};
  for (int octave = PhaseView::core_exponent; octave < 1; ++octave) {
    for (const double step : {1.0, 1.25, 1.5}) x.push_back(std::ldexp(step, octave));
  }
  x.push_back(2);
  return x;
}

/// Shares of the bins: of the formula, not of the table; the core is flat.
std::vector<double> expected_shares(const PhaseShape& shape) {
  const std::vector<double> x = edges();
  std::vector<double> share;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const bool core = x[i + 1] <= PhaseView::x_core;
    share.push_back(core ? shape.core_mass / 4 : integral(shape.p, x[i], x[i + 1]));
  }
  return share;
}

template <class T>
std::vector<double> sampled_counts(const PhaseTable& table, std::uint64_t seed) {
  const std::vector<double> x = edges();
  std::vector<double> count(x.size() - 1, 0.0);
  std::mt19937_64 engine(seed);
  for (int i = 0; i < samples; ++i) {
    // Midpoints of a grid that T can hold: never 0 or 1.
    const int digits = std::min(52, std::numeric_limits<T>::digits - 1);
    const T u = std::ldexp(static_cast<T>(engine() >> (64 - digits)) + T(0.5), -digits);
    const double sample = static_cast<double>(table.view().template sample<T>(u));
    const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, sample);
    count[static_cast<std::size_t>(above - x.begin()) - 1] += 1;
  }
  return count;
}

/// Joins neighbouring bins until each expects 20 or more.
void join_bins(std::vector<double>& count, std::vector<double>& share) {
  std::vector<double> counts, shares;
  double observed = 0, expected = 0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    observed += count[i];
    expected += share[i];
    if (samples * expected < 20) continue;
    counts.push_back(std::exchange(observed, 0));
    shares.push_back(std::exchange(expected, 0));
  }
  counts.back() += observed;  // what is left over at the end
  shares.back() += expected;
  count = counts;
  share = shares;
}

template <class T>
void expect_samples_follow(const NamedShape& named, std::uint64_t seed, double level) {
  std::vector<double> count = sampled_counts<T>(PhaseTable(named.shape), seed);
  std::vector<double> share = expected_shares(named.shape);
  join_bins(count, share);
  ASSERT_GT(share.size(), 5U) << named.name;
  const double sum = std::accumulate(share.begin(), share.end(), 0.0);
  for (double& s : share) s /= sum;  // rounding of the quadrature
  test::expect_chi_squared(count, share, samples, level, named.name);
}

// Seen red: with the guide one cell too far; with the core sampled as x_core sqrt(u); with the core
// flattened and the rest renormalised.
TEST(PhaseSampling, FollowsTheFormulas) {
  const auto shapes = all_shapes();
  const double level =
      0.01 / static_cast<double>(2 * shapes.size());  // Bonferroni: double and float
  std::uint64_t seed = 1;
  for (const NamedShape& named : shapes) {
    expect_samples_follow<double>(named, seed++, level);
    expect_samples_follow<float>(named, seed++, level);
  }
}

}  // namespace
}  // namespace photic::optics
