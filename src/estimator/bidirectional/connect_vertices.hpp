// Connections of vertices: with the telescope, with the laser, with each other (a part of
// connections.hpp).
#pragma once

#include "estimator/bidirectional/connections.hpp"
#include "estimator/bidirectional/surface_entry.hpp"

namespace photic::estimator {

template <class T>
void Connections<T>::to_telescope(std::size_t walk) {
  if (!connects(receiver_.region)) return;
  lanes::each_index<T>(laser_.vertices(walk), [&](const Index<T>& i, const Mask<T>& mask) {
    tally_.operations.vertex_pairs += count(mask);
    to_telescope_.push(mask, pairing_of<T>(walk, i, walk, Index<T>(0)),
                       [this](const auto& e, const auto& all) { serve_to_telescope(e, all); });
  });
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_to_telescope(const Pairing<T>& pairing,
                                                                    const Mask<T>& mask) {
  const Index<T> line = back_.line(pairing.back);
  const auto birth = back_.birth_record(pairing.back);
  const auto in_path = usable(pairing.i + Index<T>(1));
  const Vertex v = laser_.in_path(pairing.laser, pairing.i, in_path);
  const Mask<T> wanted = mask & emits(line, v.layer);
  if (enters_through_waves(world_.slabs, receiver_.region)) {
    const auto own = back_.entry(pairing.back);
    for (const bool by_slopes : {false, true}) {
      if (by_slopes && !world_.walks.cone(instrument()).enters_by_slopes) break;
      const auto entry =
          entry_to(world_, instrument(), line, v.position, own, birth.lens, by_slopes, wanted);
      score_to_telescope(
          pairing, v, sightline_along(entry, receiver_.region),
          edge_to_telescope(wanted, entry, line, geometry::level_of(sea_, v), birth.lens));
    }
    return;
  }
  if (!sea_.surface.one_direction_each)
    score_by_facet(pairing, v, birth.lens, wanted & (pairing.i == Index<T>(0)));
  const Mask<T> may_be_seen =
      wanted & transport::may_see(sea_, telescope_, v.position, line, birth.lens);
  if (!any(may_be_seen)) return;
  const Vec3<T> at = in_space(telescope_, birth.lens);
  for (const auto route : geometry::routes_to(receiver_.region.outside)) {
    if (!sea_.surface.one_direction_each && geometry::meets_surface(receiver_.region, route))
      return;
    const auto way =
        geometry::sightline(sea_, v.position, line, at, receiver_.region, route, may_be_seen);
    score_to_telescope(pairing, v, way,
                       edge_to_telescope(may_be_seen, v.position, v.layer, birth.lens, line, way));
  }
}
/// To a telescope in the water by way of a facet, from the only vertex of a path. No other strategy
/// draws this: it has the whole weight of the laser's walk.
template <class T>
PHOTIC_APART void Connections<T>::score_by_facet(Pairing<T> pairing, const Vertex& v,
                                                 instrument::PlanePoint<T> lens, Mask<T> mask) {
  const Index<T> line = back_.line(pairing.back);
  const auto entry = back_.entry(pairing.back);
  transport::Photon<T> photon;
  photon.position = v.position;
  photon.layer = v.layer;
  const auto way =
      transport::connect_by_waves(sea_, telescope_, receiver_.region, photon, line, lens,
                                  {entry.u_choice, entry.u_slope, entry.u_azimuth}, mask);
  const T path = v.path + way.path;
  const Mask<T> seen = mask & (way.acceptance > T(0)) & (path < receiver_.last_path);
  if (!any(seen)) return;
  const Freedom<T> none{T(0), RotationAxis<T>{}};
  const ConnectionEnd from =
      all(line == Index<T>(0))
          ? scattering_from_laser(sea_, v, T(0), way.direction, world_.walks.inverse_conversion,
                                  T(1), none)
          : conversion_from_laser(sea_, v, T(0), way.direction, line,
                                  world_.walks.inverse_conversion, Index<T>(0), T(1), T(1), none);
  const auto in_path = usable(pairing.i + Index<T>(1));
  score(pairing, Technique::laser, seen,
        {from.weight * from.contribution * way.acceptance * exp_minus(way.optical_depth) /
             (samples_.to_instrument * from.chance),
         path, geometry::depth_of(v.position), in_path.order, in_path.order, Index<T>(0),
         seen_by(way.sight)},
        [&] { complete_by_facet(pairing, v, way); });
}

/// Along a way to a point of the lens.
template <class T>
EdgeToTelescope<T> Connections<T>::edge_to_telescope(const Mask<T>& mask, const Vec3<T>& from,
                                                     const Index<T>& place,
                                                     const instrument::PlanePoint<T>& lens,
                                                     const Index<T>& line,
                                                     const geometry::Sightline<T>& way) const {
  const auto sight = instrument::sight(telescope_, lens, way.arriving);
  EdgeToTelescope<T> edge;
  edge.seen = mask & way.exists & sight.on_detector;
  if (!any(edge.seen)) return edge;
  edge.telescope = seen_by(sight);
  edge.in_water = geometry::along(sea_, way, line, sea_.level(place, geometry::depth_of(from)),
                                  way.length_water);
  edge.path = transport::longer_in_air(telescope_, way, line, lens) +
              transport::path_in_water(sea_, telescope_, way, from, edge.in_water, lens);
  const T solid_angle =
      world_.walks.cone(instrument())
          .solid_angle_outside(gather<T>(sea_.index, line), -way.direction, -way.arriving);
  edge.area = solid_angle * way.area_per_solid_angle / way.index_squared;
  edge.weight =
      way.throughput * (telescope_.area() * sight.cos_off_axis * solid_angle / way.index_squared);
  return edge;
}
/// By an entry through waves.
template <class T>
EdgeToTelescope<T> Connections<T>::edge_to_telescope(const Mask<T>& mask, const EntryEdge<T>& entry,
                                                     const Index<T>& line,
                                                     const medium::Level<T>& from,
                                                     const instrument::PlanePoint<T>& lens) const {
  EdgeToTelescope<T> edge;
  edge.seen = mask & entry.exists;
  edge.telescope = seen_by(instrument::sight(telescope_, lens, -entry.by.outside));
  edge.in_water = entry.in_water(line, from);
  edge.path = entry.by.path + geometry::group_path(sea_, edge.in_water);
  edge.area = entry.area;
  edge.freed = entry.freed;
  edge.weight = entry.weight;
  return edge;
}

template <class T>
void Connections<T>::score_to_telescope(const Pairing<T>& pairing, const Vertex& v,
                                        const geometry::Sightline<T>& way,
                                        const EdgeToTelescope<T>& edge) {
  using std::abs;
  const Index<T> line = back_.line(pairing.back);
  const T path = v.path + edge.path;
  const Mask<T> seen = edge.seen & (path < receiver_.last_path);
  if (!any(seen)) return;
  const T depth = geometry::depth_of(v.position);
  const auto tau = geometry::optical_depths(sea_, edge.in_water);
  const auto& cone = world_.walks.cone(instrument());
  const T reach = cone.reach(Mask<T>(true), tau.walk, way.direction.z, on_bed(v.layer));
  const auto in_path = usable(pairing.i + Index<T>(1));
  const bool elastic = all(line == Index<T>(0));
  const T footprint = edge.freed * edge.area / abs(way.direction.z);
  const T telescope_area =
      elastic ? free_area(instrument(), footprint, line, v.layer, Mask<T>(true), -way.direction.z,
                          -v.direction,
                          density_of(contribution(sea_, scattering_at(sea_, v), way.direction)))
              : free_area(instrument(), footprint, line, v.layer, Mask<T>(false), -way.direction.z,
                          -v.direction, T(1));
  const auto freedom = path_freedom(
      in_path.order, translation_area(world_, telescope_, receiver_.region, way.arriving), depth,
      telescope_area, free_area(laser_, of_laser, pairing.laser));
  const Freedom<T> here{freedom.at_last, axis_at(v.position, way.direction, v.direction)};
  const T behind = behind_laser_vertex(pairing, v, in_path, freedom, here.axis);
  const ConnectionEnd from =
      elastic
          ? scattering_from_laser(sea_, v, behind, way.direction, world_.walks.inverse_conversion,
                                  T(1), here)
          : conversion_from_laser(sea_, v, behind, way.direction, line,
                                  world_.walks.inverse_conversion, Index<T>(0), T(1), T(1), here);
  const T area = samples_.to_instrument * from.chance * edge.area + from.meeting;
  score(pairing, Technique::laser, seen,
        {from.weight * edge.weight *
             balance(from.contribution, area, tau.all, reach, from.densities, EndDensities<T>{}),
         path, depth, in_path.order, in_path.order, Index<T>(0), edge.telescope},
        [&] { complete_to_telescope(pairing, v, way, edge.in_water); });
}

template <class T>
void Connections<T>::to_laser(std::size_t walk) {
  if (!world_.walks.uses.to_laser) return;
  lanes::each_index<T>(back_.vertices(walk), [&](const Index<T>& m, const Mask<T>& mask) {
    tally_.operations.vertex_pairs += count(mask);
    to_laser_.push(mask, pairing_of<T>(walk, Index<T>(0), walk, m),
                   [this](const auto& e, const auto& all) { serve_to_laser(e, all); });
  });
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_to_laser(const Pairing<T>& pairing,
                                                                const Mask<T>& mask) {
  const auto& laser = world_.instruments.laser;
  const Vertex w = back_.in_path(pairing.back, pairing.m, usable(pairing.m + Index<T>(1)));
  Mask<T> wanted = mask & emits(w.line, w.layer);
  if (!sea_.surface.one_direction_each) wanted = wanted & !is_scored_by_facet(pairing);
  const Index<T> line(0);
  if (enters_through_waves(world_.slabs, world_.instruments.laser_region)) {
    const auto own = laser_.entry(pairing.laser);
    for (const bool by_slopes : {false, true}) {
      if (by_slopes && !world_.walks.laser_cone.enters_by_slopes) break;
      const auto entry = entry_to(world_, of_laser, line, w.position, own, {}, by_slopes, wanted);
      const auto way = sightline_along(entry, world_.instruments.laser_region);
      score_to_laser(pairing, w, way, way_to_laser(wanted, w.position, w.layer, way, entry));
    }
    return;
  }
  const Vec3<T> vertex = fictitious_vertex(laser);
  for (const auto route : geometry::routes_to(world_.instruments.laser_region.outside)) {
    // Light that facets of waves send down to a vertex is left to the laser's walks.
    if (!sea_.surface.one_direction_each &&
        geometry::meets_surface(world_.instruments.laser_region, route))
      return;
    const auto way = geometry::sightline(sea_, w.position, line, vertex,
                                         world_.instruments.laser_region, route, wanted);
    score_to_laser(pairing, w, way, way_to_laser(wanted, w.position, w.layer, way));
  }
}

/// By a way that leaves a vertex, or would if light went back.
template <class T>
WayToLaser<T> Connections<T>::way_to_laser(const Mask<T>& mask, const Vec3<T>& from,
                                           const Index<T>& place,
                                           const geometry::Sightline<T>& way) const {
  const auto& laser = world_.instruments.laser;
  const auto& cone = world_.walks.laser_cone;
  const Index<T> line(0);
  const T x = one_minus_cos(-way.arriving, laser.axis);
  // The way from the disc on; the fictitious vertex lies behind it.
  const T hidden = laser.vertex_distance / (T(1) - x);
  const T air = way.to.outside ? longer_from_disc(laser, way.crossing, way.length_air, x) +
                                     way.to.delay(line, way.arriving.z)
                               : T(0);
  const T length = way.to.outside ? way.length_water : way.length_water - hidden;
  WayToLaser<T> out;
  out.in_water =
      geometry::along(sea_, way, line, sea_.level(place, geometry::depth_of(from)), length);
  T counted = length;
  if (any(laser.to_sea > T(0))) [[unlikely]]
    counted =
        longer_from_disc(laser, transport::seen_by_route(from, way.route), way.length_water, x);
  out.path = air + geometry::group_path(sea_, out.in_water, counted);
  out.lit = mask & way.exists & laser.emits(x) & (length > T(0));
  if (!any(out.lit)) return out;
  const auto tau = geometry::optical_depths(sea_, out.in_water);
  const T solid_angle =
      cone.solid_angle_outside(gather<T>(sea_.index, line), -way.direction, -way.arriving);
  out.tau = tau.all;
  out.reach = cone.reach(Mask<T>(true), tau.walk, way.direction.z, on_bed(place));
  out.area = solid_angle * way.area_per_solid_angle / way.index_squared;
  out.weight = way.throughput * solid_angle / (T(2 * pi) * laser.even_within(x));
  return out;
}

/// By an entry through waves.
template <class T>
WayToLaser<T> Connections<T>::way_to_laser(const Mask<T>& mask, const Vec3<T>& from,
                                           const Index<T>& place, const geometry::Sightline<T>& way,
                                           const EntryEdge<T>& entry) const {
  const Index<T> line(0);
  WayToLaser<T> out;
  out.in_water = entry.in_water(line, sea_.level(place, geometry::depth_of(from)));
  out.path = entry.by.path + geometry::group_path(sea_, out.in_water);
  out.lit = mask & entry.exists;
  if (!any(out.lit)) return out;
  const auto tau = geometry::optical_depths(sea_, out.in_water);
  out.tau = tau.all;
  out.reach =
      world_.walks.laser_cone.reach(Mask<T>(true), tau.walk, way.direction.z, on_bed(place));
  out.area = entry.area;
  out.freed = entry.freed;
  out.weight = entry.weight;
  return out;
}

template <class T>
void Connections<T>::score_to_laser(const Pairing<T>& pairing, const Vertex& w,
                                    const geometry::Sightline<T>& way,
                                    const WayToLaser<T>& to_laser) {
  using std::abs;
  const T path = w.path + to_laser.path;
  const Mask<T> lit = to_laser.lit & (path < receiver_.last_path);
  if (!any(lit)) return;
  const auto in_path = usable(pairing.m + Index<T>(1));
  const Mask<T> scatters = w.line == Index<T>(0);
  const T laser_area =
      free_area(of_laser, T(to_laser.freed * to_laser.area / abs(way.direction.z)), Index<T>(0),
                w.layer, scatters, -way.direction.z, -w.direction,
                density_of(contribution(sea_, scattering_at(sea_, w), way.direction)));
  const auto freedom = path_freedom(
      in_path.order, back_.birth_record(pairing.back).translation_area, last_depth(pairing.back),
      free_area(back_, instrument(), pairing.back), laser_area);
  const Freedom<T> here{
      freedom.at(Mask<T>(true), pairing.m == Index<T>(0)),
      select(is_pivot(w.line, pairing.m), axis_at(w.position, w.direction, way.direction),
             back_.axis(pairing.back))};
  const T behind = back_.behind(w, pairing.back, pairing.m, in_path, freedom, here.axis);
  const ConnectionEnd to = arrival_from_laser(sea_, w, behind, way.direction,
                                              world_.walks.inverse_conversion, pairing.m, here);
  const T area = samples_.to_instrument * to.chance * to_laser.area + to.meeting;
  score(pairing, Technique::telescope, lit,
        {to.weight * to_laser.weight *
             balance(to.contribution, area, to_laser.tau, to_laser.reach, EndDensities<T>{},
                     to.densities),
         path, last_depth(pairing.back), in_path.order, Index<T>(0), in_path.order,
         seen_by(pairing.back)},
        [&] { complete_to_laser(pairing, w, way, to_laser.in_water); });
}

template <class T>
void Connections<T>::between(std::size_t walk) {
  if (!world_.walks.uses.between) return;
  lanes::each_index<T>(laser_.vertices(walk), [&](const Index<T>& i, const Mask<T>& mask) {
    const T path = laser_.vertex(Index<T>(walk), i).path;
    for (std::int32_t m = 0; m < back_.vertices(walk); ++m) {
      const Mask<T> may = mask & in_order(i + Index<T>(m + 2)) &
                          (path + back_.vertex_in_all_lanes(walk, m).path < receiver_.last_path);
      if (!any(may)) break;
      tally_.operations.vertex_pairs += count(may);
      between_.push(may, pairing_of<T>(walk, i, walk, Index<T>(m)),
                    [this](const auto& e, const auto& all) { serve_between(e, all); });
    }
  });
}

template <class T>
PHOTIC_APART PHOTIC_FLATTEN void Connections<T>::serve_between(const Pairing<T>& pairing,
                                                               const Mask<T>& mask) {
  const auto in_path = usable(pairing.i + pairing.m + Index<T>(2));
  const Vertex v = laser_.in_path(pairing.laser, pairing.i, in_path);
  const Vertex w = back_.in_path(pairing.back, pairing.m, in_path);
  const Vec3<T> there = w.position - v.position;
  const T length = photic::length(there);
  const Vec3<T> direction = (T(1) / length) * there;
  const T last = last_depth(pairing.back);
  const T translation_area = back_.birth_record(pairing.back).translation_area;
  const Mask<T> first = pairing.i == Index<T>(0), at_last = pairing.m == Index<T>(0);
  const Mask<T> inelastic = w.line > Index<T>(0);
  // By what free walks may be moved if light of a line goes along the edge.
  const auto freedom_of = [&](const Index<T>& line) {
    if (!samples_.frees()) return path_freedom(in_path.order, translation_area, last, T(0), T(0));
    const auto of = [&](const Walks<T>& walks, std::int32_t instrument, const Index<T>& walk,
                        const Vertex& at, const Vec3<T>& leaving, const Mask<T>& scatters,
                        const Mask<T>& ends) {
      const T p = density_of(contribution(sea_, scattering_at(sea_, at), leaving));
      return select(ends,
                    free_area(instrument, walks.free_area(walk).level(), at.line, at.layer,
                              scatters, at.direction.z, leaving, p),
                    free_area(walks, instrument, walk));
    };
    return path_freedom(
        in_path.order, translation_area, last,
        of(back_, instrument(), pairing.back, w, -direction, w.line == line, at_last),
        of(laser_, of_laser, pairing.laser, v, direction, v.line == line, first));
  };
  const Mask<T> arrives = mask & emits(w.line, w.layer);
  if (any(arrives)) {
    const auto freedom = freedom_of(Index<T>(0));
    const auto axis =
        select(is_pivot(w.line, pairing.m), axis_at(w.position, w.direction, direction),
               rotated_with(back_.axis(pairing.back), pairing, Mask<T>(true)));
    const T behind = behind_laser_vertex(pairing, v, in_path, freedom, axis);
    const T behind_arrival = back_.behind(w, pairing.back, pairing.m, in_path, freedom, axis);
    const ConnectionEnd to =
        arrival_from_laser(sea_, w, behind_arrival, -direction, world_.walks.inverse_conversion,
                           pairing.m, {freedom.at(Mask<T>(false), at_last), axis});
    along(pairing, arrives, Index<T>(0),
          scattering_from_laser(sea_, v, behind, direction, world_.walks.inverse_conversion,
                                to.goes_on, {freedom.at(first, Mask<T>(false)), axis}),
          to, v, w, length, in_path);
  }
  const Mask<T> converts = mask & inelastic & emits(w.line, v.layer);
  if (any(converts)) {
    const auto freedom = freedom_of(w.line);
    const auto axis = axis_at(v.position, w.direction, v.direction);
    const T behind = behind_laser_vertex(pairing, v, in_path, freedom, axis);
    const T goes_on =
        T(1) - world_.walks.inverse_conversion.chance(sea_, w.line, w.layer, pairing.m);
    along(pairing, converts, w.line,
          conversion_from_laser(sea_, v, behind, direction, w.line, world_.walks.inverse_conversion,
                                pairing.m + Index<T>(1), w.chance, w.chance * goes_on,
                                {freedom.at(first, Mask<T>(false)), axis}),
          scattering_of_converted(sea_, w, -direction), v, w, length, in_path);
  }
}

template <class T>
void Connections<T>::along(const Pairing<T>& pairing, const Mask<T>& mask, const Index<T>& line,
                           const ConnectionEnd& from, const ConnectionEnd& to, const Vertex& v,
                           const Vertex& w, const T& length, const Usable<T>& usable) {
  const geometry::Segment<T> between{line, geometry::level_of(sea_, v), geometry::level_of(sea_, w),
                                     length};
  const T path = v.path + w.path + geometry::group_path(sea_, between);
  const Mask<T> in_time = mask & (path < receiver_.last_path);
  if (!any(in_time)) return;
  const auto tau = geometry::optical_depths(sea_, between);
  const Index<T> edge = pairing.i + Index<T>(1);
  const T meeting = select(usable.meeting(edge), from.meeting * to.densities.p, T(0)) +
                    select(usable.meeting(edge + Index<T>(1)), to.meeting * from.densities.p, T(0));
  const T area = samples_.between * from.chance * to.chance * length * length + meeting;
  score(pairing, Technique::both, in_time,
        {from.weight * to.weight *
             balance(T(from.contribution * to.contribution), area, tau.all, exp_minus(tau.walk),
                     from.densities, to.densities),
         path, last_depth(pairing.back), usable.order, edge, pairing.m + Index<T>(1),
         seen_by(pairing.back)},
        [&] { complete_between(pairing, v, w, between); });
}

}  // namespace photic::estimator
