// Counts of samples against the probabilities of their cells.
#pragma once

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace photic::test {

/// Fails if counts scatter about `samples` x probability more than chi-squared does at the level.
/// The probabilities may add up to less than 1: the rest is one more cell. Every cell must expect
/// 10 or more.
inline void expect_chi_squared(const std::vector<double>& count,
                               const std::vector<double>& probability, double samples, double level,
                               const std::string& what = "") {
  ASSERT_EQ(count.size(), probability.size()) << what;
  double sum = 0;
  double rest_count = samples;
  double rest_probability = 1;
  int cells = 0;
  const auto add = [&](double observed, double expected) {
    EXPECT_GE(expected, 10) << what << ": too few samples for cell " << cells;
    sum += (observed - expected) * (observed - expected) / expected;
    ++cells;
  };
  for (std::size_t i = 0; i < count.size(); ++i) {
    add(count[i], samples * probability[i]);
    rest_count -= count[i];
    rest_probability -= probability[i];
  }
  if (rest_probability > 1e-9) {
    add(rest_count, samples * rest_probability);
  } else {
    EXPECT_EQ(rest_count, 0) << what << ": samples outside of all cells";
  }
  const boost::math::chi_squared distribution(cells - 1);
  EXPECT_LT(sum, boost::math::quantile(boost::math::complement(distribution, level)))
      << what << ": chi-squared over " << cells << " cells";
}

/// The same for cells of equal probability, as many as there are counts.
inline void expect_uniform(const std::vector<double>& count, double samples, double level,
                           const std::string& what = "") {
  const std::vector<double> equal(count.size(), 1.0 / static_cast<double>(count.size()));
  expect_chi_squared(count, equal, samples, level, what);
}

}  // namespace photic::test
