// At which depths rays of two walks are made to meet, and how many samples of each strategy exist.
#pragma once

#include "core/lanes.hpp"

namespace photic::estimator {

/// The depths at which rays are made to meet: a grid of equal steps.
template <class T>
struct MeetingGrid {
  T most{};  ///< points per metre; 0: no rays meet

  /// Points per metre for paths of so many vertices. Paths of few vertices, near the axis of the
  /// instrument, meet over many metres of depth, others over centimetres (decision 35).
  T density(const Index<T>& order) const {
    return most *
           select(order < Index<T>(2), T(1.0 / 8), select(order < Index<T>(3), T(1.0 / 4), T(1)));
  }
  /// The number of points between the surface's level and a depth; and the inverse.
  T number(const T& depth, const Index<T>& order) const { return density(order) * depth; }
  T depth(const T& number, const Index<T>& order) const { return number / density(order); }
  /// On a sea bed, where there is no depth to choose, rays meet if a point of the grid lies less
  /// than so far below it: always in paths of three and more vertices [m].
  T below_bed() const { return T(1) / most; }
  /// `offset`: of the grid's points.
  Mask<T> meets_on_bed(const T& depth, const Index<T>& order, const T& offset) const {
    const T next = number(depth, order) - offset;
    const T to_next = to_real<T>(floor_index(next + T(1))) - next;
    return to_next < density(order) * below_bed();
  }
};

/// The number of a strategy's samples in a set of walks, per photon that the laser emits.
template <class T>
struct Samples {
  T to_instrument{1};  ///< connecting a walk to the instrument at the other end
  T between{1};        ///< connecting two walks
  T pairs{1};          ///< of walks whose rays meet at each depth of the grid
  T rotated{};         ///< of walks rotated so that their rays meet
  MeetingGrid<T> grid;
  MeetingGrid<T> free_telescope{}, free_laser{};  ///< the same of free walks

  /// The number of meetings by translation, per metre of depth, in paths of so many vertices.
  T translated(const Index<T>& order) const { return pairs * grid.density(order); }
  /// The same of free walks, of a telescope or of the laser; none in paths of one vertex.
  T freed(const MeetingGrid<T>& of, const Index<T>& order) const {
    return select(order > Index<T>(1), pairs * of.density(order), T(0));
  }
  /// Returns whether there are free walks at all.
  bool frees() const { return any(free_telescope.most > T(0)) || any(free_laser.most > T(0)); }
};

}  // namespace photic::estimator
