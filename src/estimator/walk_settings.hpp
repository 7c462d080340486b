// The settings of the bidirectional estimator's walks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "estimator/averaged_phases.hpp"
#include "estimator/entry_cone.hpp"
#include "estimator/instrument_number.hpp"
#include "estimator/inverse_conversion.hpp"
#include "estimator/meeting_grid.hpp"
#include "estimator/origin.hpp"
#include "geometry/region.hpp"

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

/// The rows of Strategies (strategies.hpp) that walks ask. The use of free walks follows from the
/// cones and the grids.
struct UsedStrategies {
  bool to_laser = true, between = true, translated = true;
  bool rotated = false, rotated_scattered = false;
};

/// A walk that is to be connected is cut after so many vertices; what it carries then is counted as
/// lost.
inline constexpr std::int32_t max_vertices = 128;

/// Walks that are to be connected play Russian roulette below this weight: where light is
/// converted, the contribution of their connections hardly depends on it (docs/decisions/0027).
inline constexpr double min_weight = 1e-8;

/// The choices of walks from the laser and from telescopes.
template <class T>
struct WalkSettings {
  std::vector<Receiver<T>> receivers;
  EntryCone<T> laser_cone;  ///< its walks begin in such directions
  std::vector<EntryCone<T>> telescope_cones;
  AveragedPhases averaged;                    ///< over these
  MeetingGrid<T> free_telescope, free_laser;  ///< depths at which rays of free walks meet
  T deepest{};  ///< the greatest depth where light may turn back within the last gate [m]
  MeetingGrid<T> meeting_grid;
  InverseConversion<T> inverse_conversion;  ///< of conversions, by walks from telescopes
  UsedStrategies uses;
  T connected{1};  ///< share of the telescope's walks that are connected with a laser's walk
  std::size_t laser_walks = 0;                          ///< in a set
  std::int32_t max_vertices = estimator::max_vertices;  ///< of a walk that is to be connected

  /// The cone of an instrument: of_laser, or a telescope behind it.
  [[nodiscard]] const EntryCone<T>& cone(std::int32_t instrument) const {
    return instrument == of_laser ? laser_cone
                                  : telescope_cones[static_cast<std::size_t>(instrument - 1)];
  }
};

}  // namespace photic::estimator
