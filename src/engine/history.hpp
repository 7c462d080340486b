// One history, as the physics tells it: for one photon, or for one in each lane.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/flatten.hpp"
#include "core/random.hpp"
#include "engine/analog.hpp"
#include "engine/book.hpp"
#include "engine/ends.hpp"
#include "engine/estimate.hpp"
#include "engine/tools.hpp"
#include "engine/world.hpp"
#include "transport/collide.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"
#include "transport/scatter.hpp"

namespace photic::engine {

/// The photons of a mask on the laser's disc, and on into the water. Tells which get there.
template <class T, class Ledger>
Mask<T> set_out(const World<T>& world, const Counter<T>& number, const Mask<T>& exist,
                Travellers<T>& travellers, Ledger& ledger) {
  using namespace transport;
  travellers.place.photon = number;
  travellers.place.event = Index<T>(0);
  travellers.lens.resize(world.single_rays ? world.telescopes.size() : 0);
  for (std::size_t t = 0; t < travellers.lens.size(); ++t)
    travellers.lens[t] = chosen_lens_point(world, number, t);

  const auto u = uniforms(travellers.place, 0);
  travellers.hue = medium::hue_of(u[3]);
  Photon<T>& photon = travellers.photon;
  photon = emit(world.laser, world.laser_layer, u[0], u[1]);
  if (world.laser.submerged) return exist;
  const T in_air = photon.weight;
  const Mask<T> entered = enter_water(world.sea, photon);
  book(ledger.escaped, exist, select(entered, in_air - photon.weight, in_air));
  if (world.analog) [[unlikely]]
    return enter_by_chance(photon, exist & entered, u[2], ledger);
  return exist & entered;
}

/// What becomes of photons that collide where they stand: they are scored, and go on in another
/// direction, at another wavelength, or not.
template <bool special, class T, class Ledger>
void collision(const World<T>& world, Travellers<T>& travellers, const std::array<T, 4>& u,
               Mask<T>& colliding, Ledger& ledger, tally::BatchTally& tally,
               Estimates<T>& estimates) {
  using namespace transport;
  Photon<T>& photon = travellers.photon;
  const Mask<T> scored = colliding & Mask<T>(!(special && world.tools.scores_on_the_way));
  score_scattering<special>(world, travellers, scored, estimates, tally);
  if (world.last_order > 0) {
    const Mask<T> last = colliding & (photon.order + Index<T>(1) == Index<T>(world.last_order));
    book(ledger.cut_by_order, last, photon.weight);
    colliding = colliding & !last;
  }
  const Index<T> here = world.sea.at(photon.line, photon.layer);
  book(ledger.absorbed, colliding, photon.weight * gather<T>(world.sea.absorption, here));
  if (compares<special>(world)) travellers.ratios.before = photon;
  const auto v = world.makes_choices ? more_uniforms(travellers.place, 1) : std::array<T, 4>{};
  const auto branch = collide(world.sea, photon, travellers.hue, world.conversion, v[0], v[1]);
  scatter(world.sea, photon, branch.phase, branch.lobe, estimates.targets, world.directed,
          {u[1], u[2], v[2], v[3]});
  if (compares<special>(world)) travellers.ratios.collided(world.sea, photon, colliding);
}

/// As next_event, of the forward estimator: with tools and environments, or with none.
template <bool special, class T, class Ledger>
Mask<T> forward_event(const World<T>& world, Travellers<T>& travellers, Mask<T> on, Ledger& ledger,
                      tally::BatchTally& tally, Estimates<T>& estimates) {
  using namespace transport;
  Photon<T>& photon = travellers.photon;
  travellers.place.event = travellers.place.event + Index<T>(1);
  const auto u = uniforms(travellers.place, 0);
  if (!world.cones.empty()) score_on_the_way<special>(world, travellers, on, estimates, tally);
  T u_path = u[0];
  if constexpr (special) u_path = begin_with_tools(world, travellers, on, u_path, ledger);
  if (compares<special>(world)) travellers.ratios.before = photon;
  const FlightEnd<T> end = fly(world.sea, photon, u_path);
  if (compares<special>(world)) travellers.ratios.flown(world.sea, photon, end.length, on);
  book(ledger.sea_bed, on & end.sea_bed, photon.weight);
  on = on & !end.sea_bed;
  const Mask<T> late = on & !in_time(world, photon);
  book(ledger.cut_by_time, late, photon.weight);
  on = on & !late;

  const Mask<T> reflected = on & end.surface;
  Mask<T> colliding = on & !end.surface;
  Photon<T> down;
  if (any(reflected)) {
    down = photon;
    const Mask<T> kept = special ? are_forced(world, travellers.place) : Mask<T>(false);
    book(ledger.escaped, reflected, reflect_down(world.sea, down, kept));
  }
  if (any(colliding)) {
    tally.collisions += count(colliding);
    collision<special>(world, travellers, u, colliding, ledger, tally, estimates);
  }
  if (any(reflected)) photon = select(reflected, down, photon);
  on = reflected | colliding;

  if constexpr (special)
    on = end_with_tools(world, travellers, on, u[3], ledger);
  else
    on = play_roulette(photon, world.weight_threshold, u[3], on, ledger);
  const Mask<T> finite = photon.weight <= T(std::numeric_limits<Element<T>>::max());
  const Mask<T> fresh = travellers.place.event < Index<T>(most_events);
  if (!any(on & !(finite & fresh))) return on;
  tally.not_finite += count(on & !finite);
  const Mask<T> worn = on & finite & !fresh;
  tally.too_many_events += count(worn);
  book(ledger.lost, worn, photon.weight);
  return on & finite & fresh;
}

/// One event of the photons that are `on` their way: a flight, and what stands at its end. Tells
/// who goes on. `special` as the world is: known before the loops, so that others are as fast as if
/// there were no such events.
template <bool special, class T, class Ledger>
Mask<T> next_event(const World<T>& world, Travellers<T>& travellers, const Mask<T>& on,
                   Ledger& ledger, tally::BatchTally& tally, Estimates<T>& estimates) {
  if constexpr (special) {
    if (world.analog) return analog_event(world, travellers, on, ledger, tally);
  }
  return forward_event<special>(world, travellers, on, ledger, tally, estimates);
}

/// Follows photon number `number` from the laser until it is absorbed, escapes or comes too late,
/// and scores its echoes. Flattened: what is called stays in registers, a tenth of the time.
template <class T>
PHOTIC_FLATTEN void follow(const World<T>& world, std::uint64_t number, Travellers<T>& photon,
                           Estimates<T>& estimates, tally::BatchTally& tally) {
  bool on = set_out(world, number, true, photon, tally.ledger);
  while (on) on = next_event<false>(world, photon, on, tally.ledger, tally, estimates);
}

/// Keeps the copies of a photon that was split, each with random numbers of its own.
template <class T>
void keep_copies(const World<T>& world, const Travellers<T>& photon,
                 std::vector<Travellers<T>>& waiting) {
  for (std::int32_t i = 0; i < photon.copies; ++i) {
    waiting.push_back(photon);
    if (world.compares) photon.ratios.kept->copy(world.sea.environments, 0, waiting.size());
    waiting.back().place.photon =
        copy_number(photon.place.key, photon.place.photon, photon.place.event, i);
  }
}

/// The same by special events, and of all its copies, which wait for each other.
template <class T>
PHOTIC_FLATTEN void follow_specially(const World<T>& world, std::uint64_t number,
                                     Travellers<T>& photon, std::vector<Travellers<T>>& waiting,
                                     Estimates<T>& estimates, tally::BatchTally& tally) {
  bool on = set_out(world, number, true, photon, tally.ledger);
  if (world.compares) photon.ratios.kept->of(0).begin(world.sea.environments);
  for (;;) {
    while (on) {
      on = next_event<true>(world, photon, on, tally.ledger, tally, estimates);
      if (on) keep_copies(world, photon, waiting);
    }
    if (waiting.empty()) return;
    if (world.compares) photon.ratios.kept->copy(world.sea.environments, waiting.size(), 0);
    photon = std::move(waiting.back());
    waiting.pop_back();
    on = true;
  }
}

}  // namespace photic::engine
