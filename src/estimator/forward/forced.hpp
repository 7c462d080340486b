// A collision forced for scoring on the way ahead of a photon, its history unchanged: the "local
// forced collisions" of PREMAR-2F, here for conversions. Where light is converted in the view of a
// telescope it is scored although few photons happen to collide there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/elementary.hpp"
#include "estimator/view.hpp"
#include "geometry/segment.hpp"
#include "medium/medium.hpp"
#include "surface/lambert.hpp"
#include "transport/flight.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

/// The stretch of a ray in a view, and an exponential density on it that follows the view's
/// attenuation: distances from its bright end.
template <class T>
struct Stretch {
  Mask<T> exists;
  T from, to;     ///< along the ray [m]
  T rate;         ///< [1/m]
  T whole;        ///< of the exponential on it: 1 - exp(-rate (to - from))
  Mask<T> rises;  ///< the bright end is `to`

  T sample(const T& u) const {
    const T y = minus_log(T(1) - u * whole) / rate;
    return select(rises, to - y, from + y);
  }
  T density(const T& distance) const {
    const Mask<T> inside = exists & (distance >= from) & (distance <= to);
    const T from_bright_end = select(rises, to - distance, distance - from);
    const T y = select(inside, from_bright_end, T(0));
    return select(inside, rate * exp_minus(rate * y) / whole, T(0));
  }
};

template <class T>
Stretch<T> stretch_in(const estimator::ViewCone<T>& view, const transport::Photon<T>& photon) {
  using std::abs;
  using std::sqrt;
  const T longest(1e6);
  const Vec3<T> out = photon.position - view.entry;
  const T along = dot(out, view.axis);
  const T speed = dot(photon.direction, view.axis);
  // |out + t d|^2 - s^2 <= (radius + widening s)^2 with s = along + speed t: a t^2 + 2 b t + c <=
  // 0.
  const T cone = T(1) + view.widening * view.widening;
  const T edge = view.radius * view.widening;
  const T a = T(1) - speed * speed * cone;
  const T b = dot(out, photon.direction) - along * speed * cone - edge * speed;
  const T c =
      dot(out, out) - along * along * cone - T(2) * edge * along - view.radius * view.radius;
  const T discriminant = b * b - a * c;
  // A ray along the axis is taken to be in the view all along.
  const Mask<T> axial = a < T(1e-4);
  const Mask<T> crosses = discriminant > T(0);
  const T root = sqrt(select(crosses, discriminant, T(0)));
  const T per_a = T(1) / select(axial, T(1), a);
  T from = select(axial, T(0), (-b - root) * per_a);
  T to = select(axial, longest, (root - b) * per_a);
  // No farther than the entry.
  const Mask<T> slanted = abs(speed) > T(1e-6);
  const T entry = -along / select(slanted, speed, T(1));
  const Mask<T> leaves = slanted & (speed < T(0)) & (entry < to);
  const Mask<T> comes = slanted & (speed > T(0)) & (entry > from);
  to = select(leaves, entry, to);
  from = select(comes, entry, from);
  from = select(from > T(0), from, T(0));

  Stretch<T> stretch;
  stretch.exists = (axial | crosses) & (to - from > T(1e-6)) & (slanted | (along > T(0)));
  stretch.from = from;
  stretch.to = select(stretch.exists, to, from + T(1));
  const T rate = view.rate * abs(speed);
  const T least = T(1e-3) / (stretch.to - from);
  stretch.rate = select(rate > least, rate, least);
  stretch.whole = T(1) - exp_minus(stretch.rate * (stretch.to - from));
  stretch.rises = speed < T(0);
  return stretch;
}

template <class T>
struct ForcedUniforms {
  T choice, distance, view;
};

/// Share of the points that are drawn from the views; the rest fall where photons collide by
/// themselves.
inline constexpr double forced_share = 0.5;

/// Conversions in the views beyond are found by free flights, and in the others' views.
inline constexpr std::size_t max_forced_views = 16;

template <class T>
struct ForcedCollision {
  Mask<T> reached;  ///< none where the ray has left the water
  T moved{};        ///< the length to it [m]
};
/// Moves a photon in the water to a point on its ray and multiplies its weight by the density of
/// collisions there over that of the points, so that what is scored there is in the mean what the
/// photon's next collision gives. Points come from the free flight, or from the stretches of the
/// ray in the telescopes' views.
template <class T>
ForcedCollision<T> force_collision(const geometry::Slabs& sea, transport::Photon<T>& photon,
                                   const std::vector<estimator::ViewCone<T>>& views,
                                   const ForcedUniforms<T>& u) {
  const transport::Photon<T> before = photon;
  const std::size_t taking_part = std::min(max_forced_views, views.size());
  std::array<Stretch<T>, max_forced_views> stretch;
  T count(0);
  for (std::size_t k = 0; k < taking_part; ++k) {
    stretch[k] = stretch_in(views[k], before);
    count = count + select(stretch[k].exists, T(1), T(0));
  }
  const T share = select(count > T(0), T(forced_share), T(0));

  // The distance along the ray: in the view number floor(u count), or by a free flight.
  const Mask<T> forced = u.choice < share;
  T distance(0);
  T rest = u.view * count;
  for (std::size_t k = 0; k < taking_part; ++k) {
    const Mask<T> taken = stretch[k].exists & (rest >= T(0)) & (rest < T(1));
    distance = select(taken, stretch[k].sample(u.distance), distance);
    rest = rest - select(stretch[k].exists, T(1), T(0));
  }
  transport::Photon<T> flown = photon;
  const transport::FlightEnd<T> end = transport::fly(sea, flown, minus_log(u.distance));
  transport::Photon<T> placed = photon;
  const Mask<T> in_water = transport::advance(sea, placed, distance);
  const Mask<T> collides =
      !(end.surface | end.sea_bed | end.sideways | surface::on_bed<T>(sea, flown.layer));
  const Mask<T> reached = select(forced, in_water, collides);
  const T moved = select(forced, distance, end.length);
  photon.position = select(forced, placed.position, flown.position);
  photon.layer = select(forced, placed.layer, flown.layer);
  photon.path = select(forced, placed.path, flown.path);

  const Index<T> here = sea.at(photon.line, photon.layer);
  const auto tau = geometry::optical_depths(
      sea, geometry::Segment<T>{photon.line, geometry::level_of(sea, before),
                                geometry::level_of(sea, photon), moved,
                                geometry::Ray<T>{before.position, before.direction}});
  T density = (T(1) - share) * gather<T>(sea.walk_c.first, here) * exp_minus(tau.walk);
  const T per_view = share / select(count > T(0), count, T(1));
  for (std::size_t k = 0; k < taking_part; ++k)
    density = density + per_view * stretch[k].density(moved);
  photon.weight = photon.weight * select(reached,
                                         gather<T>(sea.c.first, here) * exp_minus(tau.all) /
                                             select(reached, density, T(1)),
                                         T(0));
  return {reached, moved};
}

}  // namespace photic::estimator
