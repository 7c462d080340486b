// How a vertex of a walk takes part in a connection: its weight and densities if light leaves it,
// or comes to it, along a new edge (docs/theory.md, "The bidirectional estimator").
//
// An edge of the laser's light ends at a vertex of the telescope's walk that scatters it or
// converts it; an edge of converted light begins at a vertex of the laser's walk.
#pragma once

#include "transport/depart.hpp"
#include "transport/vertex.hpp"

namespace photic::transport {

template <class T>
struct Joint {
  End<T> end;
  T weight{};        ///< of the walk with this collision
  T share{1};        ///< h of a connection
  T shift_share{1};  ///< h of a shift to the laser's vertex of the edge
};

template <class T>
T phase_value(const medium::MediumView& sea, const Vertex<T>& v, const Vec3<T>& direction,
              const Index<T>& phase) {
  return sea.phases.template value<T>(one_minus_cos(v.direction, direction), phase);
}

/// The laser's walk, scattered into a direction of the laser's light. `share`: shift_share of the
/// other end; `shift_area`: of the telescope's walk.
template <class T>
Joint<T> scattering_from_laser(const medium::MediumView& sea, const Vertex<T>& v,
                               const Vec3<T>& direction, const T& share, const T& shift_area) {
  const Index<T> here = sea.at(v.line, v.layer);
  Joint<T> joint;
  joint.end.p = phase_value(sea, v, direction, gather_index<T>(sea.elastic_phase, here));
  joint.end.open = share * v.open;
  joint.end.closed = share * (v.closed + shift_area * v.shifts);
  joint.weight = v.weight * gather<T>(sea.albedo, here);
  return joint;
}

/// The laser's walk, converted to a line and sent into a direction. The other end's walk scatters
/// this light: `chance` is that of a walk up to it, `chance_beyond` with its not being converted
/// there; both 1 where the other end is a telescope.
template <class T>
Joint<T> conversion_from_laser(const medium::MediumView& sea, const Vertex<T>& v,
                               const Vec3<T>& direction, const Index<T>& line, const T& probability,
                               const T& chance, const T& chance_beyond, const T& shift_area) {
  const T ratio = walk_c_ratio<T>(sea, line, v.layer);
  const T converted = conversion_chance<T>(sea, line, v.layer, probability);
  Joint<T> joint;
  joint.end.p = phase_value(sea, v, direction, gather_index<T>(sea.conversion_phase, line));
  joint.end.open = chance_beyond * v.open;
  joint.end.closed = chance_beyond * converted * (v.closed + shift_area * v.shifts);
  joint.weight = v.weight * ratio * gather<T>(sea.conversion, sea.at(line, v.layer));
  joint.share = chance * ratio;
  joint.shift_share = chance_beyond * ratio;
  return joint;
}

/// The telescope's walk with the laser's light that comes to it: scattered if the walk has turned
/// its conversion back, else converted here. `direction`: in which the walk would go on.
template <class T>
Joint<T> arrival_from_laser(const medium::MediumView& sea, const Vertex<T>& v,
                            const Vec3<T>& direction, const T& probability) {
  const Index<T> here = sea.at(v.line, v.layer);
  const Mask<T> converts = v.line > Index<T>(0);
  const T ratio = walk_c_ratio<T>(sea, v.line, v.layer);  // 1 for the laser's line
  Joint<T> joint;
  joint.end.p = phase_value(sea, v, direction,
                            select(converts, gather_index<T>(sea.conversion_phase, v.line),
                                   gather_index<T>(sea.elastic_phase, here)));
  joint.end.open = ratio * v.open;
  joint.end.closed = v.closed;  // 0 before a conversion
  joint.weight = v.weight * select(converts, conversion_per_emitted_c<T>(sea, v.line, v.layer),
                                   gather<T>(sea.albedo, here));
  joint.share = v.chance;
  joint.shift_share =
      v.chance * select(converts, conversion_chance<T>(sea, v.line, v.layer, probability), T(1));
  return joint;
}

/// The telescope's walk with converted light that it scatters here: no edge behind can be drawn.
template <class T>
Joint<T> scattering_of_converted(const medium::MediumView& sea, const Vertex<T>& v,
                                 const Vec3<T>& direction) {
  const Index<T> here = sea.at(v.line, v.layer);
  Joint<T> joint;
  joint.end.p = phase_value(sea, v, direction, gather_index<T>(sea.elastic_phase, here));
  joint.weight = v.weight * gather<T>(sea.albedo, here);
  return joint;
}

}  // namespace photic::transport
