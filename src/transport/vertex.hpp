// The vertices and rays of walks that are to be connected (docs/theory.md, "The bidirectional
// estimator").
//
// A path x_1 … x_k has edges 0 (laser to x_1), 1 … k-1 and k (x_k to the telescope). Two families
// of strategies draw it. Strategy j draws everything but edge j by walks, x_1 … x_j from the laser
// and x_k … x_{j+1} from the telescope, and connects what is left open. And since the sea is the
// same all over a horizontal plane, a telescope's walk may be shifted sideways as long as it still
// comes through the lens: strategy "meeting at x_i" draws everything but x_i, a ray of the laser's
// walk and one of the telescope's towards it included, and shifts the second so that they meet at a
// chosen depth. It draws the peaks of phase functions on both sides of the point where light turns
// back. "Turning about x_q at x_i", i < q, does the same for light that is converted at x_q: it
// leaves there with densities that depend on the angle to the vertical alone, so that the
// telescope's walk beyond x_q may be turned about the vertical through it, until the two rays meet.
//
// The density of a strategy is in proportion to n h / g: n samples of it exist in a set of walks; h
// is the chance that walks choose as the path does, between scattering and conversion, and
// directions that are drawn about the beam; and
//   1 / g = d^2 exp(tau) / (P_j P_{j+1})                 connecting edge j of length d,
//   1 / g = A |cos cos'| exp(tau + tau') / (c' P_i)      meeting at x_i, per metre of depth,
//   1 / g = 2 pi S exp(tau + tau') / (c' P_i)            turning so that they meet at x_i,
// with tau by the coefficient c' that free paths are drawn from, cos, cos', tau, tau' of the edges
// on both sides, A the telescope's shift_area and S the Sweep of both directions. Vertices carry
// the sums of n h / g over what lies behind them, so that a connection knows the densities of all
// strategies at once.
#pragma once

#include "core/constants.hpp"
#include "core/elementary.hpp"
#include "medium/medium.hpp"
#include "transport/crossing.hpp"
#include "transport/depths.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// The depths at which rays are made to meet: a grid of equal steps.
template <class T>
struct MeetingGrid {
  T most{};  ///< points per metre

  /// Points per metre for paths of so many vertices. Those of few vertices, near the axis of the
  /// instrument, meet over many metres of depth, others over centimetres (decision 35).
  T density(const Index<T>& order) const {
    return most *
           select(order < Index<T>(2), T(1.0 / 8), select(order < Index<T>(3), T(1.0 / 4), T(1)));
  }
  /// The number of points between the surface's level and a depth; and the inverse.
  T number(const T& depth, const Index<T>& order) const { return density(order) * depth; }
  T depth(const T& number, const Index<T>& order) const { return number / density(order); }
};

/// How many samples a set of walks makes of a strategy, per photon that the laser emits.
template <class T>
struct Samples {
  T to_instrument{1};  ///< connecting a walk to the instrument at the other end
  T between{1};        ///< connecting two walks
  T pairs{1};          ///< of walks whose rays meet at each depth of the grid
  T turned{};          ///< of walks turned so that their rays meet
  MeetingGrid<T> grid;

  /// Of meetings, per metre of depth, in paths of so many vertices.
  T meetings(const Index<T>& order) const { return pairs * grid.density(order); }
};

/// A vertical about which a walk may be turned: that through its pivot, where it converts, or of
/// light of the laser's line the vertex next to the telescope.
template <class T>
struct Vertical {
  Mask<T> exists{};
  T x{}, y{};  ///< [m]

  friend Vertical select(const Mask<T>& mask, const Vertical& yes, const Vertical& no) {
    return {select(mask, yes.exists, no.exists), select(mask, yes.x, no.x),
            select(mask, yes.y, no.y)};
  }
};

/// Whether a telescope's walk that comes to a vertex along `home`, scatters there and goes on along
/// `on` may be turned about the vertical through it: where it comes along the vertical and leaves
/// aside, the turn hardly changes the angle between. Both directions' own angles to the vertical
/// tell, which no turn changes.
template <class T>
Mask<T> leads_aside(const Vec3<T>& home, const Vec3<T>& on) {
  constexpr double as_far = 3;  // decision 33
  return on.x * on.x + on.y * on.y > T(as_far * as_far) * (home.x * home.x + home.y * home.y);
}

