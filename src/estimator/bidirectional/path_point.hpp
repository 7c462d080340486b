// The points of walks that are to be connected: the rays that leave vertices, and the vertices.
#pragma once

#include "estimator/bidirectional/rotated_meeting.hpp"
#include "estimator/bidirectional/strategy_sums.hpp"
#include "geometry/segment.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

/// The place of a walk.
template <class T>
struct WalkPoint {
  Vec3<T> position;
  Vec3<T> direction;  ///< in which it arrives or leaves
  T weight{};  ///< contribution over the density of what was drawn, but for discrete choices (h)
  T path{};    ///< [m]
  Index<T> line{}, layer{};

  /// Along its direction to a depth, negative behind it [m].
  [[nodiscard]] T length_to(const T& depth) const {
    return (geometry::depth_of(position) - depth) / direction.z;
  }
  /// Calls f(member) for each.
  template <class F>
  constexpr void each_member(F& f) {
    f(position.x), f(position.y), f(position.z);
    f(direction.x), f(direction.y), f(direction.z);
    f(weight), f(path), f(line), f(layer);
  }
};

template <class T>
WalkPoint<T> walk_point(const transport::Photon<T>& photon) {
  return {photon.position, photon.direction, photon.weight, photon.path, photon.line, photon.layer};
}

/// A walk as it leaves a vertex, the collision's weight included, or enters the water.
template <class T>
struct Ray : WalkPoint<T> {
  // Chances h of the discrete choices of a walk:
  T vertex_chance{1};   ///< of this walk up to the vertex, whose choice does not count
  T chance{1};          ///< of this walk up to this ray
  T reverse_chance{1};  ///< of a telescope's walk that comes through a laser's walk the other way
  T per_p{1};           ///< 1 over the density at the vertex, the phase function [sr]
  // Densities over reverse_chance:
  T last_edge{};          ///< of connecting the edge that came to the vertex
  Densities<T> behind{};  ///< of all strategies behind this ray
  // Densities of meeting at the vertex, but for what the edge of this ray adds:
  T translated{};  ///< over Freedom::translations [m]; and but for |cos| of this ray
  RotatedMeeting<T> rotated{};

  /// Returns whether it stands for a ray that the surface has reflected: then it comes from the
  /// mirror image of the vertex.
  Mask<T> is_reflected() const { return WalkPoint<T>::position.z > T(0); }
  /// z of the direction in which it left the vertex.
  T leaving_z() const {
    const T z = WalkPoint<T>::direction.z;
    return select(is_reflected(), T(0) - z, z);
  }
  template <class F>
  constexpr void each_member(F f) {
    WalkPoint<T>::each_member(f);
    f(vertex_chance), f(chance), f(reverse_chance), f(per_p), f(last_edge), f(translated);
    behind.each_member(f);
    rotated.each_member(f);
  }
};

/// A walk as it arrives where it collides, before this collision.
template <class T>
struct Vertex : WalkPoint<T> {
  // Chances h of the discrete choices of a walk:
  T chance{1};          ///< of this walk up to here
  T reverse_chance{1};  ///< of a telescope's walk that comes through a laser's walk the other way
  // Densities, but for the phase function here:
  T arriving_edge{};  ///< of connecting the edge that came here; 0: it cannot be connected
  // And but for what the edge beyond adds, of meeting here:
  T translated{};  ///< over Freedom::translations [m]; has the sign of the arriving direction's z
  T rotated{};     ///< over the Jacobian of the rotation [m]
  // Densities over reverse_chance:
  RotatedMeeting<T> added_rotated{};  ///< of meeting at the vertex before, by rotation
  Densities<T> added{};               ///< of all that the arriving edge has completed
  Densities<T> behind{};              ///< of all strategies behind this vertex
  template <class F>
  constexpr void each_member(F f) {
    WalkPoint<T>::each_member(f);
    f(chance), f(reverse_chance), f(arriving_edge), f(translated), f(rotated);
    added.each_member(f);
    added_rotated.each_member(f);  // read alone, too: words 18 to 22 lie in one pack of any width
    behind.each_member(f);
  }
};

/// A walk's way from its last vertex, or its instrument, to where it is.
template <class T>
struct Leg {
  T length{};           ///< in the water [m]
  T walk_tau{};         ///< optical depth of the coefficient that free paths are drawn from
  Mask<T> reflected{};  ///< it was reflected by the surface

  friend Leg select(const Mask<T>& mask, const Leg& yes, const Leg& no) {
    return {select(mask, yes.length, no.length), select(mask, yes.walk_tau, no.walk_tau),
            select(mask, yes.reflected, no.reflected)};
  }
};

/// Adds a flight of a photon that stood at `before`, of a length, to its leg.
template <class T>
void add_flight(const geometry::Slabs& sea, const transport::Photon<T>& before,
                const transport::Photon<T>& photon, const T& moved, Leg<T>& leg) {
  leg.length = leg.length + moved;
  const geometry::Segment<T> flown{photon.line, geometry::level_of(sea, before),
                                   geometry::level_of(sea, photon), moved};
  leg.walk_tau = leg.walk_tau + geometry::optical_depths(sea, flown).walk;
}

}  // namespace photic::estimator
