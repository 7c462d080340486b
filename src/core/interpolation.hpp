// A function known at points, with straight lines between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace photic {

/// Between two values, neither below 0, a straight line of the logarithm, which goes from 0 to 1
/// with t; a straight line of the value where one of them is 0.
inline double geometric_lerp(double from, double to, double t) {
  return from == 0 || to == 0 ? (1 - t) * from + t * to : std::pow(from, 1 - t) * std::pow(to, t);
}

/// The place of a number among others.
struct Interval {
  std::size_t upper;  ///< the index of the interval's upper end, at least 1
  double t;           ///< the way from the lower end, 0, to the upper, 1; beyond where x is outside
};

/// The interval of two or more ascending numbers that x is in: the first or the last for x outside.
inline Interval interval_of(const std::vector<double>& ascending, double x) {
  const auto above = std::upper_bound(ascending.begin() + 1, ascending.end() - 1, x);
  const double low = *(above - 1), high = *above;
  // Halves are exact, and their differences finite.
  return {static_cast<std::size_t>(above - ascending.begin()),
          (x / 2 - low / 2) / (high / 2 - low / 2)};
}

class LinearTable {
 public:
  /// The same number (at least 2) of x, strictly ascending, and y.
  LinearTable(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
    expect(x_.size() == y_.size() && x_.size() >= 2, "a table has as many x as y, two or more");
    const bool ascending =
        std::adjacent_find(x_.begin(), x_.end(), std::greater_equal<>()) == x_.end();
    expect(ascending, "the x of a table ascend strictly");
  }

  [[nodiscard]] double min() const { return x_.front(); }
  [[nodiscard]] double max() const { return x_.back(); }
  [[nodiscard]] bool covers(double x) const { return min() <= x && x <= max(); }

  /// The value at x, which the table must cover; exactly y at its points.
  [[nodiscard]] double operator()(double x) const {
    expect(covers(x), "a table is asked for what it covers");
    const auto [i, t] = interval_of(x_, x);
    return (1 - t) * y_[i - 1] + t * y_[i];
  }

 private:
  std::vector<double> x_, y_;
};

}  // namespace photic
