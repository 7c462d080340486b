#include "estimator/strategies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/constants.hpp"
#include "estimator/entry_cone.hpp"
#include "estimator/nested_views.hpp"
#include "geometry/axis.hpp"
#include "instrument/laser.hpp"
#include "instrument/lens.hpp"
#include "scene/walk_settings.hpp"

namespace photic::estimator {
namespace {

/// The most means of phase functions over the cones of instruments.
constexpr std::size_t max_means = 500;

Strategy off(std::string name, std::string reason) {
  return {std::move(name), false, std::move(reason)};
}

Strategy to_laser(const scene::Scene& scene, const medium::SurfaceTraits& surface) {
  const std::string name = "walks from telescopes connected to the laser";
  if (!surface.one_direction_each && scene.source.position_m.z >= 0) {
    if (!surface.leads_anywhere)
      return off(name, "one-dimensional waves lead none of its rays to a given point");
    return {name, true, "where a ray of it comes through waves"};
  }
  const auto laser = instrument::make_laser<double>(scene.source);
  if (laser.collimated) return off(name, "its rays are parallel, and no other ray meets them");
  if (!instrument::can_be_met(laser))
    return off(name, "its rays seem to come from below the surface");
  return {name, true, {}};
}

Strategy translated(const scene::Scene& scene) {
  Strategy out{"walks from telescopes translated so that rays meet", true, {}};
  std::string flat;
  for (const auto& t : scene.telescope)
    if (std::abs(normalised(t.direction).z) < instrument::flattest_translated)
      flat += (flat.empty() ? "" : ", ") + t.name;
  if (!flat.empty())
    out.reason = fmt::format("from {} only rays steeper than {:.0f} degrees", flat,
                             90 - std::acos(instrument::flattest_translated) / radian_per_degree);
  return out;
}

Strategy rotated(const medium::Medium& medium, const Vec3<double>& beam) {
  const std::string name = "walks from telescopes rotated about a vertical so that rays meet";
  if (medium.line.size() > 1 && (beam.x != 0 || beam.y != 0))
    return off(name, "light is converted, and looked for about a beam that is not vertical");
  if (!medium.view().surface.isotropic)
    return {name, true, "where anisotropic waves have not met what is rotated"};
  return {name, true, {}};
}

const char* const in_water_under_waves = "it is in the water, and waves have no mirror images";
std::string waves_are_wider(const char* than, const medium::SurfaceTraits& surface) {
  if (!surface.leads_anywhere) return "one-dimensional waves lead no ray to a given point";
  return fmt::format("waves spread light wider than {} is on the surface", than);
}

/// The free walks of telescopes, or the reason why some cannot be free.
Strategy free_telescopes(const scene::Scene& scene, const medium::Medium& medium) {
  Strategy out{"free walks of telescopes", false, {}};
  const medium::SurfaceTraits surface = medium.view().surface;
  const bool rough = !surface.one_direction_each;
  std::map<std::string, std::string> bound;  // by the reason
  for (const auto& t : scene.telescope) {
    if (rough ? enters_by_slopes(t, medium) : entry_cone(t, medium, 0).by_depth) {
      out.used = true;
      continue;
    }
    const bool in_water = geometry::stands_in_water(t.position_m);
    std::string& names = bound[!rough     ? "in the water, and tilted or with a view to the side"
                               : in_water ? in_water_under_waves
                                          : waves_are_wider("the view", surface)];
    names += (names.empty() ? "" : ", ") + t.name;
  }
  for (const auto& [reason, names] : bound)
    out.reason += fmt::format("{}not from {}: {}", out.reason.empty() ? "" : "; ", names, reason);
  return out;
}
Strategy free_laser(const scene::Scene& scene, const medium::Medium& medium) {
  const std::string name = "free walks of the laser";
  const auto laser = instrument::make_laser<double>(scene.source);
  if (laser.collimated) return off(name, "its rays are parallel");
  if (!instrument::can_be_met(laser))
    return off(name, "its rays seem to come from below the surface");
  const medium::SurfaceTraits surface = medium.view().surface;
  if (!surface.one_direction_each) {
    if (scene.source.position_m.z < 0) return off(name, in_water_under_waves);
    if (!enters_by_slopes(scene.source, medium))
      return off(name, waves_are_wider("the beam", surface));
    return {name, true, {}};
  }
  if (!entry_cone(scene.source, medium, 0).by_depth)
    return off(name, "it is in the water, and tilted or with rays to the side");
  return {name, true, {}};
}
/// Reports the number of their meetings, as a scene has it.
void report_meetings(const std::optional<double>& per_metre, Strategy& strategy) {
  if (!strategy.used) return;
  const std::string limit = strategy.reason.empty() ? "" : "; " + strategy.reason;
  if (!per_metre) {
    strategy.reason = "as pilot runs found" + limit;
  } else if (*per_metre == 0) {
    strategy = off(strategy.name, "they cost more than they give, or are not requested");
  } else {
    strategy.reason =
        fmt::format("two rays meet {:.2g} times per metre of depth{}", *per_metre, limit);
  }
}

}  // namespace

Vec3<double> beam_in_water(const scene::Scene& scene, const medium::Medium& medium) {
  const auto axis = normalised(scene.source.direction);
  const double n = medium.line.front().refractive_index;
  return geometry::axis_in_water(scene.source.position_m, axis, n).direction;
}

Strategies make_strategies(const scene::Scene& scene, const medium::Medium& medium) {
  Strategies out;
  out.to_laser = to_laser(scene, medium.view().surface);
  out.between = {"walks from both sides connected", true,
                 fmt::format("a share of {:g}", scene.simulation.connected_fraction.value_or(
                                                    scene::usual_connected_fraction))};
  out.translated = translated(scene);
  out.rotated = rotated(medium, beam_in_water(scene, medium));
  out.rotated_scattered = out.rotated;
  out.rotated_scattered.name += ", of light that is not converted";
  // The effect of environments on the angle that a rotation changes is not known apart.
  if (out.rotated.used && scene.has_environments())
    out.rotated_scattered = off(out.rotated_scattered.name,
                                "environments or derivatives are requested, for which the angle "
                                "that this changes is not recorded");
  out.free_telescope = free_telescopes(scene, medium);
  out.free_laser = free_laser(scene, medium);
  // Each phase function takes a millisecond and 90 kB for each instrument.
  const std::size_t means =
      static_cast<std::size_t>(medium.phase_count()) * (1 + nested_views(scene).size());
  if (means > max_means) {
    const std::string reason = fmt::format(
        "{} means of phase functions over views would be needed, more than {}", means, max_means);
    for (Strategy* free : {&out.free_telescope, &out.free_laser}) *free = off(free->name, reason);
  }
  return out;
}

std::vector<std::string> Strategies::report() const {
  std::vector<std::string> out;
  for (const Strategy* s : {&to_laser, &between, &translated, &rotated, &rotated_scattered,
                            &free_telescope, &free_laser}) {
    const std::string reason = s->reason.empty() ? "" : ": " + s->reason;
    out.push_back(fmt::format("{}: {}{}", s->name, s->used ? "yes" : "no", reason));
  }
  return out;
}

std::vector<std::string> reported_strategies(const scene::Scene& scene,
                                             const medium::Medium& medium) {
  if (scene.simulation.estimator != scene::Estimator::bidirectional) return {};
  auto strategies = make_strategies(scene, medium);
  report_meetings(scene.simulation.free_telescope_meetings, strategies.free_telescope);
  report_meetings(scene.simulation.free_laser_meetings, strategies.free_laser);
  return strategies.report();
}

}  // namespace photic::estimator
