#include "medium/walk_attenuation.hpp"

#include <algorithm>

namespace photic::medium {
namespace {

/// Of the highest albedo (docs/decisions/0010). Water that scatters alone is left with 0.9.
constexpr double least_per_albedo = 0.9;

/// Best on most waters (docs/decisions/0010 and 0035).
constexpr double usual = 0.6;

}  // namespace

double highest_albedo(const Medium& medium) {
  return *std::max_element(medium.albedo.begin(), medium.albedo.begin() + medium.layers());
}

double least_walk_attenuation(double highest_albedo) { return least_per_albedo * highest_albedo; }

std::vector<double> walk_attenuations(double highest_albedo) {
  std::vector<double> out{0.35, usual, 0.9};
  std::erase_if(out, [&](double share) { return share < least_walk_attenuation(highest_albedo); });
  return out;
}

double usual_walk_attenuation(double highest_albedo) {
  return std::max(usual, walk_attenuations(highest_albedo).front());
}

double walk_attenuation_in(const Medium& medium, const scene::Simulation& simulation) {
  return simulation.walk_attenuation.value_or(usual_walk_attenuation(highest_albedo(medium)));
}

}  // namespace photic::medium
