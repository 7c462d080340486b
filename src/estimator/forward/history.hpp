// One history, as the physics tells it: for one photon, or for one in each lane.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/flatten.hpp"
#include "core/random.hpp"
#include "estimator/book.hpp"
#include "estimator/draws.hpp"
#include "estimator/ends.hpp"
#include "estimator/forward/estimate.hpp"
#include "estimator/forward/expected_collision.hpp"
#include "estimator/forward/tools.hpp"
#include "estimator/world.hpp"
#include "transport/collide.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

/// A batch's photons n, n + 1, … of a mask on the laser's disc, and on into the water. Those who
/// get there are on their way.
template <class T, class Ledger>
void birth(const World<T>& world, const Draws<T>& draws, std::int32_t n, const Mask<T>& exist,
           Travellers<T>& travellers, Ledger& ledger) {
  using namespace transport;
  travellers.place.photon = draws.photon(Index<T>(n) + lane_numbers<T>());
  travellers.place.event = Index<T>(0);
  for (std::size_t t = 0; t < travellers.lens.size(); ++t) {
    const auto u = draws.together(n, 0, lens_block + static_cast<std::uint32_t>(t));
    travellers.lens[t] = lens_point(world.telescopes[t], u[0], u[1]);
  }
  const auto u = draws.together(n, 0, 0);
  if (world.sea.bands > 0) travellers.spectral_bin = medium::spectral_bin_of(u[3]);
  Photon<T>& photon = travellers.photon;
  photon = emit(world.laser, world.laser_layer, u[0], u[1]);
  travellers.on = exist;
  if (world.laser.submerged) return;
  const T in_air = photon.weight;
  const Mask<T> entered = enter_water(world.sea, photon);
  book(ledger.escaped, exist, select(entered, in_air - photon.weight, in_air));
  travellers.on = exist & entered;
}

// One event of photons that are on their way, stage by stage: a flight, and what stands at its end.
// A pool takes all its packs through each stage before the next one. `Events`: PlainEvents or
// AllEvents, as the world asks for.

/// What is scored of a flight before it begins.
template <class Events, class T, class Ledger>
void score_ahead_of_flight(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
                           tally::BatchTally& tally, Estimates<T>& estimates) {
  if (!world.cones.empty())
    score_on_the_way<Events>(world, travellers, travellers.on, estimates, tally);
  if constexpr (Events::tools) begin_with_tools(world, travellers, travellers.on, ledger);
  score_further_points<Events>(world, travellers, estimates, tally);
}

/// How far they fly.
template <class Events, class T>
void draw_free_path(Travellers<T>& travellers) {
  travellers.free_path = minus_log(path_number<Events>(travellers, travellers.u[0]));
}

/// Reflects photons of a mask at the surface, but for the weight that leaves. Those who are left
/// with far less than the threshold play roulette at once, before more is done for little light; of
/// the number that they play by others use what is left. Tells who goes on.
template <class T, class Ledger>
Mask<T> reflect_in_flight(const World<T>& world, Travellers<T>& travellers,
                          const Mask<T>& reflected, transport::Photon<T>& photon, Ledger& ledger) {
  book(ledger.escaped, reflected, transport::reflect_down(world.sea, photon));
  constexpr double far_less = 1.0 / 8;
  const Mask<T> light = photon.analog_weight < T(far_less) * world.weight_threshold;
  if (!any(reflected & light)) return reflected;
  const T level = select(reflected & light, world.weight_threshold, T(0));
  T& u = travellers.u[3];
  const T chance = transport::survival(photon, level);
  const Mask<T> survives = play_roulette(photon, level, u, reflected, ledger);
  u = left_of_choice(u, chance);
  return survives;
}

/// A flight, and what may stand at its end: the sea bed, the end of the last gate, the surface
/// where it does not go on past that, or else a collision.
template <class Events, class T, class Ledger>
void travel(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
            tally::BatchTally& tally) {
  using namespace transport;
  Photon<T>& photon = travellers.photon;
  Mask<T> on = travellers.on;
  if (compares<Events>(world)) travellers.ratios.before = photon;
  FlightEnd<T> end = fly(world.sea, photon, travellers.free_path);
  if (!Events::tools && world.flies_on) {
    fly_on(world.sea, photon, end, [&](const Mask<T>& turned, Photon<T>& down) {
      on = (on & !turned) | reflect_in_flight(world, travellers, on & turned, down, ledger);
    });
  }
  if (compares<Events>(world)) travellers.ratios.flown(world.sea, photon, end.length, on);
  book(ledger.sea_bed, on & end.sea_bed, photon.weight);
  on = on & !end.sea_bed;
  const Mask<T> late = on & !in_time(world, photon);
  book(ledger.cut_by_time, late, photon.weight);
  on = on & !late;

  travellers.on = on;
  travellers.colliding = on & !end.surface;
  tally.collisions += count(travellers.colliding);
}

