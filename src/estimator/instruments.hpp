// The laser and the telescopes of a world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "estimator/instrument_number.hpp"
#include "estimator/origin.hpp"
#include "geometry/region.hpp"
#include "instrument/laser.hpp"
#include "instrument/lens.hpp"
#include "instrument/telescope.hpp"

namespace photic::estimator {

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

/// The instruments of a world, their places in its medium, and the times of their light.
template <class T>
struct Instruments {
  instrument::Laser<T> laser;
  geometry::Region<T> laser_region;
  std::vector<instrument::Telescope<T>> telescopes;
  std::vector<geometry::Region<T>> telescope_region;
  std::vector<double> path_to_origin;  ///< of each telescope, see path_to_origin()
  std::vector<ViewGroup<T>> groups;    ///< of telescopes: each is in one
  std::vector<Deadline<T>> deadlines;  ///< one of which the laser's light has to meet
  bool all_times = false;              ///< it need not: tallies beside echoes count all light
  T min_group_index{};                 ///< of all lines

  /// The region of an instrument: of_laser, or a telescope behind it.
  [[nodiscard]] const geometry::Region<T>& region(std::int32_t instrument) const {
    return instrument == of_laser ? laser_region
                                  : telescope_region[static_cast<std::size_t>(instrument - 1)];
  }
};

}  // namespace photic::estimator
