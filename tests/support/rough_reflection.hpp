// The light that a rough sea reflects, by quadrature over the slopes of its facets: independent of
// the code under test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "support/absorbers.hpp"

namespace photic::test {

/// Facets with Gaussian slopes along x and y, each facing light by its visibility over Smith's
/// 1 + Lambda, so that no light is gained or lost (Smith 1967, IEEE Trans. Antennas Propag. 15,
/// 668).
class RoughReflection {
 public:
  RoughReflection(double variance_x, double variance_y, double index)
      : deviation_{std::sqrt(variance_x), std::sqrt(variance_y)}, index_(index) {}

  /// The shares that one facet sends into zenith angles between edges, of light that comes down;
  /// the last one is sent down, to another facet.
  [[nodiscard]] std::vector<double> by_one_facet(const Vec3<double>& light,
                                                 const std::vector<double>& edges_deg) const {
    std::vector<double> out(edges_deg.size());
    each_facet(light, many_steps, [&](double weight, const Vec3<double>& reflected) {
      const double zenith_deg = std::acos(reflected.z) / radian_per_degree;
      const auto beyond = std::upper_bound(edges_deg.begin() + 1, edges_deg.end(), zenith_deg);
      out[static_cast<std::size_t>(beyond - edges_deg.begin()) - 1] += weight;
    });
    return out;
  }
  /// All that is reflected in the end, by any number of facets, of light from a zenith angle. For
  /// slopes that are alike to all sides.
  [[nodiscard]] double all(double zenith_deg) {
    if (table_.empty()) fill_table();
    return by_facets(coming_from(zenith_deg * radian_per_degree), table_);
  }
  static Vec3<double> coming_from(double zenith, double azimuth = 0) {
    return {-std::sin(zenith) * std::cos(azimuth), -std::sin(zenith) * std::sin(azimuth),
            -std::cos(zenith)};
  }

 private:
  static constexpr std::size_t angles = 45;
  static constexpr double quarter = pi / 2;
  static constexpr int most_facets = 4, many_steps = 600, few_steps = 48;

  /// The share of light coming down to one more facet that is reflected in the end, by angle.
  void fill_table() {
    table_.assign(angles, 0.0);
    for (int facets = 1; facets < most_facets; ++facets) {
      std::vector<double> more;
      for (std::size_t i = 0; i < angles; ++i)
        more.push_back(
            by_facets(coming_from(quarter * (static_cast<double>(i) + 0.5) / angles), table_));
      table_ = more;
    }
  }

  /// Smith's Lambda.
  [[nodiscard]] double smith(const Vec3<double>& k) const {
    const double spread = std::hypot(deviation_[0] * k.x, deviation_[1] * k.y);
    if (spread == 0) return 0;
    const double a = std::abs(k.z) / (std::sqrt(2.0) * spread);
    return (std::exp(-a * a) / (a * std::sqrt(pi)) - std::erfc(a)) / 2;
  }
  /// Calls f(share of the light, its direction) for what facets reflect of it. Steps are fine along
  /// the light: facets that send it up and those that send it down meet across it.
  template <class F>
  void each_facet(const Vec3<double>& k, int across, F f) const {
    constexpr double widest = 6;  // deviations
    const bool along_x = std::abs(k.x) >= std::abs(k.y);
    const int in_x = along_x ? many_steps : across, in_y = along_x ? across : many_steps;
    const double step_x = 2 * widest / in_x, step_y = 2 * widest / in_y;
    const double norm = step_x * step_y / (2 * pi) / (1 + smith(k));
    for (int i = 0; i < in_x; ++i)
      for (int j = 0; j < in_y; ++j) {
        const double u = (i + 0.5) * step_x - widest, v = (j + 0.5) * step_y - widest;
        const double s_x = u * deviation_[0], s_y = v * deviation_[1];
        const double seen = 1 - (k.x * s_x + k.y * s_y) / k.z;
        if (seen <= 0) continue;
        const Vec3<double> normal = normalised(Vec3<double>{-s_x, -s_y, 1});
        const double cosine = dot(k, normal);
        f(norm * std::exp(-(u * u + v * v) / 2) * seen * refracted(-cosine, index_).first,
          k - 2 * cosine * normal);
      }
  }
  /// `table`: what is reflected in the end of light that comes down to one more facet, by angle.
  [[nodiscard]] double by_facets(const Vec3<double>& light,
                                 const std::vector<double>& table) const {
    double sum = 0;
    each_facet(light, few_steps, [&](double weight, const Vec3<double>& reflected) {
      sum += weight * (reflected.z > 0 ? 1 : at(table, std::acos(-reflected.z)));
    });
    return sum;
  }
  static double at(const std::vector<double>& table, double zenith) {
    const double place = std::clamp(zenith / quarter * angles - 0.5, 0.0, angles - 1.001);
    const auto i = static_cast<std::size_t>(place);
    const double rest = place - static_cast<double>(i);
    return table[i] * (1 - rest) + table[i + 1] * rest;
  }

  std::array<double, 2> deviation_;
  double index_;
  std::vector<double> table_;
};

}  // namespace photic::test
