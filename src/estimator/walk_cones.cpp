#include "estimator/walk_cones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "estimator/nested_views.hpp"
#include "estimator/origin.hpp"
#include "estimator/strategies.hpp"

namespace photic::estimator {
namespace {

/// Where a view is wider than the part of the sea that sends light back, a share of the telescope's
/// walks is aimed at that part: the laser's spot, widened by scattering in the water [m], most of
/// the light nearest. Each cone has half the angle of the one before, at most. The numbers were
/// tried (docs/decisions/0042).
constexpr double aimed_share = 0.8, next_of_aimed = 0.5;
constexpr std::array scattered_aside{12.0, 6.0, 3.0, 1.5};

/// The half angle about a telescope's axis that holds the laser's spot and so much aside of it [m];
/// pi if it does not see that [rad].
double half_angle_of_light(const scene::Source& source, const scene::Telescope& telescope,
                           double aside) {
  const auto beam = normalised(source.direction), axis = normalised(telescope.direction);
  if (source.position_m.z <= 0 || telescope.position_m.z <= 0 || beam.z >= 0 || axis.z >= 0)
    return pi;
  const double way = source.position_m.z / -beam.z;
  const auto to_spot = source.position_m + way * beam - telescope.position_m;
  const double distance = length(to_spot);
  const double radius =
      (source.radius_of_all() + way * std::tan(source.half_divergence_of_all())) / -beam.z + aside;
  return std::acos(std::min(1.0, dot(to_spot, axis) / distance)) + std::atan(radius / distance);
}

/// Half the angle of the one before, at most, has the next cone in which walks of nested views
/// begin.
constexpr double next_of_nested = 0.5;

/// The narrower cones in which walks of telescopes with nested views begin: in equal shares, from
/// the narrowest view to the widest.
std::vector<InnerCone> in_nested(const scene::Scene& scene, const NestedViews& views) {
  constexpr std::size_t most = EntryCone<double>::max_rings - 1;
  const auto half_angle = [&](std::size_t i) { return half_view(scene.telescope[views[i]]); };
  std::vector<InnerCone> inner;
  double last = half_angle(views.size() - 1);
  for (std::size_t i = views.size() - 1; i-- > 0;) {
    const double far_enough = i == 0 ? last : next_of_nested * last;
    if (half_angle(i) >= far_enough || (i > 0 && inner.size() + 1 == most)) continue;
    inner.push_back({last = half_angle(i), 0});
  }
  for (InnerCone& cone : inner) cone.share = 1 / (1.0 + static_cast<double>(inner.size()));
  return inner;
}

/// The cones that hold the light, of a telescope in a group of its own, in equal shares.
std::vector<InnerCone> aimed_at_light(const scene::Scene& scene, const NestedViews& views) {
  std::vector<InnerCone> inner;
  if (views.size() > 1) return inner;
  const auto& telescope = scene.telescope[views.back()];
  double last = half_view(telescope);
  for (const double aside : scattered_aside) {
    const double half_angle = half_angle_of_light(scene.source, telescope, aside);
    if (half_angle <= next_of_aimed * last) inner.push_back({last = half_angle, 0});
  }
  for (InnerCone& cone : inner) cone.share = aimed_share / static_cast<double>(inner.size());
  return inner;
}

/// The number of meetings of free walks' rays [1/m]; 0: there are none.
double meetings(const scene::Scene& scene, const Strategy& free,
                const std::optional<double>& per_metre) {
  const bool has_any = scene.simulation.estimator == scene::Estimator::bidirectional && free.used;
  return has_any ? per_metre.value_or(0) : 0;
}

}  // namespace

WalkCones walk_cones(const scene::Scene& scene, const medium::Medium& medium, double deepest) {
  const scene::Simulation& asked = scene.simulation;
  WalkCones out;
  if (asked.estimator != scene::Estimator::bidirectional) {  // there are no walks
    out.telescope.resize(scene.telescope.size());
    return out;
  }
  const auto strategies = make_strategies(scene, medium);
  out.free_laser = meetings(scene, strategies.free_laser, asked.free_laser_meetings);
  out.free_telescope = meetings(scene, strategies.free_telescope, asked.free_telescope_meetings);
  const Vec3<double> origin = origin_of(scene.source, medium.kind);
  const auto source = from_origin(scene.source, origin);
  const bool rough = !medium.view().surface.one_direction_each;
  const auto through_waves = [&](const auto& instrument) {
    return rough && instrument.position_m.z >= 0;
  };
  out.laser = through_waves(source) ? cone_under_waves(source, medium, deepest, out.free_laser > 0)
              : out.free_laser > 0 && !rough ? entry_cone(source, medium, deepest)
                                             : cone_of_own_rays(source, medium);
  out.telescope.resize(scene.telescope.size());
  for (const NestedViews& views : nested_views(scene)) {
    const auto widest = from_origin(scene.telescope[views.back()], origin);
    auto inner = in_nested(scene, views);
    if (out.free_laser > 0)
      for (const InnerCone& cone : aimed_at_light(scene, views)) inner.push_back(cone);
    auto& cone = out.telescope[views.back()];
    if (through_waves(widest)) {
      cone = cone_under_waves(widest, medium, deepest, out.free_telescope > 0);
      continue;
    }
    if (out.free_telescope > 0 && !rough) cone = entry_cone(widest, medium, deepest, inner);
    if (!cone.by_depth) cone = cone_of_own_rays(widest, medium, inner);
  }
  return out;
}

std::vector<std::string> reported_aimed_walks(const scene::Scene& scene,
                                              const medium::Medium& medium) {
  std::vector<std::string> out;
  const auto of_laser = make_strategies(scene, medium).free_laser;
  if (meetings(scene, of_laser, scene.simulation.free_laser_meetings) == 0) return out;
  for (const NestedViews& views : nested_views(scene)) {
    const auto aimed = aimed_at_light(scene, views);
    if (aimed.empty()) continue;
    std::string angles;
    for (const InnerCone& cone : aimed)
      angles += fmt::format("{}{:.3g}", angles.empty() ? "" : ", ", cone.half_angle * 1e3);
    out.push_back(fmt::format(
        "walks from {}: a share of {:g} aimed at the laser's light, within {} mrad about the axis",
        scene.telescope[views.back()].name, aimed_share, angles));
  }
  return out;
}

}  // namespace photic::estimator
