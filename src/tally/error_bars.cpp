#include "tally/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace photic::tally {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double error_of_sum(const Sums& s, const Counted& n) {
  if (n.batches < 2) return not_known;
  const double spread = std::max(0.0, s.xx - s.x * s.x / n.photons);
  return std::sqrt(spread / (n.batches - 1) * n.photons);
}

double with_unseen(double error, double unseen) {
  return std::isfinite(unseen) ? std::hypot(error, unseen) : error;
}

double variance_of_variance(const TailSums& s, const Counted& n) {
  if (n.batches < 2) return not_known;
  const auto [second, fourth] = s.central(n.photons);
  return second > 0 ? std::max(0.0, fourth / (second * second) - 1) / n.batches : 0.0;
}

double error_of_ratio(double ratio, double denominator, double error_of_numerator,
                      double error_of_denominator, double error_of_sum) {
  const double of_numerator = error_of_numerator * error_of_numerator;
  const double of_denominator = error_of_denominator * error_of_denominator;
  const double covariance = (error_of_sum * error_of_sum - of_numerator - of_denominator) / 2;
  const double variance = of_numerator - 2 * ratio * covariance + ratio * ratio * of_denominator;
  // NaN if any error is: std::max would make 0 of it.
  return std::sqrt(variance < 0 ? 0.0 : variance) / denominator;
}

}  // namespace photic::tally
