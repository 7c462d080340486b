// The surface's own echo: light that has not been in the water. The bidirectional estimator's walks
// leave it to the forward one. Where a film of oil shines, histories beside the walks score it
// (plan.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "estimator/draws.hpp"
#include "estimator/forward/history.hpp"
#include "transport/cross.hpp"

namespace photic::estimator {

/// Photons of a laser in the water that rise come to the surface, but for what is lost on the way.
template <class Events, class T, class Ledger>
void rise_to_surface(const World<T>& world, ForwardTracks<T>& t, Estimates<T>& estimates,
                     tally::BatchTally& tally, Ledger& ledger) {
  const auto companions = companions_of<Events>(world, t);
  companions.before(t.photon);
  const auto up = transport::come_up(world.slabs, t.photon);
  const Mask<T> rises = t.on & up.rises;
  if (!any(rises)) return;
  companions.flown(t.photon, up.way.length, rises);
  cross_surface<Events>(world, t, rises, false, estimates, tally, ledger, {});
}

/// Scores the echo of photons `first` … `first + count - 1` of a batch. A witness is called with
/// those that it has been scored of.
template <class Events, class Ledger, class T, class Witness>
void echo_of_surface(const World<T>& world, std::uint64_t first, std::uint64_t count,
                     tally::BatchTally& tally, const Witness& witness) {
  const Draws<T> draws = draws_of_laser<T>(world.random, first);
  std::vector<instrument::PlanePoint<T>> lens(lens_points(world));
  ForwardTracks<T> t(world, lens);
  Estimates<T> estimates(world);
  PathRatios<T> paths(world.slabs.environments, lanes_of<T>);
  t.ratios.paths = &paths;
  Ledger not_counted;
  for (std::uint64_t n = 0; n < count; n += lanes_of<T>) {
    for (std::size_t k = 0; k < lanes_of<T>; ++k) paths.begin(world.slabs.environments, k);
    birth<Events>(world, draws, static_cast<std::int32_t>(n), first_lanes<T>(count - n), t,
                  estimates, tally, not_counted, {});
    if (!world.instruments.laser_region.outside)
      rise_to_surface<Events>(world, t, estimates, tally, not_counted);
    witness(t);
  }
  flush_queues(world, estimates, tally);
}
/// The same by the events that the world asks for. Nothing else of the photons counts.
template <class Ledger, class T, class Witness>
PHOTIC_APART void surface_echo(const World<T>& world, std::uint64_t first, std::uint64_t count,
                               tally::BatchTally& tally, const Witness& witness) {
  if (world.all_events)
    echo_of_surface<AllEvents, Ledger>(world, first, count, tally, witness);
  else
    echo_of_surface<PlainEvents, Ledger>(world, first, count, tally, witness);
}

}  // namespace photic::estimator
