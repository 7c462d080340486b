// The effect of a walk's way from vertex to vertex on its weight in environments.
#pragma once

#include <cmath>

#include "estimator/bidirectional/path_point.hpp"
#include "estimator/variations/environments.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// A walk's way from where it left its last vertex, or entered the water, to the next one:
/// straight, or reflected by the surface.
template <class T>
void add_leg(const medium::MediumView& sea, const WalkPoint<T>& left, const WalkPoint<T>& arrived,
             estimator::Terms<T>& ways) {
  using std::abs;
  const T from = geometry::depth_of(left.position);
  const T to = geometry::depth_of(arrived.position);
  const Mask<T> reflected = left.direction.z * arrived.direction.z < T(0);
  const T steep = select(reflected, T(abs(left.direction.z)), T(1));
  const Index<T> top(0);
  // It has come through a film, or will be sent back by it.
  if (sea.environments.other_film) {
    const Mask<T> enters = (from == T(0)) & (left.direction.z < T(0));
    const Index<T> way = select(reflected, Index<T>(back_into_water),
                                select(enters, Index<T>(through_film), Index<T>(-1)));
    add_flat_film(sea, {left.line, way, T(abs(left.direction.z))}, ways);
  }
  const auto turn = sea.level(select(reflected, top, arrived.layer), select(reflected, T(0), to));
  add_segment(sea,
              {left.line, geometry::level_of(sea, left), turn,
               select(reflected, from / steep, T(length(arrived.position - left.position)))},
              ways);
  if (!any(reflected)) return;
  add_segment(sea,
              {left.line, turn, geometry::level_of(sea, arrived),
               select(reflected, to / T(abs(arrived.direction.z)), T(0))},
              ways);
}

}  // namespace photic::estimator
