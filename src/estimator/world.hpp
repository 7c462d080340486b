// Everything a history needs, immutable and shared by all threads.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.hpp"
#include "core/sobol.hpp"
#include "estimator/averaged_phases.hpp"
#include "estimator/entry_cone.hpp"
#include "estimator/inverse_conversion.hpp"
#include "estimator/meeting_grid.hpp"
#include "estimator/model.hpp"
#include "estimator/nested_views.hpp"
#include "estimator/origin.hpp"
#include "estimator/reach.hpp"
#include "estimator/strategies.hpp"
#include "estimator/view.hpp"
#include "estimator/walk_attenuation.hpp"
#include "estimator/walk_cones.hpp"
#include "geometry/region.hpp"
#include "instrument/laser.hpp"
#include "instrument/lens.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
#include "scene/forward_settings.hpp"
#include "scene/scene.hpp"
#include "tally/gates.hpp"
#include "tally/shape.hpp"

namespace photic::estimator {

/// A telescope, with those whose views it holds, as the bidirectional estimator's walks begin
/// there: detecting the laser's line, or one band.
template <class T>
struct Receiver {
  std::size_t number = 0;      ///< among the receivers
  std::size_t group = 0;       ///< of telescopes, whose views are nested
  std::size_t telescope = 0;   ///< the widest of them
  geometry::Region<T> region;  ///< of its place
  Index<T> line{};             ///< 0, or the first of the band
  std::int32_t band = -1;      ///< of the medium's, if it is one
  T last_path{};               ///< of both walks together, at the end of the last gate [m]
  T longest{};                 ///< the same of walks that have not been translated yet [m]
  Deadline<T> deadline{};      ///< of its walks' light, to reach the laser
};

/// Telescopes that share local estimates: of nested views, or one alone.
template <class T>
struct ViewGroup {
  struct Narrower {
    Index<T> telescope{};
    T detector_radius{};  ///< [m]
  };
  std::size_t number = 0;  ///< of the widest, which sees all that any of them sees
  instrument::Telescope<T> widest;
  geometry::Region<T> region;
  double path_to_origin = 0;
  std::vector<Narrower> narrower;  ///< the others, from wide to narrow

  /// The narrowest telescope that sees light which the widest one sees.
  [[nodiscard]] Index<T> narrowest(const instrument::Sight<T>& sight) const {
    Index<T> telescope(static_cast<std::int32_t>(number));
    for (const Narrower& view : narrower) {
      const Mask<T> sees = sight.falls_within(view.detector_radius);
      if (!any(sees)) break;
      telescope = select(sees, view.telescope, telescope);
    }
    return telescope;
  }
};

/// The forward estimator's tools beyond the plain walk.
template <class T>
struct Tools {
  Index<T> forced_flights{};
  bool scores_on_the_way = false;  ///< collisions, at points chosen in views, not where they happen
  scene::AtThreshold at_threshold = scene::AtThreshold::roulette;
  std::vector<T> importance_depth, importance;
};

template <class T>
Tools<T> make_tools(const scene::Tools& s) {
  Tools<T> tools;
  tools.forced_flights = Index<T>(static_cast<std::int32_t>(s.forced_collisions));
  tools.scores_on_the_way = s.local_forced_collisions == scene::LocalForcedCollisions::all;
  tools.at_threshold = s.at_threshold;
  for (const auto& [depth_m, value] : s.importance) {
    tools.importance_depth.push_back(T(depth_m));
    tools.importance.push_back(T(value));
  }
  return tools;
}

/// The light that histories score.
enum class Scored : std::int8_t {
  all,
  film,       ///< a film's and the surface's own: walks score all else
  none,       ///< none: they lead to other histories
  from_water  ///< in the air, light that has been in the water
};

/// Light that passes the surface is followed in another world.
template <class T>
struct Beyond {
  bool exists = false;
  T chance{1};  ///< share of it that is
  T path{};     ///< the excess of its path there [m]
};

template <class T>
struct World {
  scene::Estimator estimator = scene::Estimator::forward;
  geometry::Slabs sea;
  instrument::Laser<T> laser;
  geometry::Region<T> laser_region;
  std::vector<instrument::Telescope<T>> telescopes;
  std::vector<geometry::Region<T>> telescope_region;
  std::vector<ViewGroup<T>> groups;         ///< of telescopes: each is in one
  std::vector<View<T>> views;               ///< of each group; none if nothing is converted
  std::vector<ViewCone<T>> cones;           ///< to choose points in that are scored
  std::vector<double> path_to_origin;       ///< of each telescope, see path_to_origin()
  std::vector<Deadline<T>> deadlines;       ///< one of which the laser's light has to meet
  T min_group_index{};                      ///< of all lines
  T directed{};                             ///< share of directions drawn towards a telescope
  bool directs = false;                     ///< true if any are
  bool has_environments = false;            ///< there are environments
  InverseConversion<T> inverse_conversion;  ///< of conversions, by walks from telescopes
  T conversion{};              ///< probability of a branch into the inelastic processes
  bool single_rays = false;    ///< local estimates take one point of the lens instead of its mean
  bool makes_choices = false;  ///< true if collisions choose between lines or targets at all
  std::vector<Receiver<T>> receivers;  ///< of the bidirectional estimator
  EntryCone<T> laser_cone;             ///< its walks begin in such directions
  std::vector<EntryCone<T>> telescope_cones;
  AveragedPhases averaged;                    ///< over these
  MeetingGrid<T> free_telescope, free_laser;  ///< depths at which rays of free walks meet
  T deepest{};  ///< the greatest depth where light may turn back within the last gate [m]
  MeetingGrid<T> meeting_grid;     ///< of the bidirectional estimator
  bool rotates = false;            ///< a telescope's walk may be rotated about where it converts
  bool rotates_scattered = false;  ///< one of the laser's line also about its first vertex
  T connected{1};         ///< share of the telescope's walks that are connected with a laser's walk
  std::size_t walks = 0;  ///< of the laser in a set
  std::int32_t max_vertices = 0;  ///< of a walk that is to be connected
  T weight_threshold{};
  std::int32_t scored_points = 1;  ///< of each flight; 1: where photons collide only
  Tools<T> tools;
  bool all_events = false;  ///< see AllEvents
  /// Past the surface in one flight: where each part of it is scored alike, and where photons that
  /// are sent there come there so often that it is worth the while.
  bool flies_on = false;
  Scored scored = Scored::all;
  Beyond<T> beyond;
  std::int32_t last_order = 0;  ///< scores go on to this order; 0: no limit
  RandomKey key{0};
  std::uint64_t batch_photons = 0;
  SobolPoints points;  ///< of a batch; none: all numbers are drawn independently