/// |e_z x (x - axis) . (w x w')|, S: the volume that two rays of directions w and w' sweep about
/// where they meet, per solid angle of both and turn about the axis. A walk turned about the axis
/// keeps it.
template <class T>
struct Sweep {
  T x{}, y{};          ///< where they meet [m]
  T along{}, aside{};  ///< w x w', its horizontal part

  T about(const Vertical<T>& axis) const {
    using std::abs;
    return select(axis.exists, T(abs((x - axis.x) * aside - (y - axis.y) * along)), T(0));
  }
};
template <class T>
Sweep<T> sweep(const Vec3<T>& place, const Vec3<T>& a, const Vec3<T>& b) {
  return {place.x, place.y, a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z};
}

/// n h / g of turning a walk so that rays meet at a vertex.
template <class T>
struct Turn {
  T density{};  ///< over the sweep [1/m]
  Sweep<T> sweep{};

  T about(const Vertical<T>& axis) const { return density * sweep.about(axis); }

  template <class F>
  constexpr void each_member(F& f) {
    f(density), f(sweep.x), f(sweep.y), f(sweep.along), f(sweep.aside);
  }
};

/// Sums of n h / g.
template <class T>
struct Densities {
  T edges{};     ///< of connecting edges
  T meetings{};  ///< of meetings, over `shifts` [1/m]
  T turned{};    ///< of turning, about the walk's own vertical

  /// `shifts`: of a path, as transport::Freedom has it [m].
  T all(const T& shifts) const { return edges + shifts * meetings + turned; }

  template <class F>
  constexpr void each_member(F& f) {
    f(edges), f(meetings), f(turned);
  }
  friend Densities select(const Mask<T>& mask, const Densities& yes, const Densities& no) {
    return {select(mask, yes.edges, no.edges), select(mask, yes.meetings, no.meetings),
            select(mask, yes.turned, no.turned)};
  }
};

/// How a walk's light spreads from its instrument: from a point, in directions that are dense as
/// 1 / solid_angle.
template <class T>
struct Spread {
  bool through_surface = false;
  T before{};       ///< length from that point to where the ray in the water begins [m]
  T cos_air{1};     ///< of the ray in the air, to the vertical
  T solid_angle{};  ///< [sr]; 0: parallel rays, which no connection can meet

  template <class F>
  constexpr void each_member(F f) {
    f(before), f(cos_air), f(solid_angle);
  }
};

/// Area across the ray in the water per solid angle at the instrument's point [m^2/sr].
template <class T>
T area_per_solid_angle(const medium::MediumView& sea, const Spread<T>& spread, const Index<T>& line,
                       const T& length, const T& cos_water) {
  if (!spread.through_surface) {
    const T whole = spread.before + length;
    return whole * whole;
  }
  const T inverse_n = gather<T>(sea.inverse_index, line);
  const Widening<T> widening{cos_water / spread.cos_air, spread.cos_air / cos_water};
  return refracted_area_per_solid_angle(inverse_n, length, spread.before, widening);
}

/// Where a walk stands.
template <class T>
struct WalkPoint {
  Vec3<T> position;
  Vec3<T> direction;  ///< in which it arrives or leaves
  T weight{};  ///< the path's contribution over the density drawn from, without the chances h
  T path{};    ///< [m]
  Index<T> line{}, layer{};

  /// Calls f(member) for each.
  template <class F>
  constexpr void each_member(F& f) {
    f(position.x), f(position.y), f(position.z);
    f(direction.x), f(direction.y), f(direction.z);
    f(weight), f(path), f(line), f(layer);
  }
};
template <class T>
WalkPoint<T> walk_point(const Photon<T>& photon) {
  return {photon.position, photon.direction, photon.weight, photon.path, photon.line, photon.layer};
}

