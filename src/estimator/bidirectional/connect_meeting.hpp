// The score of two rays that meet (a part of connections.hpp).
#pragma once

#include "estimator/bidirectional/connections.hpp"
#include "estimator/bidirectional/surface_entry.hpp"

namespace photic::estimator {

/// `first`, `last`: the rays leave the laser, the telescope. `p`: the density there.
template <class T>
MeetingPoint<T> Connections<T>::meeting_point(const Met<T>& met, const Mask<T>& first,
                                              const Mask<T>& last, const T& depth,
                                              const Index<T>& place, const T& p) const {
  const Ray &out = *met.out, &back = *met.back;
  const Index<T> line = back.line;
  const Index<T> here = sea_.at(line, place);
  MeetingPoint<T> at;
  at.length_out = out.length_to(depth);
  at.length_back = back.length_to(depth);
  at.bed = on_bed(place);
  const auto level = sea_.level(place, depth);
  const auto tau_out = depths_along(sea_, out, level, at.length_out);
  const auto tau_back = depths_along(sea_, back, level, at.length_back);
  at.tau = tau_out.all + tau_back.all;
  at.reach_out = world_.walks.laser_cone.reach(first, tau_out.walk, out.direction.z, at.bed);
  at.reach_back =
      world_.walks.cone(instrument()).reach(last, tau_back.walk, back.direction.z, at.bed);
  at.converts = line > Index<T>(0);
  at.coefficient =
      select(at.converts, gather<T>(sea_.conversion, here) * gather<T>(sea_.c.first, place),
             transport::scattered_share(sea_, line, place, T(-out.direction.z)) *
                 gather<T>(sea_.c.first, here)) *
      gather<T>(sea_.walk_mean_path, here);
  at.p = p;
  at.path = out.path + back.path + path_along(sea_, out, level, at.length_out) +
            path_along(sea_, back, level, at.length_back);
  return at;
}

/// `last`: depth of the path's last vertex.
template <class T>
PathFreedom<T> Connections<T>::freedom_at(const RayPairing<T>& pairing, const Met<T>& met,
                                          const MeetingPoint<T>& at, const T& last,
                                          const Index<T>& place) const {
  using std::abs;
  T of_telescope(0), of_laser(0);
  if (samples_.frees()) {
    const auto footprint = [&](const Spread<T>& spread, const Ray& ray, const T& length) {
      return spread.solid_angle * spread.freed *
             area_per_solid_angle(sea_, spread, ray.line, length, T(abs(ray.direction.z))) /
             abs(ray.direction.z);
    };
    const auto area = [&](std::int32_t instrument, const Mask<T>& here, const FreeArea<T>& first,
                          const Spread<T>& spread, const Ray& ray, const T& length,
                          const Vec3<T>& leaving) {
      if (!frees(instrument)) return T(0);
      if (!any(here)) return first.area();
      return select(here,
                    free_area(instrument, footprint(spread, ray, length), met.back->line, place,
                              !at.converts, ray.direction.z, leaving, at.p),
                    first.area());
    };
    of_telescope = area(instrument(), pairing.m == Index<T>(0), met.back_free, met.back_spread,
                        *met.back, at.length_back, -met.out->direction);
    of_laser = area(photic::estimator::of_laser, pairing.i == Index<T>(0), met.out_free,
                    met.out_spread, *met.out, at.length_out, -met.back->direction);
  }
  return path_freedom(pairing.order(), met.translation_area, last, of_telescope, of_laser);
}

/// The rays from instruments of those that meet there may also be connected by entries that slopes
/// draw.
template <class T>
PHOTIC_APART void Connections<T>::meet_under_waves(const RayPairing<T>& pairing,
                                                   const Mask<T>& mask, Met<T> met, const T& depth,
                                                   const Index<T>& place, const T& contribution) {
  tally_.operations.meetings_by_waves += count(mask);
  const Ray& out = *met.out;
  const Vec3<T> where = out.position + out.length_to(depth) * out.direction;
  const auto enter = [&](const Mask<T>& first, std::int32_t instrument, const Index<T>& line,
                         const SurfaceEntry<T>& entry, Spread<T>& spread) {
    if (!any(first)) return;
    const T ratio =
        slopes_over_rays(world_, instrument, line, where, entry, met.lens, Mask<T>(mask & first));
    spread = spread_by_entries(select(first, ratio, T(0)), spread);
  };
  enter(pairing.i == Index<T>(0), of_laser, Index<T>(0), laser_.entry(pairing.laser),
        met.out_spread);
  enter(pairing.m == Index<T>(0), instrument(), met.back->line, entry_of(pairing.back, met),
        met.back_spread);
  const Mask<T> scored = mask & !is_scored_by_facet(pairing);
  if (any(scored)) meet_there(pairing, scored, met, depth, place, contribution);
}

template <class T>
void Connections<T>::meet_at(const RayPairing<T>& pairing, const Mask<T>& mask, const Met<T>& met,
                             const T& depth, const Index<T>& place) {
  const Ray &out = *met.out, &back = *met.back;
  const Mask<T> emitting = mask & emits(back.line, place);
  if (!any(emitting)) return;
  tally_.operations.meetings += count(emitting);
  const T of_vertex = contribution(
      sea_, interaction_at<T>(sea_, back.line > Index<T>(0), back.line, place, out.direction),
      -back.direction);
  if (!sea_.surface.one_direction_each)
    return meet_under_waves(pairing, emitting, met, depth, place, of_vertex);
  meet_there(pairing, emitting, met, depth, place, of_vertex);
}

template <class T>
void Connections<T>::meet_there(const RayPairing<T>& pairing, const Mask<T>& mask,
                                const Met<T>& met, const T& depth, const Index<T>& place,
                                const T& contribution) {
  const Ray &out = *met.out, &back = *met.back;
  const auto in_path = usable(pairing.order());
  const Mask<T> is_first = pairing.i == Index<T>(0), is_last = pairing.m == Index<T>(0);
  const auto at = meeting_point(met, is_first, is_last, depth, place, density_of(contribution));
  const T last = select(is_last, depth, last_depth(pairing.back));
  const auto freedom = freedom_at(pairing, met, at, last, place);
  const Vec3<T> where = out.position + at.length_out * out.direction;
  const RotationAxis<T> axis =
      select(is_pivot(back.line, pairing.m), axis_at(where, back.direction, out.direction),
             rotated_with(met.axis, pairing, pairing.reflects_telescope()));
  RotationAxis<T> axis_of_laser = axis;
  if (!sea_.surface.isotropic)
    axis_of_laser.exists = axis_of_laser.exists & !pairing.reflects_laser();
  axis_of_laser.x = axis.x - met.out_moved.x;
  axis_of_laser.y = axis.y - met.out_moved.y;
  auto laser_side = laser_.side(out, met.out_spread, pairing.laser, pairing.i, in_path, freedom,
                                axis_of_laser, met.out_near, T(1), false, met.out_rotated);
  auto side = back_.side(back, met.back_spread, pairing.back, pairing.m, in_path, freedom,
                         met.own_axis, met.back_near, met.rest, met.rotates_anew);
  laser_side.straight = !pairing.reflects_laser();
  side.straight = !pairing.reflects_telescope();

  // Densities of the strategies, each times p and both rays' chances: meeting here, connecting
  // either ray's edge, meeting where either ray begins, all behind them.
  using std::abs;
  const T both = out.direction.z * back.direction.z;
  const T steep = select(reverses(out, back) | at.converts, T(abs(both)), T(0));
  const T jacobian = rotation_jacobian(where, out.direction, back.direction).about(axis);
  const T translations = freedom.at(is_first, is_last);
  T moved = translations * steep + samples_.rotated * T(2 * pi) * jacobian;
  T out_over_back(1);  // ratio of p of the laser's edge to that of the telescope's, on the bed
  if (sea_.bed_angles > 0) {
    moved = select(at.bed, translations * T(-samples_.grid.below_bed()) * back.direction.z, moved);
    out_over_back = select(at.bed, back.direction.z / out.direction.z, T(1));
  }
  const T here_met =
      moved * back.chance * gather<T>(sea_.walk_mean_path, sea_.at(back.line, place));
  const T connected = back.chance * out_over_back *
                          laser_side.connecting(sea_, at.length_out, samples_) * at.reach_back +
                      walk_c_ratio<T>(sea_, back.line, place) *
                          side.connecting(sea_, at.length_back, samples_) * at.reach_out;
  const T goes_on =
      back.chance * world_.walks.inverse_conversion.goes_on(sea_, back.line, place, pairing.m,
                                                            at.converts, -out.direction, at.p);
  // Walks that meet where a ray begins that facets have sent back do not come by what is behind.
  T by_out = at.reach_back, by_back = at.reach_out;
  if (!sea_.surface.one_direction_each) {
    by_out = by_out * select(laser_side.straight, T(1), at.reach_out);
    by_back = by_back * select(side.straight, T(1), at.reach_back);
  }
  const T next = goes_on * laser_side.meeting * by_out + side.meeting * by_back;
  const T behind = at.reach_out * at.reach_back * (goes_on * laser_side.behind + side.behind);
  const T value = balance(T(out.weight * back.weight * at.coefficient * contribution), at.tau,
                          MeetingDensities<T>{at.p, here_met + connected, next, behind});
  score(pairing, Technique::both, mask & (at.path < receiver_.last_path),
        {met.gain * value, at.path, last, in_path.order, pairing.i, pairing.m, met.telescope,
         at.bed, met.free},
        [&] { complete_by_meeting(pairing, met, depth, place); });
}

}  // namespace photic::estimator