  /// The region of an instrument: of_laser, or a telescope behind it.
  [[nodiscard]] const geometry::Region<T>& region(std::int32_t instrument) const {
    return instrument == of_laser ? laser_region
                                  : telescope_region[static_cast<std::size_t>(instrument - 1)];
  }
  [[nodiscard]] const EntryCone<T>& cone(std::int32_t instrument) const {
    return instrument == of_laser ? laser_cone
                                  : telescope_cones[static_cast<std::size_t>(instrument - 1)];
  }
};

/// The events that a photon of the forward estimator may meet, known before the loops: most worlds
/// have neither the paper's tools nor variations (environments and derivatives), and loops without
/// them are faster.
struct PlainEvents {
  static constexpr bool tools = false, variations = false;
};
struct AllEvents {
  static constexpr bool tools = true, variations = true;
};

/// Returns whether there are environments.
template <class Events, class T>
bool has_environments(const World<T>& world) {
  if constexpr (Events::variations) {
    return world.has_environments;
  } else {
    return false;
  }
}

/// A walk that is to be connected is cut after so many vertices; what it carries then is counted as
/// lost.
inline constexpr std::int32_t max_vertices = 128;

/// Such walks play Russian roulette below this weight: where light is converted, a walk's gain by
/// its connections has little to do with its weight (docs/decisions/0027).
inline constexpr double min_weight = 1e-8;

/// The coordinates of a batch's points: four for each block of random numbers, of which an event of
/// a photon has three, of the laser's walk one and of a telescope's two.
inline constexpr std::uint32_t quasi_random_events = 3;
inline constexpr std::uint32_t quasi_random_blocks = 3;
inline constexpr std::uint32_t quasi_random_dimensions =
    4 * quasi_random_blocks * quasi_random_events;

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
                   !world.sea.waves.rough && !world.sea.film.exists;
  world.single_rays = scene.simulation.reception == scene::Reception::ray;
  world.conversion = T(scene.simulation.conversion_probability);
  const Vec3<double> beam = beam_in_water(scene, medium);
  world.inverse_conversion = {
      T(inverse_conversion_probability(scene.simulation.conversion_probability)),
      T(directed_inverse_conversion), vec3_cast<T>(beam), Index<T>(medium.beam_lobe),
      T(converts ? directed_scattering : 0.0)};
  const Strategies strategies = make_strategies(scene, medium);
  world.rotates = strategies.rotated.used;
  world.rotates_scattered = strategies.rotated_scattered.used;
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

}  // namespace photic::estimator
