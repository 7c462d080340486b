// The vertices and rays of walks that are to be connected (docs/theory.md, "The bidirectional
// estimator").
//
// A path x_1 … x_k has edges 0 (laser to x_1), 1 … k-1 and k (x_k to the telescope). Two families
// of strategies draw it. Strategy j draws everything but edge j by walks, x_1 … x_j from the laser
// and x_k … x_{j+1} from the telescope, and connects what is left open. And since the sea is the
// same all over a horizontal plane, a telescope's walk may be shifted sideways as long as it still
// comes through the lens: strategy "meeting at x_i" draws everything but x_i, a ray of the laser's
// walk and one of the telescope's towards it included, and translations the second so that they
// meet at a chosen depth. It draws the peaks of phase functions on both sides of the point where
// light turns back. "Turning about x_q at x_i", i < q, does the same for light that is converted at
// x_q: it leaves there with densities that depend on the angle to the vertical alone, so that the
// telescope's walk beyond x_q may be turned about the vertical through it, until the two rays meet.
//
// The density of a strategy is in proportion to n h / g: n samples of it exist in a set of walks; h
// is the chance that walks choose as the path does, between scattering and conversion, and
// directions that are drawn about the beam; and
//   1 / g = d^2 exp(tau) / (P_j P_{j+1})                 connecting edge j of length d,
//   1 / g = A |cos cos'| exp(tau + tau') / (c' P_i)      meeting at x_i, per metre of depth,
//   1 / g = 2 pi S exp(tau + tau') / (c' P_i)            turning so that they meet at x_i,
// with tau by the coefficient c' that free paths are drawn from, cos, cos', tau, tau' of the edges
// on both sides, A the telescope's translation_area and S the RotationJacobian of both directions.
// Vertices carry the sums of n h / g over what lies behind them, so that a connection knows the
// densities of all strategies at once.
#pragma once

#include "core/elementary.hpp"
#include "core/lanes.hpp"

namespace photic::estimator {

/// Sums of n h / g.
template <class T>
struct Densities {
  T edges{};       ///< of connecting edges
  T translated{};  ///< of meetings, over `translations` [1/m]
  T rotated{};     ///< of turning, about the walk's own vertical

  /// `translations`: of a path, as Freedom has it [m].
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

/// One end of a connection: the phase function there, and the densities behind it.
template <class T>
struct EndDensities {
  T p{1};
  T arriving_edge{};  ///< n h / g of connecting the last edge, times p
  T behind{};         ///< sum of n h / g of what is complete
};

/// Weight of a connection by the balance heuristic over all strategies that can be used for its
/// path (Veach & Guibas, SIGGRAPH 95): 1 / sum of n h / g, times the exp(-tau) of the edge over its
/// walked part. `area` = n h / g of what is made at this edge, times both phase functions and the
/// walked exp(-tau).
template <class T>
T balance(const T& area, const T& tau, const T& walk_tau, const EndDensities<T>& a,
          const EndDensities<T>& b) {
  const T both = a.p * b.p;
  return both * exp_minus(tau) /
         (area + exp_minus(walk_tau) * (a.arriving_edge * b.p + b.arriving_edge * a.p +
                                        (a.behind + b.behind) * both));
}

}  // namespace photic::estimator
