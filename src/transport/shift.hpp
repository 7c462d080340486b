// The rays of a telescope's walk that can be shifted sideways to meet a vertex of the laser's walk
// (vertex.hpp tells why).
#pragma once

#include "instrument/lens.hpp"
#include "transport/vertex.hpp"

namespace photic::transport {

/// How a telescope's walk leaves its instrument, or a vertex.
template <class T>
struct Ray {
  Vec3<T> position;  ///< where it enters the water, or of the vertex
  Vec3<T> direction;
  T weight{};  ///< of the walk with this vertex' collision, without the chances h
  T path{};    ///< [m]
  Index<T> line{}, layer{};
  T chance{1};        ///< h of a connection to the vertex
  T shift_chance{1};  ///< h of a shift of this ray
  T p{1};             ///< phase function's value [1/sr]
  T before{};         ///< n h / g of what was open at the vertex
  T closed{};         ///< sum of n h / g of all behind the ray
};

/// The ray in which a telescope's walk enters the water.
template <class T>
Ray<T> first_ray(const Photon<T>& photon) {
  Ray<T> ray;
  ray.position = photon.position;
  ray.direction = photon.direction;
  ray.weight = photon.weight;
  ray.path = photon.path;
  ray.line = photon.line;
  ray.layer = photon.layer;
  return ray;
}

/// The ray in which the photon has departed from a vertex.
template <class T>
Ray<T> next_ray(const Photon<T>& photon, const Vertex<T>& from, const Departure<T>& departure) {
  Ray<T> ray = first_ray(photon);
  ray.chance = from.chance;
  ray.shift_chance = from.chance * departure.chance;
  ray.p = departure.p;
  ray.before = departure.density * from.open / departure.p;
  ray.closed = from.closed + ray.before;
  return ray;
}

/// A ray that is to meet a point.
template <class T>
struct Meeting {
  T length;                        ///< of the ray up to there [m]; not above 0: it never does
  instrument::PlanePoint<T> lens;  ///< where the shifted walk comes through the plane of the lens
  Mask<T> through_lens;
};

/// Shifts the walk from an upright telescope that came through its lens at `lens`.
template <class T>
Meeting<T> shift_to(const Vec3<T>& point, const Ray<T>& ray,
                    const instrument::Telescope<T>& telescope,
                    const instrument::PlanePoint<T>& lens) {
  Meeting<T> meeting;
  meeting.length = (point.z - ray.position.z) / ray.direction.z;
  const Vec3<T> shift = point - (ray.position + meeting.length * ray.direction);
  meeting.lens = {lens.x + dot(shift, telescope.across), lens.y + dot(shift, telescope.up)};
  const T squared = meeting.lens.x * meeting.lens.x + meeting.lens.y * meeting.lens.y;
  meeting.through_lens = (meeting.length > T(0)) &
                         (squared < telescope.lens_radius * telescope.lens_radius) &
                         (squared >= telescope.obstruction_radius * telescope.obstruction_radius);
  return meeting;
}

}  // namespace photic::transport
