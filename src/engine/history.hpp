// One history, as the physics tells it: for one photon, or for one in each lane.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/flatten.hpp"
#include "core/random.hpp"
#include "engine/ahead.hpp"
#include "engine/analog.hpp"
#include "engine/book.hpp"
#include "engine/draws.hpp"
#include "engine/ends.hpp"
#include "engine/estimate.hpp"
#include "engine/tools.hpp"
#include "engine/world.hpp"
#include "transport/collide.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"
#include "transport/scatter.hpp"

namespace photic::engine {

/// A batch's photons n, n + 1, … of a mask on the laser's disc, and on into the water. Those who
/// get there are on their way.
template <class T, class Ledger>
void set_out(const World<T>& world, const Draws<T>& draws, std::int32_t n, const Mask<T>& exist,
             Travellers<T>& travellers, Ledger& ledger) {
  using namespace transport;
  travellers.place.photon = draws.photon(Index<T>(n) + lane_numbers<T>());
  travellers.place.event = Index<T>(0);
  for (std::size_t t = 0; t < travellers.lens.size(); ++t) {
    const auto u = draws.together(n, 0, lens_block + static_cast<std::uint32_t>(t));
    travellers.lens[t] = lens_point(world.telescopes[t], u[0], u[1]);
  }
  const auto u = draws.together(n, 0, 0);
  if (world.sea.bands > 0) travellers.hue = medium::hue_of(u[3]);
  Photon<T>& photon = travellers.photon;
  photon = emit(world.laser, world.laser_layer, u[0], u[1]);
  travellers.on = exist;
  if (world.laser.submerged) return;
  const T in_air = photon.weight;
  const Mask<T> entered = enter_water(world.sea, photon);
  book(ledger.escaped, exist, select(entered, in_air - photon.weight, in_air));
  travellers.on = exist & entered;
  if (world.analog) [[unlikely]]
    travellers.on = enter_by_chance(photon, travellers.on, u[2], ledger);
}

// One event of photons that are on their way, stage by stage: a flight, and what stands at its end.
// A pool takes all its packs through each stage before the next one. `special` as the world is:
// known before the loops, so that others are as fast as if there were no such events.

/// The event begins. `block`: its numbers, by the number of the block.
template <class T, class Block>
void begin_event(const World<T>& world, Travellers<T>& travellers, Block block) {
  travellers.place.event = travellers.place.event + Index<T>(1);
  travellers.u = block(0);
  if (world.makes_choices) travellers.choices = block(1);
  if (!world.cones.empty()) travellers.forced = block(2);
}
template <class T>
void begin_event(const World<T>& world, Travellers<T>& travellers) {
  begin_event(world, travellers,
              [&](std::uint32_t block) { return uniforms(travellers.place, block); });
}

/// What is scored of a flight before it begins.
template <bool special, class T, class Ledger>
void look_out(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
              tally::BatchTally& tally, Estimates<T>& estimates) {
  if (!world.cones.empty())
    score_on_the_way<special>(world, travellers, travellers.on, estimates, tally);
  if constexpr (special) begin_with_tools(world, travellers, travellers.on, ledger);
  score_further_points<special>(world, travellers, estimates, tally);
}

/// A flight, and what may stand at its end: the sea bed, the end of the last gate, the surface, or
/// else a collision.
template <bool special, class T, class Ledger>
void travel(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
            tally::BatchTally& tally) {
  using namespace transport;
  Photon<T> photon = travellers.photon;
  Mask<T> on = travellers.on;
  if (compares<special>(world)) travellers.ratios.before = photon;
  const FlightEnd<T> end =
      fly(world.sea, photon, path_number<special>(travellers, travellers.u[0]));
  if (compares<special>(world)) travellers.ratios.flown(world.sea, photon, end.length, on);
  book(ledger.sea_bed, on & end.sea_bed, photon.weight);
  on = on & !end.sea_bed;
  const Mask<T> late = on & !in_time(world, photon);
  book(ledger.cut_by_time, late, photon.weight);
  on = on & !late;

  const Mask<T> reflected = on & end.surface;
  if (any(reflected)) {
    Photon<T> down = photon;
    const Mask<T> kept = special ? are_forced(world, travellers.place) : Mask<T>(false);
    book(ledger.escaped, reflected, reflect_down(world.sea, down, kept));
    photon = select(reflected, down, photon);
  }
  travellers.photon = photon;
  travellers.on = on;
  travellers.colliding = on & !end.surface;
  tally.collisions += count(travellers.colliding);
}

/// Photons that collide where they stand are scored, if that has not been done on their way.
template <bool special, class T>
void score_collision(const World<T>& world, const Travellers<T>& travellers,
                     tally::BatchTally& tally, Estimates<T>& estimates) {
  if (!any(travellers.colliding) || (special && world.tools.scores_on_the_way)) return;
  score_scattering<special>(world, travellers, travellers.colliding, estimates, tally);
}

/// What becomes of them: they go on in another direction, at another wavelength, or not.
template <bool special, class T, class Ledger>
void collision(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
               Estimates<T>& estimates) {
  using namespace transport;
  Mask<T> colliding = travellers.colliding;
  if (!any(colliding)) return;
  Photon<T> photon = travellers.photon;
  if (world.last_order > 0) {
    const Mask<T> last = colliding & (photon.order + Index<T>(1) == Index<T>(world.last_order));
    book(ledger.cut_by_order, last, photon.weight);
    colliding = colliding & !last;
    travellers.on = travellers.on & !last;
  }
  const Index<T> here = world.sea.at(photon.line, photon.layer);
  book(ledger.absorbed, colliding, photon.weight * gather<T>(world.sea.absorption, here));
  if (compares<special>(world)) travellers.ratios.before = photon;
  aim_at_targets(world, travellers, estimates.targets);
  auto& u = travellers.u;
  const auto& v = travellers.choices;
  const auto branch = collide(world.sea, photon, travellers.hue, world.conversion, v[0], v[1]);
  scatter(world.sea, photon, branch.phase, branch.lobe, estimates.targets, world.directed,
          {u[1], u[2], u[3], v[2]});
  if (world.directs)
    u[3] = select(colliding, left_of_choice(u[3], estimates.targets.share(world.directed)), u[3]);
  if (compares<special>(world)) travellers.ratios.collided(world.sea, photon, colliding);
  Photon<T>& after = travellers.photon;
  after.direction = select<T>(colliding, photon.direction, after.direction);
  after.weight = select(colliding, photon.weight, after.weight);
  after.analog_weight = select(colliding, photon.analog_weight, after.analog_weight);
  after.line = select(colliding, photon.line, after.line);
  after.order = select(colliding, photon.order, after.order);
}

/// The event ends: roulette, and what is lost.
template <bool special, class T, class Ledger>
void finish(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
            tally::BatchTally& tally) {
  transport::Photon<T>& photon = travellers.photon;
  Mask<T> on = travellers.on;
  if constexpr (special)
    on = end_with_tools(world, travellers, on, travellers.u[3], ledger);
  else
    on = play_roulette(photon, world.weight_threshold, travellers.u[3], on, ledger);
  const Mask<T> finite = photon.weight <= T(std::numeric_limits<Element<T>>::max());
  const Mask<T> fresh = travellers.place.event < Index<T>(most_events);
  travellers.on = on & finite & fresh;
  if (!any(on & !(finite & fresh))) return;
  tally.not_finite += count(on & !finite);
  const Mask<T> worn = on & finite & !fresh;
  tally.too_many_events += count(worn);
  book(ledger.lost, worn, photon.weight);
}

/// The next flight.
template <bool special, class T, class Ledger>
void go_on(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
           tally::BatchTally& tally, Estimates<T>& estimates) {
  begin_event(world, travellers);
  look_out<special>(world, travellers, ledger, tally, estimates);
  travel<special>(world, travellers, ledger, tally);
}
/// The first one, of the batch's photons n, n + 1, … that have set out.
template <bool special, class T, class Ledger>
void launch(const World<T>& world, const Draws<T>& draws, std::int32_t n, Travellers<T>& travellers,
            Ledger& ledger, tally::BatchTally& tally, Estimates<T>& estimates) {
  begin_event(world, travellers, [&](std::uint32_t block) { return draws.together(n, 1, block); });
  look_out<special>(world, travellers, ledger, tally, estimates);
  travel<special>(world, travellers, ledger, tally);
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

/// Follows a photon that is on its way until it is absorbed, escapes or comes too late, and scores
/// its echoes. `witness` is told of it at the end of each event.
template <bool special, class T, class Witness>
void follow(const World<T>& world, Travellers<T>& photon, std::vector<Travellers<T>>& waiting,
            Estimates<T>& estimates, tally::BatchTally& tally, Witness& witness) {
  while (photon.on) {
    if constexpr (special) {
      if (world.analog) {
        analog_event(world, photon, tally.ledger, tally);
        witness(photon);
        continue;
      }
    }
    score_collision<special>(world, photon, tally, estimates);
    collision<special>(world, photon, tally.ledger, estimates);
    finish<special>(world, photon, tally.ledger, tally);
    witness(photon);
    if (!photon.on) return;
    if constexpr (special) keep_copies(world, photon, waiting);
    go_on<special>(world, photon, tally.ledger, tally, estimates);
  }
}

/// The same of the batch's photon n, from the laser on, and of all its copies, which wait for each
/// other. Flattened: what is called stays in registers, a tenth of the time.
template <bool special, class T, class Witness>
PHOTIC_FLATTEN void follow(const World<T>& world, const Draws<T>& draws, std::int32_t n,
                           Travellers<T>& photon, std::vector<Travellers<T>>& waiting,
                           Estimates<T>& estimates, tally::BatchTally& tally, Witness witness) {
  set_out(world, draws, n, true, photon, tally.ledger);
  if (compares<special>(world)) photon.ratios.kept->of(0).begin(world.sea.environments);
  if (photon.on && !(special && world.analog))
    launch<special>(world, draws, n, photon, tally.ledger, tally, estimates);
  for (;;) {
    follow<special>(world, photon, waiting, estimates, tally, witness);
    if (!special || waiting.empty()) return;
    if (compares<special>(world))
      photon.ratios.kept->copy(world.sea.environments, waiting.size(), 0);
    photon = std::move(waiting.back());
    waiting.pop_back();
    go_on<special>(world, photon, tally.ledger, tally, estimates);
  }
}

}  // namespace photic::engine