/// Those who stand at the surface are reflected, but for the weight that leaves.
template <class Events, class T, class Ledger>
void reflect(const World<T>& world, Travellers<T>& travellers, Ledger& ledger) {
  const Mask<T> reflected = travellers.on & !travellers.colliding;
  if (!any(reflected)) return;
  transport::Photon<T> down = travellers.photon;
  const Mask<T> kept = Events::tools ? are_forced(world, travellers.place) : Mask<T>(false);
  book(ledger.escaped, reflected, transport::reflect_down(world.sea, down, kept));
  transport::Photon<T>& photon = travellers.photon;
  photon.direction.z = select(reflected, down.direction.z, photon.direction.z);
  photon.weight = select(reflected, down.weight, photon.weight);
  photon.analog_weight = select(reflected, down.analog_weight, photon.analog_weight);
}

/// Photons that collide where they stand are scored, if that has not been done on their way.
template <class Events, class T>
void score_collision(const World<T>& world, const Travellers<T>& travellers,
                     tally::BatchTally& tally, Estimates<T>& estimates) {
  if (!any(travellers.colliding) || (Events::tools && world.tools.scores_on_the_way)) return;
  score_scattering<Events>(world, travellers, travellers.colliding, estimates, tally);
}

/// What becomes of them: some go on as light of another wavelength, what is absorbed is lost.
template <class Events, class T, class Ledger>
void collide(const World<T>& world, Travellers<T>& travellers, Ledger& ledger) {
  using namespace transport;
  Photon<T> photon = travellers.photon;
  if (world.last_order > 0) {
    const Mask<T> last =
        travellers.colliding & (photon.order + Index<T>(1) == Index<T>(world.last_order));
    book(ledger.cut_by_order, last, photon.weight);
    travellers.colliding = travellers.colliding & !last;
    travellers.on = travellers.on & !last;
  }
  const Mask<T>& colliding = travellers.colliding;
  if (!any(colliding)) return;
  const Index<T> here = world.sea.at(photon.line, photon.layer);
  book(ledger.absorbed, colliding, photon.weight * gather<T>(world.sea.absorption, here));
  if (compares<Events>(world)) travellers.ratios.before = photon;
  const auto& v = travellers.choices;
  travellers.branch =
      transport::collide(world.sea, photon, travellers.spectral_bin, world.conversion, v[0], v[1]);
  Photon<T>& after = travellers.photon;
  after.weight = select(colliding, photon.weight, after.weight);
  after.analog_weight = select(colliding, photon.analog_weight, after.analog_weight);
  after.line = select(colliding, photon.line, after.line);
  after.order = select(colliding, photon.order, after.order);
}

/// In which direction they go on: about their own, or towards a target.
template <class T>
void deflect(const World<T>& world, Travellers<T>& travellers) {
  if (!any(travellers.colliding)) return;
  const auto& u = travellers.u;
  travellers.deflection = transport::deflect(
      world.sea, travellers.photon.direction, travellers.branch.phase, travellers.branch.lobe,
      travellers.targets, world.directed, {u[1], u[2], u[3], travellers.choices[2]});
}

/// They turn there.
template <class Events, class T>
void turn(const World<T>& world, Travellers<T>& travellers) {
  const Mask<T>& colliding = travellers.colliding;
  if (!any(colliding)) return;
  transport::Photon<T>& photon = travellers.photon;
  if (world.directs) travellers.old_direction = photon.direction;
  photon.direction =
      select<T>(colliding, transport::turned(travellers.deflection), photon.direction);
  if (compares<Events>(world)) travellers.ratios.collided(world.sea, photon, colliding);
}

/// They take the weight of a direction that was drawn with targets.
template <class T>
void weigh_direction(const World<T>& world, Travellers<T>& travellers) {
  const Mask<T>& colliding = travellers.colliding;
  if (!any(colliding)) return;
  transport::Photon<T>& photon = travellers.photon;
  const T ratio = transport::true_over_drawn(world.sea, travellers.old_direction, photon.direction,
                                             travellers.branch.phase, travellers.branch.lobe,
                                             travellers.targets, world.directed);
  photon.weight = photon.weight * select(colliding, ratio, T(1));
}

/// What is left of the number that decided whether directions were drawn towards targets.
template <class T>
T left_of_direction(const World<T>& world, const Travellers<T>& travellers) {
  const T& u = travellers.u[3];
  if (!world.directs) return u;
  const T share = travellers.targets.share(world.directed);
  return select(travellers.colliding, left_of_choice(u, share), u);
}

