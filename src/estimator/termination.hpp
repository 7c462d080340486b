// The ends of a photon's history: time, light too weak to be worth following, too many events.
#pragma once

#include <cmath>
#include <cstdint>

#include "estimator/book.hpp"
#include "estimator/world.hpp"
#include "transport/collide.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

/// Returns whether light from here can still be in a telescope within the last gate.
template <class T>
Mask<T> in_time(const Instruments<T>& instruments, const transport::Photon<T>& photon) {
  Mask<T> in_time(instruments.all_times);
  for (const Deadline<T>& deadline : instruments.deadlines)
    in_time = in_time | deadline.is_met(photon, instruments.min_group_index);
  return in_time;
}

/// Plays Russian roulette with photons that are `on` their way. Returns which go on.
template <class T, class Ledger>
Mask<T> play_roulette(transport::Photon<T>& photon, const T& level, const T& u, const Mask<T>& on,
                      Ledger& ledger) {
  const T weight = photon.weight;
  const Mask<T> survives = transport::roulette(photon, level, u);
  const Mask<T> played = on & !(survives & (photon.weight == weight));
  book(ledger.roulette, played, select(survives, weight - photon.weight, weight));
  return on & survives;
}

}  // namespace photic::estimator
