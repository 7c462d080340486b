// The fluence about a source: the path length of light in cells of depth and distance from the
// vertical through it, over their volume.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/tallies/continuous_absorption.hpp"
#include "estimator/tallies/flight.hpp"
#include "tally/tally_scores.hpp"

namespace photic::estimator {

/// A grid of cells on one side of the surface.
class Fluence {
 public:
  struct Edges {
    std::vector<double> distance;  ///< from the surface [m], ascending or descending
    std::vector<double> aside;     ///< radii of rings, or places along x [m], ascending
    bool rings = true;
  };
  /// `axis`: the source's place, relative to the world's origin [m]. Cells of the tally are by
  /// distance first.
  Fluence(Edges edges, const Vec3<double>& axis, ContinuousAbsorption absorption,
          std::size_t first_cell);

  void add(const Flight& flight, tally::TallyScores& scores) const;

 private:
  /// A part of a flight, between two of its lengths.
  struct Part {
    double begin = 0, end = 0;
  };
  /// The part within the grid's distances.
  [[nodiscard]] Part within(const Flight& flight) const;
  /// Follows a part through the cells, with columns that `aside` finds.
  template <class Aside>
  void add(const Flight& flight, const Part& part, Aside aside, tally::TallyScores& scores) const;
  [[nodiscard]] std::size_t cell(std::ptrdiff_t row, std::ptrdiff_t column) const;

  Edges edges_;                  ///< of distance ascending
  std::vector<double> columns_;  ///< edges of x, or squares of radii
  bool descends_ = false;        ///< the tally's own distances do not
  Vec3<double> axis_;
  ContinuousAbsorption absorption_;
  std::size_t first_cell_;
};

}  // namespace photic::estimator