/// The event ends: roulette, and what is lost.
template <class Events, class T, class Ledger>
void finish(const World<T>& world, Travellers<T>& travellers, Ledger& ledger,
            tally::BatchTally& tally) {
  transport::Photon<T>& photon = travellers.photon;
  Mask<T> on = travellers.on;
  if constexpr (Events::tools)
    on = end_with_tools(world, travellers, on, left_of_direction(world, travellers), ledger);
  else if (any(photon.analog_weight < world.weight_threshold))
    on = play_roulette(photon, world.weight_threshold, left_of_direction(world, travellers), on,
                       ledger);
  const Mask<T> finite = photon.weight <= T(std::numeric_limits<Element<T>>::max());
  const Mask<T> fresh = travellers.place.event < Index<T>(most_events);
  travellers.on = on & finite & fresh;
  if (!any(on & !(finite & fresh))) return;
  tally.not_finite += count(on & !finite);
  const Mask<T> worn = on & finite & !fresh;
  tally.too_many_events += count(worn);
  book(ledger.lost, worn, photon.weight);
}

/// What happens where flights have ended, to all photons that each(stage) has a stage done to.
template <class Events, class T, class Each, class Ledger>
void end_flights(const World<T>& world, Each each, Ledger& ledger, tally::BatchTally& tally,
                 Estimates<T>& estimates) {
  each([&](auto& t) { score_collision<Events>(world, t, tally, estimates); });
  each([&](auto& t) { collide<Events>(world, t, ledger); });
  if (world.directs) each([&](auto& t) { aim_at_targets(world, t); });
  each([&](auto& t) { deflect(world, t); });
  each([&](auto& t) { turn<Events>(world, t); });
  if (world.directs) each([&](auto& t) { weigh_direction(world, t); });
  each([&](auto& t) { finish<Events>(world, t, ledger, tally); });
}
/// Their next flights. draw(block) draws a block of the random numbers of their events.
template <class Events, class T, class Each, class Draw, class Ledger>
void go_on(const World<T>& world, Each each, Draw draw, Ledger& ledger, tally::BatchTally& tally,
           Estimates<T>& estimates) {
  each([](auto& t) { t.place.event = t.place.event + Index<T>(1); });
  draw(0);
  if (world.makes_choices) draw(1);
  if (!world.cones.empty()) draw(2);
  each([&](auto& t) { score_ahead_of_flight<Events>(world, t, ledger, tally, estimates); });
  each([&](auto& t) { draw_free_path<Events>(t); });
  each([&](auto& t) { travel<Events>(world, t, ledger, tally); });
  if (Events::tools || !world.flies_on) each([&](auto& t) { reflect<Events>(world, t, ledger); });
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

/// The next flight of one photon.
template <class Events, class T>
void go_on(const World<T>& world, Travellers<T>& photon, Estimates<T>& estimates,
           tally::BatchTally& tally) {
  go_on<Events>(
      world, [&](auto stage) { stage(photon); },
      [&](std::uint32_t block) { photon.numbers(block) = uniforms(photon.place, block); },
      tally.ledger, tally, estimates);
}

/// Follows a photon that is on its way until it is absorbed, escapes or comes too late, and scores
/// its echoes. `witness` is told of it at the end of each event.
template <class Events, class T, class Witness>
void follow(const World<T>& world, Travellers<T>& photon, std::vector<Travellers<T>>& waiting,
            Estimates<T>& estimates, tally::BatchTally& tally, Witness& witness) {
  const auto each = [&](auto stage) { stage(photon); };
  while (photon.on) {
    end_flights<Events>(world, each, tally.ledger, tally, estimates);
    witness(photon);
    if (!photon.on) return;
    if constexpr (Events::tools) keep_copies(world, photon, waiting);
    go_on<Events>(world, photon, estimates, tally);
  }
}

/// The same of the batch's photon n, from the laser on, and of all its copies, which wait for each
/// other. Flattened: what is called stays in registers, a tenth of the time.
template <class Events, class T, class Witness>
PHOTIC_FLATTEN void follow(const World<T>& world, const Draws<T>& draws, std::int32_t n,
                           Travellers<T>& photon, std::vector<Travellers<T>>& waiting,
                           Estimates<T>& estimates, tally::BatchTally& tally, Witness witness) {
  birth(world, draws, n, true, photon, tally.ledger);
  if (compares<Events>(world)) photon.ratios.kept->of(0).begin(world.sea.environments);
  if (photon.on) {
    go_on<Events>(
        world, [&](auto stage) { stage(photon); },
        [&](std::uint32_t block) { photon.numbers(block) = draws.together(n, 1, block); },
        tally.ledger, tally, estimates);
  }
  for (;;) {
    follow<Events>(world, photon, waiting, estimates, tally, witness);
    if (!Events::tools || waiting.empty()) return;
    if (compares<Events>(world))
      photon.ratios.kept->copy(world.sea.environments, waiting.size(), 0);
    photon = std::move(waiting.back());
    waiting.pop_back();
    go_on<Events>(world, photon, estimates, tally);
  }
}

}  // namespace photic::estimator
