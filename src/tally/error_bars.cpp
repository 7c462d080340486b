#include "tally/error_bars.hpp"

#include <algorithm>
#include <cmath>

namespace photic::tally {

double error_of_sum(const Sums& s, const Counted& n) {
  const double spread = std::max(0.0, s.xx - s.x * s.x / n.photons);
  return n.batches > 1 ? std::sqrt(spread / (n.batches - 1) * n.photons) : 0.0;
}

double variance_of_variance(const TailSums& s, const Counted& n) {
  const auto [second, fourth] = s.central(n.photons);
  return second > 0 ? std::max(0.0, fourth / (second * second) - 1) / n.batches : 0.0;
}

double error_of_ratio(double ratio, double denominator, double error_of_numerator,
                      double error_of_denominator, double error_of_sum) {
  const double of_numerator = error_of_numerator * error_of_numerator;
  const double of_denominator = error_of_denominator * error_of_denominator;
  const double covariance = (error_of_sum * error_of_sum - of_numerator - of_denominator) / 2;
  const double variance = of_numerator - 2 * ratio * covariance + ratio * ratio * of_denominator;
  return std::sqrt(std::max(0.0, variance)) / denominator;
}

}  // namespace photic::tally
