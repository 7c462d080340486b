// Comparing many estimates with what they should be, at one level for all of them together.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <string>
#include <vector>

namespace photic::test {

/// Two-sided |z| that `count` independent standard normals all stay below with probability 1 -
/// level (Šidák).
inline double family_wise_z(double level, std::size_t count) {
  const double each = 1 - std::pow(1 - level, 1.0 / static_cast<double>(count));
  return boost::math::quantile(boost::math::complement(boost::math::normal(), each / 2));
}

/// Collects z-scores of one family and judges them together.
class ZFamily {
 public:
  explicit ZFamily(double level) : level_(level) {}

  void add(double estimate, double expected, double standard_error, const std::string& what) {
    z_.push_back((estimate - expected) / standard_error);
    what_.push_back(what);
  }

  /// Fails for every member beyond the family's limit.
  void judge() const {
    ASSERT_FALSE(z_.empty());
    const double limit = family_wise_z(level_, z_.size());
    for (std::size_t i = 0; i < z_.size(); ++i) {
      EXPECT_LT(std::abs(z_[i]), limit) << what_[i] << " of a family of " << z_.size();
    }
  }

  /// Fails if the scores of independent members scatter more, or less, than standard normals do at
  /// the level: errors that are claimed too small, or too large.
  void judge_spread() const {
    double sum = 0;
    for (const double z : z_) sum += z * z;
    const boost::math::chi_squared distribution(static_cast<double>(z_.size()));
    EXPECT_GT(sum, boost::math::quantile(distribution, level_ / 2)) << "errors claimed too large";
    EXPECT_LT(sum, boost::math::quantile(boost::math::complement(distribution, level_ / 2)))
        << "errors claimed too small";
  }

  /// Fails if the scores scatter more than standard normals do at the level: errors that are
  /// claimed too small. `independent`: the share of the members that are, in effect.
  void judge_scatter(double independent = 1) const {
    const double degrees = independent * static_cast<double>(z_.size());
    const boost::math::chi_squared distribution(degrees);
    const double most = boost::math::quantile(boost::math::complement(distribution, level_));
    EXPECT_LT(rms(), std::sqrt(most / degrees)) << "errors claimed too small";
  }

  [[nodiscard]] std::size_t size() const { return z_.size(); }
  [[nodiscard]] double rms() const {
    double sum = 0;
    for (const double z : z_) sum += z * z;
    return std::sqrt(sum / static_cast<double>(z_.size()));
  }
  /// The largest |z|.
  [[nodiscard]] double largest() const {
    double out = 0;
    for (const double z : z_) out = std::max(out, std::abs(z));
    return out;
  }

 private:
  double level_;
  std::vector<double> z_;
  std::vector<std::string> what_;
};

}  // namespace photic::test
