#include "medium/bent_axis.hpp"

#include <algorithm>
#include <cmath>

namespace photic::medium {
namespace {

struct Step {
  double thickness_m, index, group_index;
};
/// From the sea up to a height; what is above the air has no index.
std::vector<Step> steps_to(const Air& air, double height_m) {
  std::vector<Step> out;
  for (std::size_t k = 0; k < air.layers(); ++k) {
    const double within = std::min(height_m, air.height_m[k + 1]) - air.height_m[k];
    if (within > 0) out.push_back({within, air.refractive_index[k], air.group_index[k]});
  }
  if (height_m > air.height_m.back()) out.push_back({height_m - air.height_m.back(), 1, 1});
  return out;
}

}  // namespace

/// With p = n sin(theta), D(p) = sum of h p / sqrt(n^2 - p^2): theory.md, eq. 103.
BentAxis bent_axis(const Air& air, double height_m, double cosine) {
  BentAxis out;
  const auto steps = steps_to(air, height_m);
  const double at_sea = air.refractive_index.front();
  const double at_instrument = steps.empty() ? at_sea : steps.back().index;
  const double p = at_instrument * std::sqrt(1 - cosine * cosine);
  double aside_over_p = 0, aside_per_p = 0;
  for (const Step& s : steps) {
    const double root = std::sqrt(s.index * s.index - p * p);
    aside_over_p += s.thickness_m / root;
    aside_per_p += s.thickness_m * s.index * s.index / (root * root * root);
    out.length_m += s.thickness_m * s.index / root;
    out.group_path_m += s.thickness_m * s.group_index * s.index / root;
  }
  out.aside_m = aside_over_p * p;
  out.cosine = std::sqrt(1 - p * p / (at_sea * at_sea));
  const double across = at_sea * aside_over_p;
  const double along = at_sea * out.cosine * out.cosine * aside_per_p;
  out.apparent_distance_m = std::sqrt(across * along * cosine / out.cosine);
  out.apparent_angle = at_instrument / at_sea;
  return out;
}

}  // namespace photic::medium
