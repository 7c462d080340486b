// The surface's own echo, of light that has not been in the water. The bidirectional estimator's
// walks leave it to the forward one. Where a film of oil shines, histories beside the walks score
// it (beside_walks.hpp).
#pragma once

#include <cstdint>

#include "estimator/draws.hpp"
#include "estimator/forward/history.hpp"

namespace photic::estimator {

/// Of photons `first` … `first + count - 1` of a batch, if there are waves; nothing else of them
/// counts.
template <class Ledger, class T>
PHOTIC_APART void surface_echo(const World<T>& world, std::uint64_t first, std::uint64_t count,
                               tally::BatchTally& tally) {
  if (!world.sea.waves.rough) return;
  const Draws<T> draws = draws_of_laser(world, first);
  Travellers<T> t(world);
  Estimates<T> estimates(world);
  PathRatios<T> paths(world.sea.environments, lanes_of<T>);
  t.ratios.paths = &paths;
  Ledger not_counted;
  for (std::uint64_t n = 0; n < count; n += lanes_of<T>) {
    const Mask<T> exist = first_lanes<T>(count - n);
    const auto number = static_cast<std::int32_t>(n);
    if (world.compares) {
      for (std::size_t k = 0; k < lanes_of<T>; ++k) paths.of(k).begin(world.sea.environments);
      birth<AllEvents>(world, draws, number, exist, t, estimates, tally, not_counted);
    } else {
      birth<PlainEvents>(world, draws, number, exist, t, estimates, tally, not_counted);
    }
  }
  flush_queues(world, estimates, tally);
}

}  // namespace photic::estimator
