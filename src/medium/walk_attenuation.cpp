#include "medium/walk_attenuation.hpp"

#include <algorithm>

namespace photic::medium {
namespace {

/// Of the highest albedo (docs/decisions/0010).
constexpr double least_per_albedo = 0.9;

/// Best on most waters (docs/decisions/0010 and 0035).
constexpr double usual = 0.6;

/// Longer free paths and shorter ones than usual. Water that scatters alone is left with the
/// latter.
constexpr double low = 0.35, high = 0.9;
/// Nearer to `high` a value is not worth a try of its own.
constexpr double near_high = 0.8;

}  // namespace

double highest_albedo(const Medium& medium) {
  return *std::max_element(medium.albedo.begin(), medium.albedo.begin() + medium.layers());
}

double least_walk_attenuation(double highest_albedo) { return least_per_albedo * highest_albedo; }

double usual_walk_attenuation(double highest_albedo) {
  return usual >= least_walk_attenuation(highest_albedo) ? usual : std::min(highest_albedo, high);
}

std::vector<double> walk_attenuations(double highest_albedo) {
  std::vector<double> out;
  if (low >= least_walk_attenuation(highest_albedo)) out.push_back(low);
  out.push_back(usual_walk_attenuation(highest_albedo));
  if (out.back() < near_high) out.push_back(high);
  return out;
}

double walk_attenuation_in(const Medium& medium, const scene::Simulation& simulation) {
  return simulation.walk_attenuation.value_or(usual_walk_attenuation(highest_albedo(medium)));
}

}  // namespace photic::medium
