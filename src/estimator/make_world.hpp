// Worlds, made of models.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "estimator/nested_views.hpp"
#include "estimator/origin.hpp"
#include "estimator/plan.hpp"
#include "estimator/strategies.hpp"
#include "estimator/walk_attenuation.hpp"
#include "estimator/walk_cones.hpp"
#include "estimator/world.hpp"
#include "scene/forward_settings.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Shares of the directions that walks from telescopes draw about the laser's beam: after a
/// conversion, and where they scatter the laser's light in scenes with conversions.
inline constexpr double directed_inverse_conversion = 0.6;
inline constexpr double directed_scattering = 0.1;

/// The probability at a vertex of a telescope's walk in emitted light: where that is hardly
/// scattered, as many conversions are inverted as if its free paths were drawn like those of the
/// laser's light.
inline double inverse_conversion_probability(double conversion_probability) {
  return 1 - std::pow(1 - conversion_probability, 1 / emitted_walk_share);
}

/// One for each group of telescopes and band that a channel counts light of.
template <class T>
void add_receivers(const medium::Medium& medium, World<T>& world) {
  for (std::size_t g = 0; g < world.groups.size(); ++g) {
    const ViewGroup<T>& group = world.groups[g];
    std::int32_t band = -1;
    for (std::size_t l = 0; l < medium.line.size(); ++l) {
      const auto& line = medium.line[l];
      if (l > 0 && line.process == medium.line[l - 1].process) continue;
      if (l > 0) ++band;
      if (line.process == medium::Process::oil) continue;  // walks leave a film's light out
      if (l > 0 || std::ranges::any_of(line.counted_by, [](double share) { return share > 0; }))
        world.receivers.push_back({world.receivers.size(), g, group.number, group.region,
                                   Index<T>(static_cast<std::int32_t>(l)), band});
    }
  }
}

/// The groups of a scene whose telescopes the world has.
template <class T>
void add_groups(const scene::Scene& scene, World<T>& world) {
  for (const NestedViews& views : nested_views(scene)) {
    const std::size_t widest = views.back();
    ViewGroup<T> group{widest,
                       world.telescopes[widest],
                       world.telescope_region[widest],
                       world.path_to_origin[widest],
                       {}};
    for (std::size_t i = views.size() - 1; i-- > 0;)
      group.narrower.push_back({Index<T>(static_cast<std::int32_t>(views[i])),
                                world.telescopes[views[i]].detector_radius});
    world.groups.push_back(std::move(group));
  }
}

/// The number of receivers of a model.
inline std::size_t count_receivers(const Model& model) {
  World<double> world;
  world.groups.resize(nested_views(model.scene).size());
  add_receivers(model.medium, world);
  return world.receivers.size();
}

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

/// The greatest rounding error of paths in the air between an instrument and the sea [m], by which
/// they count as longer: light that the sea mirrors comes hardly later than light that turns at the
/// surface, and must never come before it. It is 0.5 mm from 3 km, 2 cm from space in float:
/// length, delay, and half the sum of both ways are each rounded by half the last digit.
template <class T, class Instrument>
double max_rounded_off(const Instrument& instrument, const medium::Medium& air) {
  const double epsilon = std::numeric_limits<Element<T>>::epsilon();
  return 1.5 * epsilon * std::min(-instrument.position_m.z, air.air_m);
}

