#include "estimator/plan.hpp"

#include <algorithm>

#include "estimator/ahead.hpp"
#include "estimator/origin.hpp"
#include "estimator/random_blocks.hpp"

namespace photic::estimator {
namespace {

/// The same model by the forward estimator's histories, in batches as large.
Model by_histories(const Model& model, const std::stop_token& stop) {
  scene::Simulation forward = model.scene.simulation;
  forward.estimator = scene::Estimator::forward;
  forward.batch_photons = batch_photons(model.scene.simulation);
  return simulated_by(model, forward, stop);
}

/// The ways of light through the surface, from one medium's sets to the other's. Most light that
/// leaves the water never comes back: a share of it is followed in the air.
struct Ways {
  Ways(const Model& water, const Model& air)
      : in_water(geometry::stands_in_water(water.scene.source.position_m)) {
    constexpr double least = 0.05, per_optical_depth = 2;
    share = std::clamp(per_optical_depth * air.medium.scattering(), least, 1.0);
    const auto left_out = ahead_in(air.medium, air.scene.source);
    ahead_m = way_ahead(water.scene.source) - left_out.length - left_out.to_sea;
  }
  [[nodiscard]] PassesTo to_air(std::size_t set) const { return {set, share, ahead_m, in_water}; }
  [[nodiscard]] PassesTo to_water(std::size_t set) const { return {set, 1, 0 - ahead_m, false}; }

  bool in_water;  ///< the laser
  double share = 1, ahead_m = 0;
};

/// Photons set out in the medium that the laser stands in.
std::vector<HistorySet> analog_sets(const Model& water, const Model* air) {
  constexpr auto kind = HistorySet::Kind::analog;
  if (air == nullptr) return {{.kind = kind, .model = &water, .in_ledger = true}};
  const Ways ways(water, *air);
  return {{.kind = kind,
           .model = air,
           .stream = air_stream,
           .from_laser = !ways.in_water,
           .in_ledger = true,
           .passes_to = ways.to_water(1)},
          {.kind = kind,
           .model = &water,
           .from_laser = ways.in_water,
           .in_ledger = true,
           .passes_to = ways.to_air(0)}};
}

/// The ledger has the light that sets out in the water: that of a laser in the air sets out there
/// once more.
std::vector<HistorySet> forward_sets(const Model& water, const Model* air) {
  constexpr auto kind = HistorySet::Kind::histories;
  if (air == nullptr) return {{.kind = kind, .model = &water, .in_ledger = true}};
  const Ways ways(water, *air);
  return {{.kind = kind, .model = &water, .in_ledger = true, .passes_to = ways.to_air(1)},
          {.kind = kind,
           .model = air,
           .stream = air_stream,
           .from_laser = !ways.in_water,
           .passes_to = ways.to_water(2)},
          {.kind = kind, .model = &water, .from_laser = false, .passes_to = ways.to_air(1)}};
}

/// The air, of a scene that is simulated as it asks. No walk comes there from an instrument in the
/// water.
Model air_of(const Model& model, const std::stop_token& stop) {
  const bool walks = model.scene.simulation.estimator == scene::Estimator::bidirectional;
  return model_of_air(walks && any_in_water(model.scene) ? by_histories(model, stop) : model, stop);
}

/// Walks stay in one medium, and score light that is scattered there alone. Histories of the
/// forward estimator beside them score what they leave out: the light of a film that shines, with
/// the surface's own echo; and light that is scattered in the water and in the air, or in the air
/// at all where there are no walks.
std::vector<HistorySet> bidirectional_sets(const Model& water, const Model* air,
                                           std::deque<Model>& models, const std::stop_token& stop) {
  using enum HistorySet::Kind;
  std::vector<HistorySet> sets{{.kind = walks, .model = &water, .in_ledger = true}};
  const auto sea = water.medium.view();
  const bool shines = sea.surface.emits;
  if (!shines && !sea.surface.one_direction_each)
    sets.push_back({.kind = surface_echo, .model = &water});
  if (!shines && air == nullptr) return sets;
  const Model& forward = models.emplace_back(by_histories(water, stop));
  if (shines)
    sets.push_back({.kind = histories,
                    .model = &forward,
                    .stream = beside_walks_stream,
                    .scored = Scored::film});
  if (air == nullptr) return sets;
  const bool with_walks = !any_in_water(water.scene);
  const Model& forward_in_air = with_walks ? models.emplace_back(by_histories(*air, stop)) : *air;
  if (with_walks) sets.push_back({.kind = walks, .model = air, .stream = air_stream});
  const Ways ways(water, *air);
  const std::size_t setting_out = sets.size(), in_air = setting_out + 1, in_water = in_air + 1;
  sets.push_back({.kind = histories,
                  .model = &forward,
                  .stream = beside_water_stream,
                  .scored = Scored::none,
                  .passes_to = ways.to_air(in_air)});
  sets.push_back({.kind = histories,
                  .model = &forward_in_air,
                  .stream = beside_air_stream,
                  .scored = with_walks ? Scored::from_water : Scored::all,
                  .from_laser = !ways.in_water,
                  .passes_to = ways.to_water(in_water)});
  sets.push_back({.kind = histories,
                  .model = &forward,
                  .stream = beside_water_stream,
                  .from_laser = false,
                  .passes_to = ways.to_air(in_air)});
  return sets;
}

}  // namespace

Plan make_plan(const Model& model, const std::stop_token& stop) {
  Plan plan;
  const Model* air = model.air ? &plan.models.emplace_back(air_of(model, stop)) : nullptr;
  switch (model.scene.simulation.estimator) {
    case scene::Estimator::bidirectional:
      plan.sets = bidirectional_sets(model, air, plan.models, stop);
      break;
    case scene::Estimator::analog:
      plan.sets = analog_sets(model, air);
      break;
    case scene::Estimator::automatic:  // left open: as forward
    case scene::Estimator::forward:
      plan.sets = forward_sets(model, air);
      break;
  }
  return plan;
}

}  // namespace photic::estimator
