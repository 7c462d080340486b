#include "scene/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "core/interpolation.hpp"

namespace photic::scene {

LinearProfile::LinearProfile(std::vector<double> depth_m, std::vector<double> value)
    : depth_m_(std::move(depth_m)), value_(std::move(value)) {
  expect(depth_m_.size() == value_.size() && depth_m_.size() >= 2,
         "a profile has as many depths as values, two or more");
}

void LinearProfile::reach(double from_m, double to_m) {
  if (from_m < first_m()) {
    depth_m_.insert(depth_m_.begin(), from_m);
    value_.insert(value_.begin(), value_.front());
  }
  if (to_m > last_m()) {
    depth_m_.push_back(to_m);
    value_.push_back(value_.back());
  }
}

double LinearProfile::at(double depth_m) const {
  const auto [i, t] = interval_of(depth_m_, depth_m);
  return std::lerp(value_[i - 1], value_[i], t);
}

double LinearProfile::integral(double a_m, double b_m) const {
  double sum = 0;
  double depth = a_m, value = at(a_m);
  const auto add = [&](double next_depth, double next_value) {
    sum += (next_depth - depth) * (value + next_value) / 2;
    depth = next_depth;
    value = next_value;
  };
  const auto first = std::upper_bound(depth_m_.begin(), depth_m_.end(), a_m);
  for (auto knot = first; knot != depth_m_.end() && *knot < b_m; ++knot)
    add(*knot, value_[static_cast<std::size_t>(knot - depth_m_.begin())]);
  add(b_m, at(b_m));
  return sum;
}

Extremes LinearProfile::extremes(double a_m, double b_m) const {
  const auto [low, high] = std::minmax({at(a_m), at(b_m)});
  Extremes found{low, high};
  const auto first = std::upper_bound(depth_m_.begin(), depth_m_.end(), a_m);
  for (auto knot = first; knot != depth_m_.end() && *knot < b_m; ++knot) {
    const double value = value_[static_cast<std::size_t>(knot - depth_m_.begin())];
    found = {std::min(found.least, value), std::max(found.greatest, value)};
  }
  return found;
}

double GaussianProfile::integral(double a_m, double b_m) const {
  const double unit = width_m * std::numbers::sqrt2;
  const double share = std::erf((b_m - depth_m) / unit) - std::erf((a_m - depth_m) / unit);
  return background * (b_m - a_m) +
         (maximum - background) * unit / (2 * std::numbers::inv_sqrtpi) * share;
}

Extremes GaussianProfile::extremes(double a_m, double b_m) const {
  const auto at = [&](double depth) {
    const double x = (depth - depth_m) / width_m;
    return background + (maximum - background) * std::exp(-x * x / 2);
  };
  // It falls on both sides of its depth.
  return {std::min(at(a_m), at(b_m)), at(std::clamp(depth_m, a_m, b_m))};
}

}  // namespace photic::scene
