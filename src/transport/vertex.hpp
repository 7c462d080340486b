// The vertices of walks that are to be connected (docs/theory.md, "The bidirectional estimator").
//
// A path x_1 … x_k has edges 0 (laser to x_1), 1 … k-1 and k (x_k to the telescope). Strategy j
// draws everything but edge j by walks, x_1 … x_j from the laser and x_k … x_{j+1} from the
// telescope, and connects what is left open; n_j samples of it exist in a set of walks. Its density
// is in proportion to h_j / g_j, where g_j is what edge j contributes to the path when it is walked
// and h_j the chance that the walks choose, at every vertex between scattering and conversion, as
// the path does. A vertex carries the sums of n h / g over the edges behind it, so that a
// connection knows the densities of all strategies at once.
#pragma once

#include "core/elementary.hpp"
#include "medium/medium.hpp"
#include "transport/crossing.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

//
// The sea is the same all over a horizontal plane. A telescope's walk can therefore be shifted
// sideways, as long as it still comes through the lens and falls on the detector, and so it can be
// made to meet a vertex x_i of the laser's walk: the strategies that draw everything but P_i, peaks
// of phase functions on both sides included. With the telescope's shift_area A, for these
//   1 / g_i = A |cos of edge i to the vertical| exp(tau of edge i) / P_i.
/// How many samples a set of walks makes of a strategy, per photon that the laser emits.
template <class T>
struct Samples {
  T to_instrument{1};  ///< that connects a walk to the instrument at the other end
  T between{1};        ///< that connects two walks
  T shifted{1};        ///< that shifts a telescope's walk to a vertex of the laser's
};

template <class T>
struct Vertex {
  Vec3<T> position;
  Vec3<T> direction;  ///< in which the walk arrives
  T weight{};  ///< of the walk before this collision: the path's contribution over the density
               ///< drawn from, without the chances h
  T path{};    ///< [m]
  Index<T> line{}, layer{};
  T chance{1};  ///< h of a connection made here
  T open{};     ///< n h / g of the last edge, times this vertex' phase function: of connecting it,
             ///< and of a telescope's walk also of shifting it by that edge; 0: neither is possible
  T before{};                   ///< n h / g of what was open at the vertex before
  T closed{};                   ///< sum of n h / g of all that is complete
  T before_shifts{}, shifts{};  ///< of the laser's walk the same of shifts by the edges behind, per
                                ///< area
};

/// A walk's way from its last vertex, or its instrument, to where it is.
template <class T>
struct Leg {
  T length{};          ///< in the water [m]
  T walk_tau{};        ///< optical depth of the coefficient that free paths are drawn from
  Mask<T> mirrored{};  ///< it was reflected by the surface
};

/// Adds a flight of a photon that stood at `before` to its leg.
template <class T>
void add_flight(const medium::MediumView& sea, const Photon<T>& before, const Photon<T>& photon,
                Leg<T>& leg) {
  const T moved = (photon.path - before.path) / gather<T>(sea.group_index, photon.line);
  leg.length = leg.length + moved;
  leg.walk_tau =
      leg.walk_tau + sea.walk_slant_optical_depth<T>(photon.line, before.layer, -before.position.z,
                                                     photon.layer, -photon.position.z, moved);
}

/// How a walk's light spreads from its instrument: from a point, in directions that are dense as
/// 1 / solid_angle.
template <class T>
struct Spread {
  bool through_surface = false;
  T before{};       ///< length from that point to where the leg in the water begins [m]
  T cos_air{1};     ///< of the ray in the air, to the vertical
  T solid_angle{};  ///< [sr]; 0: parallel rays, which no connection can meet
};

/// Solid angle at the instrument's point per area across the ray in the water [1/m^2].
template <class T>
T solid_angle_per_area(const medium::MediumView& sea, const Spread<T>& spread, const Index<T>& line,
                       const T& length, const T& cos_water) {
  if (!spread.through_surface) {
    const T whole = spread.before + length;
    return T(1) / (whole * whole);
  }
  const T n = gather<T>(sea.index, line);
  return n * n *
         refracted_solid_angle_per_area(gather<T>(sea.inverse_index, line), length, cos_water,
                                        spread.before, spread.cos_air);
}

/// The vertex at which a walk collides, without what lies behind it.
template <class T>
Vertex<T> vertex_at(const Photon<T>& photon) {
  Vertex<T> v;
  v.position = photon.position;
  v.direction = photon.direction;
  v.weight = photon.weight;
  v.path = photon.path;
  v.line = photon.line;
  v.layer = photon.layer;
  return v;
}

/// The first vertex of a walk; `shift_area` is that of a telescope's walk, 0 for the laser's.
template <class T>
Vertex<T> first_vertex(const medium::MediumView& sea, const Photon<T>& photon,
                       const Spread<T>& spread, const Leg<T>& leg, const T& shift_area,
                       const Samples<T>& samples) {
  using std::abs;
  const T steep = abs(photon.direction.z);
  Vertex<T> v = vertex_at(photon);
  const T shift = select(leg.mirrored, T(0), samples.shifted * shift_area * steep);
  v.open = (samples.to_instrument * spread.solid_angle /
                solid_angle_per_area(sea, spread, photon.line, leg.length, steep) +
            shift) /
           exp_minus(leg.walk_tau);
  return v;
}

/// How a walk left a vertex.
template <class T>
struct Departure {
  T p{1};        ///< phase function's value [1/sr]
  T chance{1};   ///< of the choice between scattering and conversion
  T density{1};  ///< c' of the line that a walk from the laser would have come with, over that of
                 ///< the walk's own; 0: the path's edges behind can be drawn by no connection
};

/// The vertex after `last`.
template <class T>
Vertex<T> next_vertex(const Photon<T>& photon, const Vertex<T>& last, const Departure<T>& departure,
                      const Leg<T>& leg, const T& shift_area, const Samples<T>& samples) {
  using std::abs;
  const T per_p = T(1) / departure.p;
  const T growth = select(leg.mirrored, T(0), T(1) / exp_minus(leg.walk_tau));
  const T shift = samples.shifted * growth * abs(photon.direction.z);
  Vertex<T> v = vertex_at(photon);
  v.chance = last.chance * departure.chance;
  v.before = departure.density * last.open * per_p;
  v.closed = last.closed + v.before;
  v.open = last.chance * samples.between * growth * leg.length * leg.length * per_p +
           v.chance * shift * shift_area;
  v.before_shifts = shift * per_p;
  v.shifts = last.shifts + v.before_shifts;
  return v;
}

/// One end of a connection: the phase function there, and the densities behind it.
template <class T>
struct End {
  T p{1};
  T open{};    ///< n h / g of the last edge times p
  T closed{};  ///< sum of n h / g of those before it
};

/// Weight of a connection by the balance heuristic over all strategies that can be used for its
/// path (Veach & Guibas, SIGGRAPH 95): 1 / sum of n h / g, times the exp(-tau) of the edge over its
/// walked part. `area` = n h / g of what is made at this edge, times both phase functions and the
/// walked exp(-tau).
template <class T>
T balance(const T& area, const T& tau, const T& walk_tau, const End<T>& a, const End<T>& b) {
  const T both = a.p * b.p;
  return both * exp_minus(tau) /
         (area +
          exp_minus(walk_tau) * (a.open * b.p + b.open * a.p + (a.closed + b.closed) * both));
}

}  // namespace photic::transport