template <class T>
World<T> make_world(const Model& model) {
  const auto& [scene, medium, paths, gates, shape, averaged, air, air_tables, others, apparent_path,
               as_given] = model;
  World<T> world;
  world.estimator = scene.simulation.estimator;
  world.sea = paths.slabs(medium);
  const Vec3<double> origin = origin_of(scene.source, medium.upside_down);
  const auto ahead = [&](const auto& instrument) {
    const auto axis = normalised(instrument.direction);
    return medium.upside_down ? geometry::ahead_of_air(instrument.position_m, axis, medium.air_m)
                              : geometry::ahead_of(instrument.position_m, axis);
  };
  const geometry::Ahead laser_ahead = ahead(scene.source);
  world.laser = instrument::make_laser<T>(from_origin(scene.source, origin), laser_ahead);
  const auto layer = [&](const auto& instrument) {
    return medium.layer_at(std::max(0.0, -instrument.position_m.z));
  };
  const auto region = [&](const auto& instrument, std::size_t number) {
    const bool in_air = !geometry::stands_in_water(instrument.position_m);
    geometry::AirColumn column;
    if (in_air && !air_tables.empty())
      column = air_tables[number].view(others.empty() ? -1 : world.sea.excess_air(number));
    return geometry::Region<T>{in_air, Index<T>(layer(instrument)), column};
  };
  world.laser_region = region(scene.source, 0);
  for (const auto& t : scene.telescope) {
    world.telescopes.push_back(instrument::make_telescope<T>(from_origin(t, origin), ahead(t)));
    double left_out =
        path_to_origin(laser_ahead, from_origin(t, origin), world.telescopes.back().above_air);
    if (medium.upside_down)
      left_out += max_rounded_off<T>(scene.source, medium) + max_rounded_off<T>(t, medium);
    world.path_to_origin.push_back(left_out -
                                   apparent_path.both_paths(world.path_to_origin.size()));
    world.telescope_region.push_back(region(t, world.telescopes.size()));
  }
  add_groups(scene, world);
  const bool converts = medium.line.size() > 1;
  const scene::Tools& tools = scene.simulation.tools;
  const bool connects = world.estimator == scene::Estimator::bidirectional;
  world.weight_threshold = T(connects ? min_weight : tools.weight_threshold);
  world.tools = make_tools<T>(tools);
  world.has_environments = scene.has_environments();
  world.all_events = world.has_environments || tools.any();
  if (!world.tools.scores_on_the_way)
    world.scored_points = static_cast<std::int32_t>(scene::scored_points_in(scene));
  for (std::size_t g = 0; (converts || world.tools.scores_on_the_way) && g < world.groups.size();
       ++g) {
    const scene::Telescope& widest = scene.telescope[world.groups[g].number];
    const View<T> view =
        make_view<T>(instrument::make_telescope<double>(from_origin(widest, origin)), medium,
                     static_cast<std::size_t>(layer(widest)));
    world.cones.push_back(view.cone);
    if (converts) world.views.push_back(view);
  }
  double least = medium.line.front().group_index;
  double greatest = least;
  for (const auto& line : medium.line) {
    least = std::min(least, line.group_index);
    greatest = std::max(greatest, line.group_index);
  }
  world.min_group_index = T(least);
  const double last_path = gates.last_path() + apparent_path.max_of_both();
  const Reach reach = reach_of(scene, medium, last_path, least);
  world.deepest = T(reach.deepest);
  world.averaged = model.averaged.view();
  const auto cones = walk_cones(scene, medium, reach.deepest);
  world.free_telescope = {T(cones.free_telescope)};
  world.free_laser = {T(cones.free_laser)};
  world.laser_cone = cone_cast<T>(cones.laser);
  for (const auto& cone : cones.telescope) world.telescope_cones.push_back(cone_cast<T>(cone));
  // The length that free walks may lose counts as more time for those that are not free yet.
  const auto max_shorter = [&](const EntryCone<double>& cone) {
    return std::min(cone.spot.max_shorter, gates.last_path());
  };
  world.connected = T(scene.simulation.connected_fraction);
  world.meeting_grid = {T(scene.simulation.meetings / reach.range)};
  world.directed = T(scene::directed_fraction_in(scene));
  world.directs = scene::directed_fraction_in(scene) > 0;
  world.flies_on = world.directs && !world.all_events && world.cones.empty() &&
                   world.sea.surface.one_direction_each && !world.sea.surface.absorbs;
  world.single_rays = scene.simulation.reception == scene::Reception::ray;
  world.conversion = T(scene.simulation.conversion_probability);
  const Vec3<double> beam = beam_in_water(scene, medium);
  world.inverse_conversion = {
      T(inverse_conversion_probability(scene.simulation.conversion_probability)),
      T(directed_inverse_conversion), vec3_cast<T>(beam), Index<T>(medium.beam_lobe),
      T(converts ? directed_scattering : 0.0)};
  const Strategies strategies = make_strategies(scene, medium);
  world.uses = {strategies.to_laser.used, strategies.between.used, strategies.translated.used,
                strategies.rotated.used, strategies.rotated_scattered.used};
  const bool one_way = world.groups.size() == 1 && world.telescope_region.front().in_air;
  world.makes_choices = (world.directs && !one_way) || medium.line.size() > 1;
  if (connects) world.walks = static_cast<std::size_t>(scene.simulation.walks);
  world.max_vertices = max_vertices;
  add_receivers(medium, world);
  for (Receiver<T>& receiver : world.receivers) {
    const auto& telescope = scene.telescope[receiver.telescope];
    const double both = gates.last_path() - world.path_to_origin[receiver.telescope];
    const double longest =
        both + max_shorter(cones.telescope[receiver.telescope]) + max_shorter(cones.laser) +
        instrument::max_longer(telescope) * (telescope.position_m.z < 0 ? greatest : 1.0);
    receiver.last_path = T(both);
    receiver.longest = T(longest);
    receiver.deadline = deadline_at_laser<T>(scene, longest, laser_ahead);
  }
  world.deadlines = deadlines_at_telescopes<T>(scene, last_path + max_shorter(cones.laser),
                                               laser_ahead, greatest);
  world.last_order =
      scene.simulation.max_order ? static_cast<std::int32_t>(*scene.simulation.max_order) + 1 : 0;
  world.key = scene.simulation.seed;
  world.batch_photons = batch_photons(scene.simulation);
  if (spreads_evenly(scene)) world.points = {world.batch_photons, quasi_random_dimensions};
  return world;
}

/// The world of a plan's set.
template <class T>
World<T> make_world(const HistorySet& set) {
  World<T> world = make_world<T>(*set.model);
  world.key = set.model->scene.simulation.seed ^ set.stream;
  world.scored = set.scored;
  if (set.scored == Scored::film) {  // light that the water converts is left to the walks
    world.conversion = T(0);
    world.views.clear();
    world.cones.clear();
  }
  if (set.passes_to) {
    world.beyond = {true, T(set.passes_to->chance), T(set.passes_to->path_m)};
    world.flies_on = false;  // past the surface without meeting it
  }
  return world;
}

}  // namespace photic::estimator
