// Irradiances at levels: plane ones by crossings, scalar ones as the mean over a slab about the
// level, of the light's path through it over the slab's thickness. By crossings, as w / |cos|, the
// variance of scalar irradiance would not be finite.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "estimator/tallies/continuous_absorption.hpp"
#include "estimator/tallies/flight.hpp"
#include "tally/tally_grid.hpp"
#include "tally/tally_scores.hpp"

namespace photic::estimator {

/// The levels of one side of the surface.
class Irradiance {
 public:
  struct Level {
    std::size_t index = 0;  ///< among all levels of the tally
    double distance = 0;    ///< from the surface [m]
    double slab_m = 0;      ///< thickness, before it is cut at layers' edges
  };
  /// The first cells of its grids.
  struct Cells {
    std::size_t plane = 0, scalar = 0;
  };
  /// `end`: of the medium, from the surface [m].
  Irradiance(const std::vector<Level>& levels, ContinuousAbsorption absorption, double end,
             const Cells& away, const Cells& towards);

  void add(const Flight& flight, tally::TallyScores& scores) const;

 private:
  struct Slab {
    Level level;
    double begin = 0, end = 0;
    std::size_t layer = 0;
  };
  void add_track(const Flight& flight, const Slab& slab, std::size_t cell,
                 tally::TallyScores& scores) const;

  ContinuousAbsorption absorption_;
  Cells away_, towards_;
  std::vector<Slab> slabs_;  ///< from the nearest on
};

}  // namespace photic::estimator
