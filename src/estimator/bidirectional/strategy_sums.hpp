// With which densities the strategies draw a path, summed along walks for multiple importance
// sampling (Veach & Guibas, SIGGRAPH 95; docs/bidirectional.md maps the names to the equations).
//
// A path has vertices x_1 … x_k, counted from the laser, and edges 0 (laser to x_1), 1 … k-1 and k
// (x_k to the telescope). Three families of strategies draw it.
//
// Connected (eq. 39): walks draw all but edge j, that is x_1 … x_j from the laser and x_k … x_{j+1}
// from the telescope. The edge is set between them.
//
// Translated (eq. 40): walks draw all but the vertex x_i, including a ray towards it from each
// side. The sea is the same all over a horizontal plane. So the telescope's walk may be translated
// sideways, as long as it still comes through the lens, until both rays meet at a chosen depth.
// Phase functions' peaks on both sides of x_i are drawn, and x_i is where light reverses between up
// and down, or is converted.
//
// Rotated (eq. 41): light that is converted at x_q leaves there with densities that depend on the
// angle to the vertical alone. So the telescope's walk beyond x_q may be rotated about the vertical
// through x_q until both rays meet at x_i, i < q.
//
// A strategy's density here is n p of multiple importance sampling, but for a factor that all
// strategies of a path share: n h / g (eq. 42). n is how many samples of it a set of walks makes. h
// is the chance that walks choose as the path does, between scattering and conversion, and of
// directions that are drawn about the beam. 1 / g is what the strategy does not draw:
//   connected:   1 / g = d^2 exp(tau) / (P_j P_{j+1})               edge j has the length d
//   translated:  1 / g = A |cos cos'| exp(tau + tau') / (c' P_i)    per metre of depth
//   rotated:     1 / g = 2 pi S exp(tau + tau') / (c' P_i)
//   on the bed:  1 / g = A l pi exp(tau + tau')    translated, l = MeetingGrid::below_bed()
// P_i is the density of the direction in which x_i is left, the phase function; on the bed |cos| /
// pi of the connected edge itself. c' is the coefficient that free paths are drawn from, tau the
// optical depth of an edge by c'. cos, cos', tau, tau' are those of both edges at x_i. A is the
// translation_area of the telescope, S the RotationJacobian of both directions.
//
// Vertices carry the sums of these densities over all that lies behind them on their walk. So a
// connection knows the densities of all strategies at once, however long its walks are.
#pragma once

#include <cstdint>

#include "core/elementary.hpp"
#include "core/lanes.hpp"

namespace photic::estimator {

/// The strategies that can be used for a path of `order` vertices by walks of at most `most`.
template <class T>
struct Usable {
  Index<T> order, most;
  Usable(const Index<T>& vertices, std::int32_t max_of_a_walk)
      : order(vertices), most(max_of_a_walk) {}
  [[nodiscard]] Mask<T> all() const { return order <= most; }
  [[nodiscard]] Mask<T> connecting(const Index<T>& edge) const {
    return (edge <= most) & (order - edge <= most);
  }
  /// A walk that has all the vertices it may have does not set out from the last one.
  [[nodiscard]] Mask<T> meeting(const Index<T>& vertex) const {
    return (vertex <= most) & (order - vertex < most);
  }
};

/// The freedom of whole walks to be moved sideways so that rays meet at a vertex of a path: the
/// number of such meetings per metre of depth, times an area [m]. At the first vertex the laser's
/// walk cannot, at the last the telescope's: there they are connected to their instruments anew.
template <class T>
struct PathFreedom {
  T inner{}, at_first{}, at_last{};

  [[nodiscard]] T at(const Mask<T>& is_first, const Mask<T>& is_last) const {
    return select(is_last, at_last, select(is_first, at_first, inner));
  }
};

/// Sums of the densities of strategies, of those behind a walk's first vertex (first_vertex.hpp).
template <class T>
struct Densities {
  T edges{};       ///< of connecting edges
  T translated{};  ///< of meetings by translation, over PathFreedom [m]
  T rotated{};     ///< of meetings by rotation about the walk's own axis

  /// `translations`: PathFreedom::inner of the path [m].
  T all(const T& translations) const { return edges + translations * translated + rotated; }

  template <class F>
  constexpr void each_member(F& f) {
    f(edges), f(translated), f(rotated);
  }
  friend Densities select(const Mask<T>& mask, const Densities& yes, const Densities& no) {
    return {select(mask, yes.edges, no.edges), select(mask, yes.translated, no.translated),
            select(mask, yes.rotated, no.rotated)};
  }
};

/// The input of balance() from one end of a connection.
template <class T>
struct EndDensities {
  T p{1};             ///< of the edge's direction there, as walks draw it [1/sr]
  T arriving_edge{};  ///< density of connecting the last edge before this end, times p
  T behind{};         ///< sum of the densities of all strategies behind it
};

/// A connection's score by the balance heuristic, over the weights of its ends: the edge's
/// exp(-tau) and the `contribution` of its ends over the sum of the densities of all strategies
/// that can be used for its path (eq. 42). `reach`: chance that a walk would come along the edge.
/// `area`: density of connecting this edge, and of meeting at its ends, times both p and `reach`.
template <class T>
T balance(const T& contribution, const T& area, const T& tau, const T& reach,
          const EndDensities<T>& a, const EndDensities<T>& b) {
  const T both = a.p * b.p;
  return contribution * exp_minus(tau) /
         (area +
          reach * (a.arriving_edge * b.p + b.arriving_edge * a.p + (a.behind + b.behind) * both));
}

/// The input of balance() from the vertex where two rays meet.
template <class T>
struct MeetingDensities {
  T p{1};      ///< of the direction in which light leaves, as walks draw it [1/sr]
  T here{};    ///< density of meeting here, and of connecting either ray's edge, times p
  T next{};    ///< of meeting where either ray begins
  T behind{};  ///< sum of the densities of all strategies behind the rays
};

/// The score of rays that meet: the `contribution` of the whole path, weights of both walks
/// included, and the exp(-tau) of both rays over the same sum.
template <class T>
T balance(const T& contribution, const T& tau, const MeetingDensities<T>& at) {
  return contribution * exp_minus(tau) / (at.here + at.p * (at.next + at.behind));
}

}  // namespace photic::estimator
