// Meetings of a ray of the laser's walk with one of a telescope's walk, which is shifted sideways
// for it (vertex.hpp tells why).
#pragma once

#include <cmath>

#include "instrument/lens.hpp"
#include "transport/depart.hpp"
#include "transport/vertex.hpp"

namespace photic::transport {

/// The depths between which two rays can meet so that the telescope's walk comes through the lens.
template <class T>
struct Chord {
  Mask<T> exists;
  T from, to;                      ///< depth [m]
  instrument::PlanePoint<T> lens;  ///< where it comes through for a meeting at the surface's level
  instrument::PlanePoint<T> per_depth;  ///< and how that moves per metre of depth
};

/// `lens`: where the walk came through the lens; `deepest`: of the water [m].
template <class T>
Chord<T> chord(const Ray<T>& laser, const Ray<T>& back, const instrument::Telescope<T>& telescope,
               const instrument::PlanePoint<T>& lens, const T& deepest) {
  using std::sqrt;
  const T a = T(1) / laser.direction.z;
  const T b = T(1) / back.direction.z;
  const Vec3<T> slope = b * back.direction - a * laser.direction;  // per metre of depth
  const Vec3<T> at_surface = (laser.position - (laser.position.z * a) * laser.direction) -
                             (back.position - (back.position.z * b) * back.direction);
  Chord<T> c;
  c.lens = {lens.x + dot(at_surface, telescope.across), lens.y + dot(at_surface, telescope.up)};
  c.per_depth = {dot(slope, telescope.across), dot(slope, telescope.up)};
  const T squared = c.per_depth.x * c.per_depth.x + c.per_depth.y * c.per_depth.y;
  const Mask<T> moves = squared > T(1e-18);
  const T per_square = T(1) / select(moves, squared, T(1));
  const T middle = -(c.lens.x * c.per_depth.x + c.lens.y * c.per_depth.y) * per_square;
  const T x = c.lens.x * c.per_depth.y - c.lens.y * c.per_depth.x;
  const T radius = telescope.lens_radius;
  const T half = (radius * radius * squared - x * x) * per_square * per_square;
  const Mask<T> inside = c.lens.x * c.lens.x + c.lens.y * c.lens.y < radius * radius;
  const T reach = select(moves, sqrt(select(half > T(0), half, T(0))), deepest);
  c.from = select(moves, middle, T(0)) - reach;
  c.to = select(moves, middle, T(0)) + reach;

  const Mask<T> down = laser.direction.z < T(0);
  const T laser_depth = -laser.position.z;
  const T back_depth = -back.position.z;
  const T lower = select(laser_depth > back_depth, laser_depth, back_depth);
  const T upper = select(laser_depth < back_depth, laser_depth, back_depth);
  const T least = select(down, lower, T(0));
  const T most = select(down, deepest, upper);
  c.from = select(c.from > least, c.from, least);
  c.to = select(c.to < most, c.to, most);
  const Mask<T> same_way = laser.direction.z * back.direction.z > T(0);
  c.exists = same_way & select(moves, half > T(0), inside) & (c.to > c.from);
  return c;
}

/// What a meeting contributes, and where.
template <class T>
struct Meeting {
  T value{};
  T path{};  ///< [m]
};

/// A laser's ray and a telescope's that meet at a depth in a layer. `laser_behind`, `behind`: the
/// densities behind the rays; a spread is that of a ray from an instrument.
template <class T>
Meeting<T> meet(const medium::MediumView& sea, const Ray<T>& laser, const Spread<T>* laser_spread,
                const Densities<T>& laser_behind, const Ray<T>& back, const Spread<T>* spread,
                const Densities<T>& behind, const T& depth, const Index<T>& layer,
                const T& shift_area, const Reversal<T>& reversal, const Samples<T>& samples) {
  const Index<T> line = back.line;
  const Index<T> here = sea.at(line, layer);
  const Mask<T> converts = line > Index<T>(0);
  const T laser_depth = -laser.position.z;
  const T back_depth = -back.position.z;
  const T out = (laser_depth - depth) / laser.direction.z;
  const T home = (back_depth - depth) / back.direction.z;
  const T tau =
      sea.slant_optical_depth<T>(Index<T>(0), laser.layer, laser_depth, layer, depth, out) +
      sea.slant_optical_depth<T>(line, back.layer, back_depth, layer, depth, home);
  const T walked_out = exp_minus(
      sea.walk_slant_optical_depth<T>(Index<T>(0), laser.layer, laser_depth, layer, depth, out));
  const T walked_home =
      exp_minus(sea.walk_slant_optical_depth<T>(line, back.layer, back_depth, layer, depth, home));
  const T walk_c = gather<T>(sea.walk_c, here);
  const T coefficient = select(converts, gather<T>(sea.conversion, here) * gather<T>(sea.c, layer),
                               gather<T>(sea.albedo, here) * gather<T>(sea.c, here)) /
                        walk_c;
  const Index<T> phase = select(converts, gather_index<T>(sea.conversion_phase, line),
                                gather_index<T>(sea.elastic_phase, here));
  const T p = sea.phases.template value<T>(one_minus_cos(laser.direction, -back.direction), phase);

  // Strategies, each with n h / g times p and the walked exp(-tau) of both rays.
  const T steep = laser.direction.z * back.direction.z;
  const T here_met = samples.meeting(depth) * shift_area * back.chance * steep / walk_c;
  const T ratio = walk_c_ratio<T>(sea, line, layer);
  const T connected =
      back.chance * connecting_area(sea, laser, laser_spread, out, samples) * walked_home +
      ratio * connecting_area(sea, back, spread, home, samples) * walked_out;
  const T goes_on = back.chance * select(converts,
                                         reversal.chance(sea, line, layer) *
                                             reversal.over_phase(sea, -laser.direction, p),
                                         T(1));
  const T met_next =
      shift_area * (goes_on * turning(laser.meeting, laser.direction.z) * walked_home +
                    turning(back.meeting, back.direction.z) * walked_out);
  const T met_behind = walked_out * walked_home *
                       (goes_on * (laser_behind.edges + shift_area * laser_behind.meetings) +
                        behind.edges + shift_area * behind.meetings);
  Meeting<T> meeting;
  meeting.value = laser.weight * back.weight * coefficient * p * exp_minus(tau) /
                  (here_met + connected + p * (met_next + met_behind));
  meeting.path = laser.path + back.path + out * gather<T>(sea.group_index, Index<T>(0)) +
                 home * gather<T>(sea.group_index, line);
  return meeting;
}

}  // namespace photic::transport
