// The expected scores of a photon's next collision before it flies: at further points of its free
// paths, and of conversions in the telescopes' views. Its history stays the same.
#pragma once

#include "estimator/forward/estimate.hpp"
#include "estimator/forward/forced.hpp"
#include "estimator/termination.hpp"
#include "transport/flight.hpp"

namespace photic::estimator {

/// Light that is scored ahead of photons, where they may get to on their flight: its ratios.
template <class Events, class T>
void ratios_at(const World<T>& world, const ForwardTracks<T>& from, const transport::Photon<T>& at,
               const T& moved, Estimates<T>& estimates) {
  if (!has_environments<Events>(world)) return;
  const transport::Photon<T>& before = from.photon;
  estimates.begin(from.ratios);
  add_segment(
      world.slabs,
      {at.line, geometry::level_of(world.slabs, before), geometry::level_of(world.slabs, at), moved,
       geometry::Ray<T>{before.position, before.direction}},
      estimates.unflown);
}

/// The number that a flight's free path is drawn by. A free path -ln(u) leaves the water where u is
/// below the chance of that.
template <class Events, class T>
T path_number(const ForwardTracks<T>& tracks, const T& u) {
  if constexpr (Events::tools) {
    return select(tracks.stays == T(1), u, T(1) - (T(1) - u) * tracks.stays);
  } else {
    return u;
  }
}

/// Scores what the telescopes expect of photons' next collision, where it might be as well: at
/// further points that are as far apart as can be among the free paths, the flight's own being the
/// last of them (docs/theory.md, eq. 77).
template <class Events, class T>
void score_further_points(const World<T>& world, const ForwardTracks<T>& tracks,
                          Estimates<T>& estimates, tally::BatchTally& tally) {
  const Mask<T> travelling = who_are_scored(world, tracks, tracks.on);
  if (!any(travelling)) return;
  const auto from = transport::flight_start(world.slabs, tracks.photon);
  for (std::int32_t k = 1; k < world.forward.scored_points; ++k) {
    const T rest = T(static_cast<double>(k) / world.forward.scored_points);
    const T& u = tracks.u[0];
    const T u_k = select(u > rest, u - rest, u + (T(1) - rest));
    transport::Photon<T> at = tracks.photon;
    const T free_path = minus_log(path_number<Events>(tracks, u_k));
    auto end = transport::fly(world.slabs, at, from, free_path);
    if (!Events::tools && world.forward.flies_on) {
      transport::fly_on(world.slabs, at, end, [&](const Mask<T>&, transport::Photon<T>& down) {
        transport::reflect_down(world.slabs, down);
      });
    }
    const Mask<T> scored =
        travelling & !(end.surface | end.sea_bed | end.sideways) & in_time(world.instruments, at);
    if (!any(scored)) continue;
    ratios_at<Events>(world, tracks, at, end.length, estimates);
    score_light<Events>(world, tracks, at, weight_at_point(world.forward, at), scored, at.line,
                        estimates, tally);
  }
}

/// Scores what the telescopes expect of the conversions on photons' way to their next collision; of
/// all their collisions, if these are not scored where they happen.
template <class Events, class T>
PHOTIC_APART PHOTIC_FLATTEN void score_on_the_way(const World<T>& world,
                                                  const ForwardTracks<T>& from,
                                                  const Mask<T>& travelling,
                                                  Estimates<T>& estimates,
                                                  tally::BatchTally& tally) {
  const geometry::Slabs& sea = world.slabs;
  const Mask<T> convertible = travelling & (from.photon.line == Index<T>(0));
  const bool all_collisions = Events::tools && world.forward.tools.scores_on_the_way;
  const Mask<T> wanted = all_collisions ? travelling : convertible;
  if (!any(wanted)) return;
  const auto& u = from.forced;
  transport::Photon<T> at = from.photon;
  const auto [in_water, moved] = force_collision(sea, at, world.forward.cones, {u[0], u[1], u[2]});
  const Mask<T> reached = wanted & in_water;
  ratios_at<Events>(world, from, at, moved, estimates);
  if (all_collisions)
    score_light<Events>(world, from, at, at.weight, reached, at.line, estimates, tally);
  const Index<T> count = gather_index<T>(sea.convertible_count, at.layer);
  const Mask<T> converting = reached & convertible;
  Index<T> i(0);
  for (Mask<T> on = converting & (i < count); any(on); on = converting & (i < count)) {
    const Index<T> line =
        sea.emitted_line<T>(at.layer, select(on, i, Index<T>(0)), from.spectral_bin);
    score_light<Events>(world, from, at, at.weight, on, line, estimates, tally);
    i = i + Index<T>(1);
  }
}

}  // namespace photic::estimator
