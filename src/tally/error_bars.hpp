// Means of batches and their errors, from sums alone (docs/theory.md, "Error bars").
#pragma once

#include "tally/state.hpp"

namespace photic::tally {

/// The photons and batches that a cell has been scored in.
struct Counted {
  double photons = 0, batches = 0;
};

/// Mean per photon.
inline double mean(const Sums& s, const Counted& n) { return s.x / n.photons; }

/// Standard error of the sum, of which every batch is a sample; NaN for a single one, which has no
/// spread.
double error_of_sum(const Sums& s, const Counted& n);

/// Standard error of the mean per photon.
inline double standard_error(const Sums& s, const Counted& n) {
  return error_of_sum(s, n) / n.photons;
}

/// The sum expected of scores too rare to have been seen (docs/theory.md, eq. 76).
struct Unseen {
  double sum = 0;
  double in_error = 0;  ///< without scores that fewer than one run in forty has (eq. 81)
  Unseen& operator+=(const Unseen& other) {
    sum += other.sum;
    in_error += other.in_error;
    return *this;
  }
  friend Unseen operator*(const Unseen& unseen, double factor) {
    return {unseen.sum * factor, unseen.in_error * factor};
  }
};

/// An error with what is expected of scores not seen yet, which is not taken if it is infinite.
double with_unseen(double error, double unseen);

/// Standard error of the mean per photon that is reported, with what has not been seen.
inline double reported_error(const Sums& s, const Counted& n, const Unseen& unseen) {
  return with_unseen(standard_error(s, n), unseen.in_error / n.photons);
}

/// The variance of the variance of the mean, over its square; NaN for a single batch.
double variance_of_variance(const TailSums& s, const Counted& n);

/// Standard error of the ratio of two correlated means, to first order (Cochran, Sampling
/// Techniques, 3rd ed. (1977), chapter 6; docs/theory.md, eq. 48). The covariance follows from the
/// error of the sum.
double error_of_ratio(double ratio, double denominator, double error_of_numerator,
                      double error_of_denominator, double error_of_sum);

}  // namespace photic::tally
