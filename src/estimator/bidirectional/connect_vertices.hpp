// Connections of vertices: with the telescope, with the laser, with each other (a part of
// connections.hpp).
#pragma once

#include "estimator/bidirectional/connections.hpp"

namespace photic::estimator {

template <class T>
void Connections<T>::to_telescope(std::size_t walk) {
  lanes::each_index<T>(laser_.vertices(walk), [&](const Index<T>& i, const Mask<T>& mask) {
    to_telescope_.push(mask, pairing_of<T>(walk, i, walk, Index<T>(0)),
                       [this](const auto& e, const auto& all) { serve_to_telescope(e, all); });
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_to_telescope(const Pairing<T>& pairing,
                                                       const Mask<T>& mask) {
  const Index<T> line = back_.line(pairing.back);
  const auto birth = back_.birth_record(pairing.back);
  const Vec3<T> at = in_space(telescope_, birth.lens);
  const auto in_path = usable(pairing.i + Index<T>(1));
  const Vertex v = laser_.in_path(pairing.laser, pairing.i, in_path);
  const Mask<T> wanted = mask & emits(line, v.layer);
  const Mask<T> near_view =
      wanted & transport::may_see(sea_, telescope_, v.position, line, birth.lens);
  if (!any(near_view)) return;
  for (const auto route : geometry::routes_to(receiver_.region.in_air))
    by_sightline(
        pairing, near_view, v, birth,
        geometry::sightline(sea_, v.position, line, at, receiver_.region, route, near_view));
}

template <class T>
void Connections<T>::by_sightline(const Pairing<T>& pairing, const Mask<T>& mask, const Vertex& v,
                                  const BirthRecord<T>& birth, const geometry::Sightline<T>& way) {
  const Index<T> line = back_.line(pairing.back);
  const auto sight = instrument::sight(telescope_, birth.lens, way.arriving);
  const T path = v.path + transport::longer_in_air(telescope_, way, birth.lens) +
                 way.length_water * gather<T>(sea_.group_index, line);
  const Mask<T> seen = mask & way.exists & sight.on_detector & (path < receiver_.last_path);
  if (!any(seen)) return;
  const T depth = -v.position.z;
  const auto tau = depths_along(sea_, way, line, v.layer, depth, way.length_water);
  const T solid_angle = detector_solid_angle(telescope_, sight.cos_off_axis);
  const T etendue = telescope_.area() * sight.cos_off_axis * solid_angle / way.index_squared;
  const auto in_path = usable(pairing.i + Index<T>(1));
  const Freedom<T> freedom{
      translations_in(in_path.order, instrument::translation_area(telescope_, way.arriving)),
      axis_at(v.position, way.direction, v.direction)};
  const T behind = behind_laser_vertex(pairing, v, in_path, freedom_before(depth, freedom));
  const ConnectionEnd from =
      all(line == Index<T>(0))
          ? scattering_from_laser(sea_, v, behind, way.direction, world_.inverse_conversion, T(1),
                                  freedom)
          : conversion_from_laser(sea_, v, behind, way.direction, line, world_.inverse_conversion,
                                  T(1), T(1), freedom);
  const T area = samples_.to_instrument * from.chance * solid_angle * way.area_per_solid_angle /
                     way.index_squared +
                 from.meeting;
  if (world_.compares) [[unlikely]]
    complete_to_telescope(pairing, v, way);
  score(pairing, Walked::laser, seen,
        {from.weight * way.throughput * etendue *
             balance(area, tau.all, tau.walk, from.densities, EndDensities<T>{}),
         path, depth, in_path.order, in_path.order, Index<T>(0)});
}

template <class T>
void Connections<T>::to_laser(std::size_t walk) {
  lanes::each_index<T>(back_.vertices(walk), [&](const Index<T>& m, const Mask<T>& mask) {
    to_laser_.push(mask, pairing_of<T>(walk, Index<T>(0), walk, m),
                   [this](const auto& e, const auto& all) { serve_to_laser(e, all); });
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_to_laser(const Pairing<T>& pairing, const Mask<T>& mask) {
  const auto& laser = world_.laser;
  if (!any(connectable_solid_angle(laser) > T(0))) return;
  const Vec3<T> vertex = fictitious_vertex(laser);
  const Vertex w = back_.in_path(pairing.back, pairing.m, usable(pairing.m + Index<T>(1)));
  const Mask<T> wanted = mask & emits(w.line, w.layer);
  const Index<T> line(0);
  for (const auto route : geometry::routes_to(world_.laser_region.in_air))
    by_sightline_to_laser(
        pairing, wanted, w,
        geometry::sightline(sea_, w.position, line, vertex, world_.laser_region, route, wanted));
}

template <class T>
void Connections<T>::by_sightline_to_laser(const Pairing<T>& pairing, const Mask<T>& mask,
                                           const Vertex& w, const geometry::Sightline<T>& way) {
  const auto& laser = world_.laser;
  const Vec3<T> leaving = -way.arriving;
  const T x = one_minus_cos(leaving, laser.axis);
  const Mask<T> in_cone = x < laser.one_minus_cos_divergence;
  Mask<T> lit = mask & way.exists & in_cone;
  if (!any(lit)) return;
  // The way from the disc on; the fictitious vertex lies behind it.
  const T hidden = laser.vertex_distance / (T(1) - x);
  const Vec3<T> vertex = fictitious_vertex(laser);
  const T longer = longer_by(vertex, -way.crossing, length(vertex) + way.length_air);
  const T air = way.to.in_air ? longer + laser.vertex_detour - x * hidden : T(0);
  const T water = way.to.in_air ? way.length_water : way.length_water - hidden;
  const Index<T> line(0);
  const T path = w.path + air + water * gather<T>(sea_.group_index, line);
  lit = lit & (water > T(0)) & (path < receiver_.last_path);
  if (!any(lit)) return;
  const auto tau = depths_along(sea_, way, line, w.layer, T(-w.position.z), water);
  const Index<T> order = pairing.m + Index<T>(1);
  const Freedom<T> freedom{
      translations_in(order, back_.birth_record(pairing.back).translation_area),
      select(is_pivot(w.line, pairing.m), axis_at(w.position, w.direction, way.direction),
             back_.axis(pairing.back))};
  const ConnectionEnd to =
      arrival_from_laser(sea_, w, way.direction, world_.inverse_conversion, freedom);
  const T solid_angle = connectable_solid_angle(laser);
  const T area = samples_.to_instrument * to.chance * solid_angle * way.area_per_solid_angle /
                     way.index_squared +
                 to.meeting;
  if (world_.compares) [[unlikely]]
    complete_to_laser(pairing, w, way, water);
  score(pairing, Walked::telescope, lit,
        {to.weight * way.throughput *
             balance(area, tau.all, tau.walk, EndDensities<T>{}, to.densities),
         path, last_depth(pairing.back), order, Index<T>(0), order});
}

template <class T>
void Connections<T>::between(std::size_t walk) {
  lanes::each_index<T>(laser_.vertices(walk), [&](const Index<T>& i, const Mask<T>& mask) {
    const T path = laser_.vertex(Index<T>(walk), i).path;
    for (std::int32_t m = 0; m < back_.vertices(walk); ++m) {
      const Mask<T> may = mask & in_order(i + Index<T>(m + 2)) &
                          (path + back_.vertex_in_all_lanes(walk, m).path < receiver_.last_path);
      if (!any(may)) break;
      between_.push(may, pairing_of<T>(walk, i, walk, Index<T>(m)),
                    [this](const auto& e, const auto& all) { serve_between(e, all); });
    }
  });
}

template <class T>
PHOTIC_FLATTEN void Connections<T>::serve_between(const Pairing<T>& pairing, const Mask<T>& mask) {
  const auto in_path = usable(pairing.i + pairing.m + Index<T>(2));
  const Vertex v = laser_.in_path(pairing.laser, pairing.i, in_path);
  const Vertex w = back_.in_path(pairing.back, pairing.m, in_path);
  const Vec3<T> there = w.position - v.position;
  const T length = photic::length(there);
  const Vec3<T> direction = (T(1) / length) * there;
  const T translations =
      translations_in(in_path.order, back_.birth_record(pairing.back).translation_area);
  const T last = last_depth(pairing.back);
  const Mask<T> inelastic = w.line > Index<T>(0);
  const Mask<T> arrives = mask & emits(w.line, w.layer);
  if (any(arrives)) {
    const Freedom<T> freedom{translations, select(is_pivot(w.line, pairing.m),
                                                  axis_at(w.position, w.direction, direction),
                                                  back_.axis(pairing.back))};
    const auto before = freedom_before(last, freedom);
    const T behind = behind_laser_vertex(pairing, v, in_path, before);
    const ConnectionEnd to =
        arrival_from_laser(sea_, w, -direction, world_.inverse_conversion, freedom);
    along(pairing, arrives, Index<T>(0),
          scattering_from_laser(sea_, v, behind, direction, world_.inverse_conversion, to.goes_on,
                                before),
          to, v, w, length, in_path);
  }
  const Mask<T> converts = mask & inelastic & emits(w.line, v.layer);
  if (any(converts)) {
    const auto freedom = freedom_before(
        last, Freedom<T>{translations, axis_at(v.position, w.direction, v.direction)});
    const T behind = behind_laser_vertex(pairing, v, in_path, freedom);
    const T goes_on = T(1) - world_.inverse_conversion.chance(sea_, w.line, w.layer);
    along(pairing, converts, w.line,
          conversion_from_laser(sea_, v, behind, direction, w.line, world_.inverse_conversion,
                                w.chance, w.chance * goes_on, freedom),
          scattering_of_converted(sea_, w, -direction), v, w, length, in_path);
  }
}

template <class T>
void Connections<T>::along(const Pairing<T>& pairing, const Mask<T>& mask, const Index<T>& line,
                           const ConnectionEnd& from, const ConnectionEnd& to, const Vertex& v,
                           const Vertex& w, const T& length, const Usable<T>& usable) {
  const T path = v.path + w.path + length * gather<T>(sea_.group_index, line);
  const Mask<T> in_time = mask & (path < receiver_.last_path);
  if (!any(in_time)) return;
  const auto tau = geometry::depths_between(sea_, line, geometry::level_of(sea_, v),
                                            geometry::level_of(sea_, w), length);
  const Index<T> edge = pairing.i + Index<T>(1);
  const T meeting = select(usable.meeting(edge), from.meeting * to.densities.p, T(0)) +
                    select(usable.meeting(edge + Index<T>(1)), to.meeting * from.densities.p, T(0));
  const T area = samples_.between * from.chance * to.chance * length * length + meeting;
  if (world_.compares) [[unlikely]]
    complete_between(pairing, line, v, w, length);
  score(pairing, Walked::both, in_time,
        {from.weight * to.weight * balance(area, tau.all, tau.walk, from.densities, to.densities),
         path, last_depth(pairing.back), usable.order, edge, pairing.m + Index<T>(1)});
}

}  // namespace photic::estimator
