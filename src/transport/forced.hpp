// A collision forced for scoring on the way ahead of a photon, its history unchanged: the "local
// forced collisions" of PREMAR-2F, here for conversions. Where light is converted in the view of a
// telescope it is scored although few photons happen to collide there.
#pragma once

#include <cmath>
#include <vector>

#include "medium/medium.hpp"
#include "transport/flight.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// The way that converted light takes to a telescope: from the depths of its view back along the
/// (refracted) axis to where it enters the lens or the surface, attenuated with `rate` [1/m].
template <class T>
struct Approach {
  Vec3<T> entry;
  Vec3<T> axis;  ///< unit vector into the water
  T rate{};
};

template <class T>
struct ForcedUniforms {
  T choice, distance, approach;
};

/// Share of the points that are drawn from the approaches; the rest fall where photons collide by
/// themselves.
inline constexpr double forced_share = 0.5;

/// Moves a photon in the water to a point on its ray and multiplies its weight by the density of
/// collisions there over that of the points, so that what is scored there is in the mean what the
/// photon's next collision gives. Points come from the free flight, or lie on a photon's way
/// towards a telescope's entry with a density that falls as its light does, in the distance to the
/// entry along the axis. False: no point, the ray has left the water.
template <class T>
Mask<T> force_collision(const medium::MediumView& sea, Photon<T>& photon,
                        const std::vector<Approach<T>>& approaches, const ForcedUniforms<T>& u) {
  using std::exp;
  using std::log;
  // The approaches this ray is on: at a distance `ahead` from the entry along the axis, nearing it
  // by `speed` a metre.
  const auto ahead_of = [&](const Approach<T>& a) {
    return dot(photon.position - a.entry, a.axis);
  };
  const auto speed_to = [&](const Approach<T>& a) { return -dot(photon.direction, a.axis); };
  const auto is_on = [&](const Approach<T>& a) {
    const T ahead = ahead_of(a);
    const T speed = speed_to(a);
    return (ahead > T(0)) & (speed > T(1e-3));
  };
  T count(0);
  for (const auto& a : approaches) count = count + select(is_on(a), T(1), T(0));
  const T share = select(count > T(0), T(forced_share), T(0));

  // The distance along the ray: by the approach number floor(u count), or by a free flight.
  const Mask<T> forced = u.choice < share;
  T distance(0);
  T rest = u.approach * count;
  for (const auto& a : approaches) {
    const Mask<T> on = is_on(a);
    const T ahead = select(on, ahead_of(a), T(1));
    const T speed = select(on, speed_to(a), T(1));
    const T left = -log(T(1) - u.distance * (T(1) - exp(-a.rate * ahead))) / a.rate;
    distance = select(on & (rest >= T(0)) & (rest < T(1)), (ahead - left) / speed, distance);
    rest = rest - select(on, T(1), T(0));
  }
  Photon<T> flown = photon;
  const FlightEnd<T> end = fly(sea, flown, u.distance);
  Photon<T> placed = photon;
  const Mask<T> in_water = advance(sea, placed, distance);
  const Mask<T> reached = select(forced, in_water, !(end.surface | end.sea_bed));
  const T moved = select(forced, distance,
                         (flown.path - photon.path) / gather<T>(sea.group_index, photon.line));
  const Photon<T> before = photon;
  photon.position = select(forced, placed.position, flown.position);
  photon.layer = select(forced, placed.layer, flown.layer);
  photon.path = select(forced, placed.path, flown.path);

  const T depth1 = -before.position.z;
  const T depth2 = -photon.position.z;
  const Index<T> here = sea.at(photon.line, photon.layer);
  const T tau =
      sea.slant_optical_depth<T>(photon.line, before.layer, depth1, photon.layer, depth2, moved);
  const T walk_tau = sea.walk_slant_optical_depth<T>(photon.line, before.layer, depth1,
                                                     photon.layer, depth2, moved);
  T density = (T(1) - share) * gather<T>(sea.walk_c, here) * exp(-walk_tau);
  for (const auto& a : approaches) {
    const T ahead = dot(before.position - a.entry, a.axis);
    const T speed = -dot(before.direction, a.axis);
    const Mask<T> on = (ahead > T(0)) & (speed > T(1e-3));
    const T left = ahead - moved * speed;
    const T norm = select(on, count * (T(1) - exp(-a.rate * ahead)), T(1));
    density = density +
              select(on & (left > T(0)), share * a.rate * speed * exp(-a.rate * left) / norm, T(0));
  }
  photon.weight =
      photon.weight *
      select(reached, gather<T>(sea.c, here) * exp(-tau) / select(reached, density, T(1)), T(0));
  return reached;
}

}  // namespace photic::transport
