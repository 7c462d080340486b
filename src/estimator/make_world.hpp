// Worlds, made of models.
#pragma once

#include <algorithm>
#include <tuple>

#include "estimator/make_forward_settings.hpp"
#include "estimator/make_instruments.hpp"
#include "estimator/make_walk_settings.hpp"
#include "estimator/plan.hpp"
#include "estimator/reach.hpp"
#include "estimator/tallies/make_tallies.hpp"
#include "estimator/walk_cones.hpp"
#include "estimator/world.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Returns whether a batch's photons or walks begin at points that fill all possibilities evenly.
/// They do not where tails of the forward estimator's scores, which that leaves as they are, may
/// hold more of the echo than the flags can detect: in environments, and where a telescope in the
/// water may be as close to a collision as can be (docs/decisions/0026).
inline bool spreads_evenly(const scene::Scene& scene) {
  const scene::Simulation& asked = scene.simulation;
  const bool in_air =
      std::ranges::all_of(scene.telescope, [](const auto& t) { return t.position_m.z >= 0; });
  return asked.sampling == scene::Sampling::quasi_random &&
         (asked.estimator == scene::Estimator::bidirectional ||
          (asked.estimator == scene::Estimator::forward && !scene.has_environments() && in_air));
}

inline RandomNumbers make_random_numbers(const scene::Scene& scene) {
  RandomNumbers out{scene.simulation.seed, batch_photons(scene.simulation), {}};
  if (spreads_evenly(scene)) out.points = {out.batch_photons, quasi_random_dimensions};
  return out;
}

template <class T>
World<T> make_world(const Model& model) {
  const auto& [scene, medium] = std::tie(model.scene, model.medium);
  const GroupIndices group_index = group_indices(medium);
  const double last_path = model.gates.last_path() + model.apparent_path.max_of_both();
  const Reach reach = reach_of(scene, medium, last_path, group_index.least);
  const WalkCones cones = walk_cones(scene, medium, reach.deepest);
  World<T> world;
  world.slabs = model.paths.slabs(medium);
  world.has_environments = scene.has_environments();
  world.tallies = make_tallies(model, world.slabs);
  world.all_events = world.has_environments || scene.simulation.tools.any() || world.tallies;
  world.instruments = make_instruments<T>(model, world.slabs);
  world.instruments.min_group_index = T(group_index.least);
  world.instruments.all_times = world.tallies != nullptr;
  world.instruments.deadlines =
      deadlines_at_telescopes<T>(scene, last_path + max_lost(cones.laser, model.gates),
                                 ahead_in(medium, scene.source), group_index.greatest);
  world.forward = make_forward_settings(model, world.slabs, world.instruments, world.all_events,
                                        world.tallies.get());
  world.walks = make_walk_settings(model, world.instruments, reach, cones);
  if (const auto& max_order = scene.simulation.max_order)
    world.part.last_order = static_cast<std::int32_t>(*max_order) + 1;
  world.random = make_random_numbers(scene);
  return world;
}

/// The world of a plan's set.
template <class T>
World<T> make_world(const HistorySet& set) {
  World<T> world = make_world<T>(*set.model);
  world.random.key = set.model->scene.simulation.seed ^ set.stream;
  world.part.scored = set.scored;
  if (set.scored == Scored::film) {  // light that the water converts is left to the walks
    world.forward.conversion = T(0);
    world.forward.views.clear();
    world.forward.cones.clear();
  }
  if (set.passes_to) {
    world.part.beyond = {true, set.passes_to->fresh, T(set.passes_to->chance),
                         T(set.passes_to->path_m)};
    world.forward.flies_on = false;  // past the surface without meeting it
  }
  return world;
}

}  // namespace photic::estimator
