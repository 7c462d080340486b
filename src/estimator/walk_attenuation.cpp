#include "estimator/walk_attenuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace photic::estimator {
namespace {

/// The least walk attenuation, as a share of the highest albedo (docs/decisions/0010).
constexpr double min_per_albedo = 0.9;

/// Best on most waters (docs/decisions/0010 and 0035).
constexpr double usual = 0.6;

/// Longer free paths and shorter ones than usual. Water that scatters alone is left with the
/// latter.
constexpr double low = 0.35, high = 0.9;
/// Nearer to `high` a value is not worth a try of its own.
constexpr double near_high = 0.8;

/// Photons of the forward estimator draw them from scattering alone, absorption being continuous
/// along them: deep light is then reached by more photons, of less weight. Where water hardly
/// scatters, they are drawn from this share of c.
constexpr double min_walk_share = 0.2;

/// Environments draw the free paths of all towards what they would draw them from alone, but the
/// scene's by no more than this factor: its own echo is not to suffer (docs/decisions/0015).
constexpr double max_change_of_walks = 1.5;

/// The share of c that a simulation's free paths are drawn from in water of an albedo.
class Share {
 public:
  Share(const medium::Medium& medium, const scene::Simulation& simulation)
      : analog_(simulation.estimator == scene::Estimator::analog) {
    if (simulation.estimator == scene::Estimator::bidirectional)
      walk_attenuation_ = walk_attenuation_in(medium, simulation);
  }
  double operator()(bool emitted, double albedo) const {
    if (analog_) return 1;  // nothing is absorbed along free paths
    if (!walk_attenuation_) return std::max(albedo, min_walk_share);
    const double own = *walk_attenuation_;
    return emitted && own < 1 ? std::max(emitted_walk_share * own, std::min(own, albedo)) : own;
  }

 private:
  bool analog_ = false;
  std::optional<double> walk_attenuation_;
};

/// In a line and layer: halfway between the least and the most that the environments' own walks
/// would draw them from, near to the scene's own.
double share_in(const medium::Medium& medium, std::size_t cell, const Share& share_of) {
  const auto& c = medium.c;
  const bool emitted = cell >= static_cast<std::size_t>(medium.layers());
  const double own = share_of(emitted, medium.albedo[cell]);
  double least = own;
  double most = own;
  for (std::size_t e = 0; e < static_cast<std::size_t>(medium.environments.first_tangent); ++e) {
    const double other_c = c[cell] + medium.environments.excess_c[e * c.size() + cell];
    const double other_albedo = other_c > 0 ? medium.scattering_in(e, cell) / other_c : 0;
    const double share = other_c / c[cell] * share_of(emitted, other_albedo);
    least = std::min(least, share);
    most = std::max(most, share);
  }
  const double change =
      std::clamp((least + most) / 2 / own, 1 / max_change_of_walks, max_change_of_walks);
  return std::min(own * change, 1.0);
}

/// In thin air free paths are drawn from so much more than its attenuation: some of the light is
/// scattered on its way between the sea and instruments. But air that absorbs is not to become so
/// dense that none comes that far.
double denser_in(const medium::Medium& medium) {
  constexpr double once = 1, most = 1e5, deepest = 2;
  if (medium.kind == medium::MediumKind::water) return 1;
  const double as_deep = std::clamp(deepest / medium.depth_to_instruments, 1.0, most);
  return std::clamp(once / medium.scattering_to_instruments, 1.0, as_deep);
}

}  // namespace

double highest_albedo(const medium::Medium& medium) {
  return *std::max_element(medium.albedo.begin(), medium.albedo.begin() + medium.layers());
}

double min_walk_attenuation(double highest_albedo) { return min_per_albedo * highest_albedo; }

double usual_walk_attenuation(double highest_albedo) {
  return usual >= min_walk_attenuation(highest_albedo) ? usual : std::min(highest_albedo, high);
}

std::vector<double> walk_attenuations(double highest_albedo) {
  std::vector<double> out;
  if (low >= min_walk_attenuation(highest_albedo)) out.push_back(low);
  out.push_back(usual_walk_attenuation(highest_albedo));
  if (out.back() < near_high) out.push_back(high);
  return out;
}

double walk_attenuation_in(const medium::Medium& medium, const scene::Simulation& simulation) {
  return simulation.walk_attenuation.value_or(usual_walk_attenuation(highest_albedo(medium)));
}

void check_walk_attenuation(const scene::Scene& scene, double highest_albedo,
                            scene::Findings& findings) {
  const scene::Simulation& asked = scene.simulation;
  const std::string path = "simulation.walk_attenuation";
  const bool walks = asked.estimator == scene::Estimator::automatic ||
                     asked.estimator == scene::Estimator::bidirectional;
  if (!walks || !asked.walk_attenuation || !findings.good({path, "simulation.estimator"})) return;
  if (*asked.walk_attenuation >= min_walk_attenuation(highest_albedo)) return;
  findings.remark(
      path,
      fmt::format("{} is small for water where scattering is {:.3g} of the attenuation: weights "
                  "grow from vertex to vertex, and deep echoes are low; "
                  "{:.3g} would do",
                  *asked.walk_attenuation, highest_albedo, usual_walk_attenuation(highest_albedo)));
}

std::vector<double> shares_of_free_paths(const medium::Medium& medium,
                                         const scene::Simulation& simulation) {
  const Share share_of(medium, simulation);
  const bool by_chance = simulation.estimator == scene::Estimator::analog;
  const double denser = by_chance ? 1 : denser_in(medium);
  std::vector<double> out;
  for (std::size_t cell = 0; cell < medium.c.size(); ++cell)
    out.push_back(denser * share_in(medium, cell, share_of));
  return out;
}

}  // namespace photic::estimator
