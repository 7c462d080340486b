// The surface's own echo: light that has not been in the water. The bidirectional estimator's walks
// leave it to the forward one. Where a film of oil shines, histories beside the walks score it
// (plan.hpp).
#pragma once

#include <cstdint>

#include "estimator/draws.hpp"
#include "estimator/forward/history.hpp"
#include "transport/cross.hpp"

namespace photic::estimator {

/// Photons of a laser in the water that rise come to the surface, but for what is lost on the way.
template <class Events, class T, class Ledger>
void rise_to_surface(const World<T>& world, ForwardTracks<T>& t, Estimates<T>& estimates,
                     tally::BatchTally& tally, Ledger& ledger) {
  if (has_environments<Events>(world)) t.ratios.before = t.photon;
  const auto up = transport::come_up(world.sea, t.photon);
  const Mask<T> rises = t.on & up.rises;
  if (!any(rises)) return;
  if (has_environments<Events>(world)) t.ratios.flown(world.sea, t.photon, up.length, rises);
  cross_waves<Events>(world, t, rises, false, estimates, tally, ledger, {});
}

/// Scores the echo of photons `first` … `first + count - 1` of a batch over waves; nothing else of
/// them counts.
template <class Ledger, class T>
PHOTIC_APART void surface_echo(const World<T>& world, std::uint64_t first, std::uint64_t count,
                               tally::BatchTally& tally) {
  const Draws<T> draws = draws_of_laser(world, first);
  ForwardTracks<T> t(world);
  Estimates<T> estimates(world);
  PathRatios<T> paths(world.sea.environments, lanes_of<T>);
  t.ratios.paths = &paths;
  Ledger not_counted;
  for (std::uint64_t n = 0; n < count; n += lanes_of<T>) {
    const Mask<T> exist = first_lanes<T>(count - n);
    const auto number = static_cast<std::int32_t>(n);
    if (world.has_environments) {
      for (std::size_t k = 0; k < lanes_of<T>; ++k) paths.of(k).begin(world.sea.environments);
      birth<AllEvents>(world, draws, number, exist, t, estimates, tally, not_counted);
      if (!world.laser_region.in_air)
        rise_to_surface<AllEvents>(world, t, estimates, tally, not_counted);
    } else {
      birth<PlainEvents>(world, draws, number, exist, t, estimates, tally, not_counted);
      if (!world.laser_region.in_air)
        rise_to_surface<PlainEvents>(world, t, estimates, tally, not_counted);
    }
  }
  flush_queues(world, estimates, tally);
}

}  // namespace photic::estimator