/// A walk as it leaves a vertex, the collision's weight included, or enters the water.
template <class T>
struct Ray : WalkPoint<T> {
  T left_chance{1};       ///< h of a walk that ends at the vertex
  T chance{1};            ///< h of this ray
  T passed{1};            ///< h of telescopes' walks that pass a laser's walk as far as this ray
  T per_p{1};             ///< 1 over the phase function's value at the vertex [sr]
  T last_edge{};          ///< of connecting the edge before, over `passed`
  Densities<T> behind{};  ///< of all that is complete, over `passed`
  T meeting{};  ///< n h / g of meeting at the vertex over `shifts`, but for what is this ray's: P
                ///< included
  Turn<T> turn{};  ///< the same of turning

  /// That the surface has reflected it: it stands for the ray that set out from its mirror image.
  Mask<T> is_reflected() const { return WalkPoint<T>::position.z > T(0); }
  /// z of the direction in which it left the vertex.
  T left_z() const {
    const T z = WalkPoint<T>::direction.z;
    return select(is_reflected(), T(0) - z, z);
  }
  template <class F>
  constexpr void each_member(F f) {
    WalkPoint<T>::each_member(f);
    f(left_chance), f(chance), f(passed), f(per_p), f(last_edge), f(meeting);
    behind.each_member(f);
    turn.each_member(f);
  }
};

/// A walk as it arrives where it collides, before this collision.
template <class T>
struct Vertex : WalkPoint<T> {
  T chance{1};  ///< h of a walk that ends here
  T passed{1};  ///< h of telescopes' walks that pass a laser's walk as far as here
  T open{};     ///< n h / g of connecting the last edge, times P here; 0: it cannot be
  T meeting{};  ///< n h / g of meeting here over `shifts`, but for P and for the edge beyond; its
                ///< sign is that of the arriving direction's z
  T turn{};     ///< n h / g of turning to meet here, but for P, sweep and the edge beyond
  // Over `passed`:
  Turn<T> last_turn{};    ///< of turning to meet at the vertex before, complete by the last edge
  Densities<T> last{};    ///< of what has become complete by the last edge
  Densities<T> behind{};  ///< of all that is complete
  template <class F>
  constexpr void each_member(F f) {
    WalkPoint<T>::each_member(f);
    f(chance), f(passed), f(open), f(meeting), f(turn);
    last.each_member(f);
    last_turn.each_member(f);  // read alone, too: words 18 to 22 lie in one pack of any width
    behind.each_member(f);
  }
};

/// A walk's way from its last vertex, or its instrument, to where it is.
template <class T>
struct Leg {
  T length{};          ///< in the water [m]
  T walk_tau{};        ///< optical depth of the coefficient that free paths are drawn from
  Mask<T> mirrored{};  ///< it was reflected by the surface

  friend Leg select(const Mask<T>& mask, const Leg& yes, const Leg& no) {
    return {select(mask, yes.length, no.length), select(mask, yes.walk_tau, no.walk_tau),
            select(mask, yes.mirrored, no.mirrored)};
  }
};

/// Adds a flight of a photon that stood at `before` to its leg.
template <class T>
void add_flight(const medium::MediumView& sea, const Photon<T>& before, const Photon<T>& photon,
                Leg<T>& leg) {
  const T moved = (photon.path - before.path) / gather<T>(sea.group_index, photon.line);
  leg.length = leg.length + moved;
  leg.walk_tau = leg.walk_tau + sea.walk_slant_optical_depth(photon.line, level_of(sea, before),
                                                             level_of(sea, photon), moved);
}

/// The part of n h / g of a meeting that follows from both directions' z: only where light turns
/// back up or down do rays meet.
template <class T>
T turning(const T& meeting, const T& z) {
  const T product = T(0) - meeting * z;
  return select(product > T(0), product, T(0));
}

/// n h / g of turning walks to meet at a vertex that is left in a direction, but for P and the edge
/// beyond.
template <class T>
Turn<T> turn_at(const Vertex<T>& v, const Vec3<T>& direction) {
  return {v.turn, sweep(v.position, v.direction, direction)};
}

