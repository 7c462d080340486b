// How walks come into the water through waves (docs/theory.md, "Walks through waves"). An
// instrument's ray leads to a point of the surface. From there a walk goes on in a direction of its
// instrument's cone, which does not depend on that ray; its weight takes how much light the facets
// and whitecaps of the point send so. What goes by way of several facets has walks of its own.
#pragma once

#include "core/turn.hpp"
#include "estimator/bidirectional/by_facets.hpp"
#include "estimator/bidirectional/pairings.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "estimator/entry_cone.hpp"
#include "instrument/laser.hpp"
#include "surface/waves.hpp"
#include "transport/connect_waves.hpp"
#include "transport/cross.hpp"
#include "transport/emit.hpp"
#include "transport/surface_points.hpp"

namespace photic::estimator {

/// By a ray of the laser, from two uniforms.
template <class T>
SurfaceEntry<T> entry_of_laser(const instrument::Laser<T>& laser, const Index<T>& layer,
                               const T& u_polar, const T& u_azimuth) {
  auto photon = transport::emit(laser, layer, u_polar, u_azimuth);
  SurfaceEntry<T> entry;
  entry.exists = transport::come_down(photon);
  entry.at = photon.position;
  entry.outside = photon.direction;
  entry.path = photon.path;
  return entry;
}

/// By a ray that a telescope sees through a point of its lens, alike for all points of the
/// detector. The weight is that of all rays that it sees.
template <class T>
SurfaceEntry<T> entry_of_telescope(const instrument::Telescope<T>& telescope,
                                   const instrument::PlanePoint<T>& lens, const T& u_radius,
                                   const T& u_azimuth, instrument::Sight<T>& sight) {
  const auto point = transport::point_seen(telescope, lens, u_radius, u_azimuth);
  const auto way = transport::from_surface(telescope, lens, point.at);
  sight = way.sight;
  const T half_view = telescope.detector_radius / telescope.detector_distance;
  const T square = sight.cos_off_axis * sight.cos_off_axis;
  SurfaceEntry<T> entry;
  entry.exists = point.exists & way.seen;
  entry.at = point.at;
  entry.outside = -way.direction;
  entry.weight = telescope.area() * (T(pi) * half_view * half_view * square * square);
  entry.path = longer_way(telescope, point.at, lens, way.length);
  return entry;
}

/// The weight of a walk that goes on from an entry in a direction of the cone. `line`: of its light.
template <class T>
T weight_along(const medium::MediumView& sea, const SurfaceEntry<T>& entry, bool from_telescope,
               const Index<T>& line, const Vec3<T>& direction, const T& solid_angle) {
  const auto surface = surface::rough_surface<T>(sea, line);
  const T passes = surface.density(Mask<T>(true), false, entry.outside, direction);
  const T weight = entry.weight * solid_angle * passes;
  return from_telescope ? weight / (surface.n * surface.n) : weight;
}

/// The straight edge from an entry to a point in the water.
template <class T>
struct EntryEdge {
  Mask<T> exists{};
  Vec3<T> direction;  ///< away from the instrument
  T length{};         ///< [m]
  T area{};           ///< across it, of the cone [m^2]
  T weight{};         ///< of a walk that begins so
};
template <class T>
EntryEdge<T> edge_from(const medium::MediumView& sea, const EntryCone<T>& cone,
                       const SurfaceEntry<T>& entry, bool from_telescope, const Index<T>& line,
                       const Vec3<T>& to) {
  const Vec3<T> there = to - entry.at;
  EntryEdge<T> edge;
  edge.length = length(there);
  edge.exists = entry.exists & (there.z < T(0));
  edge.direction = (T(1) / select(edge.exists, edge.length, T(1))) * there;
  const T solid_angle = cone.solid_angle_at(one_minus_cos(edge.direction, cone.axis));
  edge.area = solid_angle * (edge.length * edge.length);
  edge.weight = weight_along(sea, entry, from_telescope, line, edge.direction, solid_angle);
  edge.exists = edge.exists & (edge.weight > T(0));
  return edge;
}
/// The same as light goes along it to the instrument, or would if it went back.
template <class T>
geometry::Sightline<T> sightline_along(const EntryEdge<T>& edge, const SurfaceEntry<T>& entry,
                                       const geometry::Region<T>& to) {
  geometry::Sightline<T> way;
  way.exists = edge.exists;
  way.direction = -edge.direction;
  way.arriving = -entry.outside;
  way.length_water = edge.length;
  way.crossing = entry.at;
  way.secant_water = T(1) / select(edge.exists, way.direction.z, T(1));
  way.to = to;
  return way;
}

/// A walk that begins at an entry, by two uniforms; draw(block) draws more.
template <class T, class Draw>
Birth<T> birth_through_waves(const medium::MediumView& sea, const geometry::Region<T>& region,
                             const EntryCone<T>& cone, const SurfaceEntry<T>& entry,
                             bool from_telescope, const Index<T>& line, const T& u_polar,
                             const T& u_azimuth, Draw draw) {
  Birth<T> birth;
  birth.entry = entry;
  auto& photon = birth.photon;
  photon.position = entry.at;
  photon.path = entry.path;
  photon.line = line;
  photon.layer = region.layer;
  const Vec3<T> direction = direction_in_water(cone, u_polar, u_azimuth);
  const T solid_angle = cone.solid_angle_at(one_minus_cos(direction, cone.axis));
  photon.direction = direction;
  photon.weight = weight_along(sea, entry, from_telescope, line, direction, solid_angle);
  birth.spread.solid_angle = solid_angle;
  birth.exists = entry.exists & (direction.z < T(0));
  const Mask<T> several = entry.exists & (u_polar >= cone.by_one_facet());
  if (any(several)) {
    auto by = photon;
    by.direction = entry.outside;
    by.weight = entry.weight / cone.by_facets;
    const auto surface = surface::rough_surface<T>(sea, line);
    const auto met = from_telescope ? back_by_facets(surface, by, several, true, true, draw)
                                    : light_by_facets(surface, by, several, true, draw);
    photon = select(several, by, photon);
    birth.spread.solid_angle = select(several, T(0), solid_angle);
    birth.exists = (birth.exists & !several) | (met.in_water & met.several);
  }
  birth.own = birth.exists;
  return birth;
}

}  // namespace photic::estimator
