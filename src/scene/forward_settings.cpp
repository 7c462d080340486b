#include "scene/forward_settings.hpp"

#include <algorithm>

namespace photic::scene {
namespace {

constexpr ForwardSettings near_the_sea{0.5, 4};
constexpr ForwardSettings far_above{0.25, 1};
constexpr double far_m = 200;

/// With what the scene names in place of some of them. Directions drawn towards a telescope make
/// fluxes noisy.
ForwardSettings as_named(const Scene& scene, const ForwardSettings& usual) {
  const double directed = scene.tally.empty() ? usual.directed_fraction : 0.0;
  return {scene.simulation.directed_fraction.value_or(directed),
          scene.simulation.scored_points.value_or(usual.scored_points)};
}

ForwardSettings usual_in(const Scene& scene) {
  const bool far = std::ranges::all_of(scene.telescope,
                                       [](const Telescope& t) { return t.position_m.z >= far_m; });
  return as_named(scene, far ? far_above : near_the_sea);
}

}  // namespace

std::vector<ForwardSettings> forward_settings(const Scene& scene) {
  std::vector<ForwardSettings> out{as_named(scene, near_the_sea)};
  const bool in_water =
      std::ranges::any_of(scene.telescope, [](const Telescope& t) { return t.position_m.z < 0; });
  if (in_water) return out;
  if (const auto other = as_named(scene, far_above); other != out.front()) out.push_back(other);
  return out;
}

double directed_fraction_in(const Scene& scene) { return usual_in(scene).directed_fraction; }

std::int64_t scored_points_in(const Scene& scene) { return usual_in(scene).scored_points; }

}  // namespace photic::scene