/// How a walk left a vertex.
template <class T>
struct Departure {
  T p{1};        ///< phase function's value [1/sr]
  T chance{1};   ///< of the choices that the phase function does not make
  T passed{1};   ///< the same of a telescope's walk that passes a vertex of the laser's
  T density{1};  ///< c' of the line that a walk from the laser would have come with, over that of
                 ///< the walk's own; 0: the path's edges behind can be drawn by no other strategy
};

/// The ray in which the photon has departed from a vertex.
template <class T>
Ray<T> next_ray(const Photon<T>& photon, const Vertex<T>& from, const Departure<T>& departure) {
  Ray<T> ray{walk_point(photon)};
  ray.left_chance = from.chance;
  ray.chance = from.chance * departure.chance;
  ray.passed = from.passed * departure.passed;
  ray.per_p = T(1) / departure.p;
  ray.last_edge = departure.density * from.open * ray.per_p / ray.passed;
  ray.behind = from.behind;
  ray.behind.edges = from.behind.edges + ray.last_edge;
  const Mask<T> known = departure.density > T(0);
  ray.meeting = select(known, from.meeting * ray.per_p, T(0));
  ray.turn = turn_at(from, photon.direction);
  ray.turn.density = select(known, ray.turn.density * ray.per_p, T(0));
  return ray;
}

/// n h / g of connecting the edge along a ray to a point `length` away, times P there and the
/// walked exp(-tau). `first`: the ray leaves the instrument, as light that spreads so.
template <class T>
T connecting_area(const medium::MediumView& sea, const Ray<T>& ray, const Mask<T>& first,
                  const Spread<T>& spread, const T& length, const Samples<T>& samples) {
  using std::abs;
  const T area = samples.between * ray.left_chance * ray.per_p * (length * length);
  if (!any(first)) return area;
  const T from_instrument =
      samples.to_instrument * spread.solid_angle *
      area_per_solid_angle(sea, spread, ray.line, length, T(abs(ray.direction.z)));
  return select(first, from_instrument, area);
}

/// The vertex where a photon collides that came by a ray, which leaves the instrument if `first`.
/// `axis`: that of the walk.
template <class T>
Vertex<T> vertex_on(const medium::MediumView& sea, const Ray<T>& ray, const Mask<T>& first,
                    const Spread<T>& spread, const Photon<T>& photon, const Leg<T>& leg,
                    const Vertical<T>& axis, const Samples<T>& samples) {
  Vertex<T> v{walk_point(photon)};
  v.chance = ray.chance;
  v.passed = ray.passed;
  const T growth = T(1) / exp_minus(leg.walk_tau);
  const T straight = select(leg.mirrored, T(0), growth);
  // A mirrored first edge can be connected: to the instrument's mirror image.
  v.open = connecting_area(sea, ray, first, spread, leg.length, samples) *
           select(first, growth, straight);
  const T drawn =
      ray.chance * growth * gather<T>(sea.walk_mean_path, sea.at(photon.line, photon.layer));
  v.meeting = drawn * photon.direction.z;
  v.turn = samples.turned * T(2 * pi) * drawn;
  v.last_turn = ray.turn;
  const T over_passed = growth / ray.passed;
  v.last_turn.density = ray.turn.density * over_passed;
  v.last.edges = ray.last_edge;
  v.last.meetings = turning(ray.meeting, over_passed * ray.left_z());
  v.last.turned = v.last_turn.about(axis);
  v.behind.edges = ray.behind.edges;
  v.behind.meetings = ray.behind.meetings + v.last.meetings;
  v.behind.turned = ray.behind.turned + v.last.turned;
  return v;
}

/// One end of a connection: the phase function there, and the densities behind it.
template <class T>
struct End {
  T p{1};
  T open{};    ///< n h / g of connecting the last edge, times p
  T behind{};  ///< sum of n h / g of what is complete
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
          exp_minus(walk_tau) * (a.open * b.p + b.open * a.p + (a.behind + b.behind) * both));
}

}  // namespace photic::transport
