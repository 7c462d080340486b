#include "estimator/cone_mean.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/constants.hpp"

namespace photic::estimator {
namespace {

/// A Chebyshev rule for integrals over -1 ... 1 of what square roots divide at both ends.
struct Node {
  double at, weight;
};
std::vector<Node> chebyshev(int n) {
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    const double angle = pi * (i + 0.5) / n;
    nodes.push_back({std::cos(angle), pi / n * std::sin(angle)});
  }
  return nodes;
}

/// The rule for a rim whose far end is by so many powers of e farther than its near one. Means of
/// tables are right within 1e-4; where the edge of their core (0.17 mrad) crosses the rim of a cone
/// of 1 mrad within 1e-3, of narrower ones within 2e-2.
const std::vector<Node>& rule_for(double powers) {
  constexpr double per_power = 5;
  constexpr int least = 4, most = 128;
  static const std::vector<std::vector<Node>> rules = [] {
    std::vector<std::vector<Node>> out;
    for (int n = least; n <= most; ++n) out.push_back(chebyshev(n));
    return out;
  }();
  return rules[static_cast<std::size_t>(std::min(per_power * powers, double{most - least}))];
}

/// 1 - cos of the angle whose half has this tangent.
double x_of(double tangent) { return 2 / (1 + 1 / (tangent * tangent)); }

}  // namespace

void mean_over_cone(double a, double d, std::vector<MeanTerm>& terms) {
  // The mean over a narrower cone is as that over this one, and differences of F keep their digits;
  // so close to the rim it is as a little aside.
  constexpr double narrowest = 1e-8, aside = 1e-6;
  d = std::max(d, narrowest * a);
  if (std::abs(a - d) < aside * d) a = d * (a < d ? 1 - aside : 1 + aside);
  // Tangents of half the angles, and of half the least and the greatest angle to the rim.
  const double tan_a = std::sqrt(a / (2 - a)), tan_d = std::sqrt(d / (2 - d));
  const double near = std::abs(tan_a - tan_d) / (1 + tan_a * tan_d);
  constexpr double farthest = 1e8;
  const double far = std::min(farthest, (tan_a + tan_d) / std::abs(1 - tan_a * tan_d));
  const double from = x_of(near), to = x_of(far);
  const double half = std::log(far / near), per_middle = 1 / (near * far);
  const auto& rule = rule_for(half);
  const double per_solid_angle = 1 / (2 * pi * d), scale = per_solid_angle * half / (2 * pi);
  terms.resize(rule.size());
  double at_axis = a < d ? per_solid_angle : 0;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const double x = 2 / (1 + per_middle * std::exp(half * rule[i].at));
    const double weight =
        scale * rule[i].weight * (d - a + (1 - d) * x) / std::sqrt((x - from) * (to - x));
    terms[i] = {x, weight};
    at_axis -= weight;
  }
  if (a + d > 2) {  // what is scattered straight back is in the cone
    terms.push_back({2, per_solid_angle});
    at_axis -= per_solid_angle;
  }
  terms.push_back({a, at_axis});
}

}  // namespace photic::estimator
