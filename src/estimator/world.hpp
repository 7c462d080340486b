// Everything a history needs, immutable and shared by all threads.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/random.hpp"
#include "core/sobol.hpp"
#include "estimator/averaged_phases.hpp"
#include "estimator/companion.hpp"
#include "estimator/entry_cone.hpp"
#include "estimator/inverse_conversion.hpp"
#include "estimator/meeting_grid.hpp"
#include "estimator/origin.hpp"
#include "estimator/plan.hpp"
#include "estimator/reach.hpp"
#include "estimator/view.hpp"
#include "geometry/region.hpp"
#include "instrument/laser.hpp"
#include "instrument/lens.hpp"
#include "instrument/telescope.hpp"
#include "medium/medium.hpp"
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

/// The rows of Strategies (strategies.hpp) that histories ask. The use of free walks follows from
/// the cones and the grids.
struct UsedStrategies {
  bool to_laser = true, between = true, translated = true;
  bool rotated = false, rotated_scattered = false;
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
  MeetingGrid<T> meeting_grid;  ///< of the bidirectional estimator
  UsedStrategies uses;          ///< of the bidirectional estimator
  T connected{1};         ///< share of the telescope's walks that are connected with a laser's walk
  std::size_t walks = 0;  ///< of the laser in a set
  std::int32_t max_vertices = 0;  ///< of a walk that is to be connected
  T weight_threshold{};
  std::int32_t scored_points = 1;  ///< of each flight; 1: where photons collide only
  Tools<T> tools;
  bool all_events = false;            ///< see AllEvents
  Companion<T>* companion = nullptr;  ///< of all light; none: nullptr
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

/// Has a companion travel with all light of a world. It is shown every crossing: no flight goes
/// past the surface without meeting it.
template <class T>
void accompany(World<T>& world, Companion<T>& companion) {
  world.companion = &companion;
  world.all_events = true;
  world.flies_on = false;
}

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

/// Walks that are to be connected play Russian roulette below this weight: where light is
/// converted, the contribution of their connections hardly depends on it (docs/decisions/0027).
inline constexpr double min_weight = 1e-8;

/// The coordinates of a batch's points: four for each block of random numbers, of which an event of
/// a photon has three, of the laser's walk one and of a telescope's two.
inline constexpr std::uint32_t quasi_random_events = 3;
inline constexpr std::uint32_t quasi_random_blocks = 3;
inline constexpr std::uint32_t quasi_random_dimensions =
    4 * quasi_random_blocks * quasi_random_events;

}  // namespace photic::estimator
