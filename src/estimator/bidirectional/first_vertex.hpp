// A walk's numbers at its first vertex: all that depend on its way there from its instrument. A
// free walk, which is put elsewhere, has them anew; the rest of the walk stays as it was drawn.
#pragma once

#include "estimator/bidirectional/path_point.hpp"
#include "estimator/bidirectional/vertex.hpp"
#include "estimator/world.hpp"
#include "surface/lambert.hpp"

namespace photic::estimator {

/// Densities over reverse_chance:
template <class T>
struct NearFirst {
  T instrument_edge{};  ///< of connecting the edge from the instrument
  T next_edge{};        ///< of connecting the next one
  T translated{};       ///< of meeting at the first vertex, over Freedom::translations [m]

  template <class F>
  constexpr void each_member(F f) {
    f(instrument_edge), f(next_edge), f(translated);
  }
};

/// By how much a free walk may be moved.
template <class T>
struct FreeArea {
  T footprint{};  ///< level area that the rays of the instrument's cone fill there [m^2]
  T averaged{1};  ///< density of the direction in which it is left, averaged over the cone, over
                  ///< that with which it was drawn
  T freed{1};     ///< of Spread

  /// The part of the footprint that free walks can use.
  [[nodiscard]] T level() const { return footprint * freed; }
  /// The area over which they may be moved: F of theory.md [m^2].
  [[nodiscard]] T area() const { return level() * averaged; }

  template <class F>
  constexpr void each_member(F f) {
    f(footprint), f(averaged), f(freed);
  }
};

template <class T>
struct FirstVertex {
  NearFirst<T> near;
  FreeArea<T> free;
  RotatedMeeting<T> rotated{};  ///< of a laser's walk: density of meeting here by rotation

  /// The walk comes to its first vertex or, else, its second. Others are left as they are.
  void arrive(const Vertex<T>& v, const Arrival<T>& by, const Spread<T>& spread,
              const Samples<T>& samples) {
    using std::abs;
    const T here = v.arriving_edge * by.reach / (samples.to_instrument * abs(v.direction.z));
    free.footprint = select(by.first, here, free.footprint);
    free.freed = select(by.first, spread.freed, free.freed);
    const auto& of_first = v.added_rotated;
    near.translated = select(by.first, T(0), v.added.translated);
    rotated.density = select(by.first, T(0), of_first.density);
    rotated.jacobian = of_first.jacobian;
  }
  /// It leaves its first vertex or, else, its second by a ray.
  void depart(const Ray<T>& ray, const T& averaged_over_drawn, const Mask<T>& from_first) {
    free.averaged = select(from_first, averaged_over_drawn, free.averaged);
    near.instrument_edge = select(from_first, ray.last_edge, near.instrument_edge);
    near.next_edge = select(from_first, T(0), ray.last_edge);
  }
};

/// The densities of a first vertex that are complete, and can be used in a path.
template <class T>
struct Complete {
  Mask<T> instrument_edge, next_edge, meeting;

  Complete(const Mask<T>& has_instrument_edge, const Mask<T>& has_next_edge,
           const Mask<T>& has_meeting, bool of_telescope, const Usable<T>& usable) {
    const Index<T> end(of_telescope ? usable.order : Index<T>(0));
    const Index<T> inwards(of_telescope ? -1 : 1);
    instrument_edge = has_instrument_edge & usable.connecting(end);
    next_edge = has_next_edge & usable.connecting(end + inwards);
    meeting = has_meeting & usable.meeting(of_telescope ? end : inwards);
  }
  /// Sum of the first vertex' densities. `translations`: for meetings there [m].
  [[nodiscard]] T sum(const NearFirst<T>& first, const T& translations) const {
    return select(instrument_edge, first.instrument_edge, T(0)) +
           select(next_edge, first.next_edge, T(0)) +
           select(meeting, translations * first.translated, T(0));
  }
};

/// FreeArea::averaged of an instrument's walk that leaves its first vertex, at a place, in a
/// direction: if it scatters light of a line; else it does so whichever way it came. `arriving_z`:
/// of the direction in which it has come there, up or down; light reflected by the surface on the
/// way has come about the image of the cone's axis. `p`: phase function's value. 0 for the laser's
/// on a bed whose albedo depends on the angle of light, and with it the walk's weight.
template <class T>
T averaged_over_drawn(const World<T>& world, std::int32_t instrument, const Index<T>& line,
                      const Index<T>& place, const Mask<T>& scatters, const T& arriving_z,
                      const Vec3<T>& direction, const T& p) {
  const auto& sea = world.slabs;
  const T& free_share = world.walks.cone(instrument).free_share;
  Mask<T> in_water = scatters;
  T else_drawn = free_share;
  if (sea.bed_angles > 0) {
    const Mask<T> bed = surface::on_bed<T>(sea, place);
    in_water = in_water & !bed;
    if (instrument == of_laser && sea.bed_angles > 1) else_drawn = select(bed, T(0), free_share);
  }
  if (!any(in_water)) return else_drawn;
  Vec3<T> axis = world.walks.cone(instrument).axis;
  axis.z = select(arriving_z * axis.z < T(0), -axis.z, axis.z);
  const T mean =
      world.walks.averaged.value(instrument, one_minus_cos(axis, direction),
                                 gather_index<T>(sea.elastic_phase, sea.at(line, place)));
  T ratio = free_share * mean / p;
  if (instrument != of_laser && any(world.walks.inverse_conversion.scattered > T(0))) {
    const auto drawn = [&](const T& value) {
      return world.walks.inverse_conversion.scattered_over_phase(sea, place, direction, value);
    };
    ratio = ratio * select(line == Index<T>(0), drawn(mean) / drawn(p), T(1));
  }
  return select(in_water, ratio, else_drawn);
}

}  // namespace photic::estimator
