// The settings of forward histories, made of a model.
#pragma once

#include <tuple>

#include "estimator/forward_settings.hpp"
#include "estimator/instruments.hpp"
#include "estimator/make_instruments.hpp"
#include "estimator/model.hpp"
#include "estimator/tallies/tallies.hpp"
#include "estimator/walk_settings.hpp"
#include "scene/forward_settings.hpp"
#include "scene/walk_settings.hpp"

namespace photic::estimator {

/// Tools are for the water: in the air there are neither forced flights nor importances, which are
/// of depths, and light is scored where it is scattered.
template <class T>
Tools<T> make_tools(const scene::Tools& s, medium::MediumKind kind) {
  Tools<T> tools;
  tools.at_threshold = s.at_threshold;
  if (kind == medium::MediumKind::air) return tools;
  tools.scores_on_the_way = s.local_forced_collisions == scene::LocalForcedCollisions::all;
  tools.forced_flights = Index<T>(static_cast<std::int32_t>(s.forced_collisions));
  for (const auto& [depth_m, value] : s.importance) {
    tools.importance_depth.push_back(T(depth_m));
    tools.importance.push_back(T(value));
  }
  return tools;
}

/// Adds the views of groups, for light that is converted, and the cones in which points are chosen.
/// In the air none is.
template <class T>
void add_views(const Model& model, const Instruments<T>& instruments, ForwardSettings<T>& out) {
  const auto& [scene, medium] = std::tie(model.scene, model.medium);
  const bool converts = medium.line.size() > 1 && medium.kind == medium::MediumKind::water;
  if (!converts && !out.tools.scores_on_the_way) return;
  const Vec3<double> origin = origin_of(scene.source, medium.kind);
  for (const ViewGroup<T>& group : instruments.groups) {
    const scene::Telescope& widest = scene.telescope[group.number];
    const View<T> view =
        make_view<T>(instrument::make_telescope<double>(from_origin(widest, origin)), medium,
                     layer_of(medium, widest));
    out.cones.push_back(view.cone);
    if (converts) out.views.push_back(view);
  }
}

/// The share of directions drawn about those of a radiance: on peaked phase functions its estimate
/// has no finite variance without (docs/theory.md, "Radiance").
inline constexpr double directed_to_radiance = 0.1;

template <class T>
void direct_to_radiance(const Tallies& tallies, ForwardSettings<T>& out) {
  if (!tallies.radiance) return;
  for (const RadianceWay& way : tallies.radiance->ways())
    if (out.radiance_directions.size() < target_capacity)
      out.radiance_directions.push_back(vec3_cast<T>(way.direction));
  out.directed = T(directed_to_radiance);
  out.directs = !out.radiance_directions.empty();
}

/// `all_events`: of the world. `tallies`: beside echoes; may be null.
template <class T>
ForwardSettings<T> make_forward_settings(const Model& model, const geometry::Slabs& slabs,
                                         const Instruments<T>& instruments, bool all_events,
                                         const Tallies* tallies = nullptr) {
  const scene::Scene& scene = model.scene;
  const scene::Simulation& asked = scene.simulation;
  ForwardSettings<T> out;
  // Histories beside walks end where walks do.
  out.weight_threshold =
      T(asked.estimator == scene::Estimator::bidirectional ? min_weight
                                                           : asked.tools.weight_threshold);
  out.tools = make_tools<T>(asked.tools, model.medium.kind);
  if (!out.tools.scores_on_the_way)
    out.scored_points = static_cast<std::int32_t>(scene::scored_points_in(scene));
  add_views(model, instruments, out);
  out.directed = T(scene::directed_fraction_in(scene));
  out.directs = scene::directed_fraction_in(scene) > 0;
  if (tallies != nullptr && scene.telescope.empty()) direct_to_radiance(*tallies, out);
  out.flies_on = out.directs && !all_events && out.cones.empty() &&
                 slabs.surface.one_direction_each && !slabs.surface.absorbs && !slabs.row.has_faces;
  out.single_rays = asked.reception == scene::Reception::ray;
  out.conversion = T(asked.conversion_probability.value_or(scene::usual_conversion_probability));
  const bool one_way =
      instruments.groups.size() == 1 && instruments.telescope_region.front().outside;
  out.makes_choices = (out.directs && !one_way) || model.medium.line.size() > 1;
  return out;
}

}  // namespace photic::estimator
