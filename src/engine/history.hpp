// One history, as the physics tells it: for one photon, or for one in each lane.
#pragma once

#include <cmath>
#include <limits>

#include "core/flatten.hpp"
#include "core/random.hpp"
#include "engine/estimate.hpp"
#include "engine/world.hpp"
#include "transport/collide.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"
#include "transport/scatter.hpp"

namespace photic::engine {

/// A photon that has not ended after so many events is lost, and counted.
inline constexpr std::int32_t most_events = 1'000'000;

/// Whether light from here can still be back within the last gate: the shortest way at the least
/// group index.
template <class T>
Mask<T> in_time(const World<T>& world, const transport::Photon<T>& photon) {
  using std::abs;
  T shortest = world.lowest_in_air - world.least_group_index * photon.position.z;
  for (const T& z : world.submerged_z) {
    const T direct = world.least_group_index * abs(z - photon.position.z);
    shortest = select(direct < shortest, direct, shortest);
  }
  return photon.path + shortest < world.last_path;
}

/// Adds the weights of the lanes of a mask to an account of the ledger.
inline void book(double& account, bool mask, double weight) {
  if (mask) account += weight;
}

/// The photons of a mask on the laser's disc, and on into the water. Tells which get there.
template <class T, class Ledger>
Mask<T> set_out(const World<T>& world, const Counter<T>& number, const Mask<T>& exist,
                Travellers<T>& travellers, Ledger& ledger) {
  using namespace transport;
  travellers.place = {world.seed, number, Index<T>(0)};
  travellers.lens.resize(world.single_rays ? world.telescopes.size() : 0);
  for (std::size_t t = 0; t < travellers.lens.size(); ++t)
    travellers.lens[t] = chosen_lens_point(world, travellers.place, t);

  const auto u = uniforms(travellers.place, 0);
  Photon<T>& photon = travellers.photon;
  photon = emit(world.laser, world.laser_layer, u[0], u[1]);
  if (world.laser.submerged) return exist;
  const T in_air = photon.weight;
  const Mask<T> entered = enter_water(world.sea, photon);
  book(ledger.escaped, exist, select(entered, in_air - photon.weight, in_air));
  return exist & entered;
}

/// What becomes of photons that collide where they stand: they are scored, and go on in another
/// direction, at another wavelength, or not.
template <class T, class Ledger>
void collision(const World<T>& world, Travellers<T>& travellers, const std::array<T, 4>& u,
               Mask<T>& colliding, Ledger& ledger, tally::BatchTally& tally,
               Estimates<T>& estimates) {
  using namespace transport;
  Photon<T>& photon = travellers.photon;
  score_scattering(world, travellers, colliding, estimates, tally);
  if (world.last_order > 0) {
    const Mask<T> last = colliding & (photon.order + Index<T>(1) == Index<T>(world.last_order));
    book(ledger.cut_by_order, last, photon.weight);
    colliding = colliding & !last;
  }
  const Index<T> here = world.sea.at(photon.line, photon.layer);
  book(ledger.absorbed, colliding, photon.weight * gather<T>(world.sea.absorption, here));
  if (world.compares) [[unlikely]]
    travellers.ratios.before = photon;
  const auto v = world.makes_choices ? uniforms(travellers.place, 1) : std::array<T, 4>{};
  const auto branch = collide(world.sea, photon, world.conversion, v[0], v[1]);
  scatter(world.sea, photon, branch.phase, branch.lobe, estimates.targets, world.directed,
          {u[1], u[2], v[2], v[3]});
  if (world.compares) [[unlikely]]
    travellers.ratios.collided(world.sea, photon, colliding);
}

/// One event of the photons that are `on` their way: a flight, and what stands at its end. Tells
/// who goes on.
template <class T, class Ledger>
Mask<T> next_event(const World<T>& world, Travellers<T>& travellers, Mask<T> on, Ledger& ledger,
                   tally::BatchTally& tally, Estimates<T>& estimates) {
  using namespace transport;
  Photon<T>& photon = travellers.photon;
  travellers.place.event = travellers.place.event + Index<T>(1);
  const auto u = uniforms(travellers.place, 0);
  if (!world.views.empty()) score_conversions(world, travellers, on, estimates, tally);
  if (world.compares) [[unlikely]]
    travellers.ratios.before = photon;
  const FlightEnd<T> end = fly(world.sea, photon, u[0]);
  if (world.compares) [[unlikely]]
    travellers.ratios.flown(world.sea, photon, end.length, on);
  book(ledger.sea_bed, on & end.sea_bed, photon.weight);
  on = on & !end.sea_bed;
  const Mask<T> late = on & !in_time(world, photon);
  book(ledger.cut_by_time, late, photon.weight);
  on = on & !late;

  const Mask<T> reflected = on & end.surface;
  Mask<T> colliding = on & !end.surface;
  Photon<T> down = photon;
  if (any(reflected)) book(ledger.escaped, reflected, reflect_down(world.sea, down));
  if (any(colliding)) {
    tally.collisions += count(colliding);
    collision(world, travellers, u, colliding, ledger, tally, estimates);
  }
  if (any(reflected)) photon = select(reflected, down, photon);
  on = reflected | colliding;

  const T weight = photon.weight;
  const Mask<T> survives = roulette(photon, world.roulette_threshold, u[3]);
  const Mask<T> played = on & !(survives & (photon.weight == weight));
  book(ledger.roulette, played, select(survives, weight - photon.weight, weight));
  on = on & survives;
  const Mask<T> finite = photon.weight <= T(std::numeric_limits<Element<T>>::max());
  tally.not_finite += count(on & !finite);
  on = on & finite;
  const Mask<T> worn = on & (travellers.place.event >= Index<T>(most_events));
  tally.too_many_events += count(worn);
  book(ledger.lost, worn, photon.weight);
  return on & !worn;
}

/// Follows photon number `number` from the laser until it is absorbed, escapes or comes too late,
/// and scores its echoes. Flattened: what is called stays in registers, a tenth of the time.
template <class T>
PHOTIC_FLATTEN void follow(const World<T>& world, std::uint64_t number, Travellers<T>& photon,
                           Estimates<T>& estimates, tally::BatchTally& tally) {
  bool on = set_out(world, number, true, photon, tally.ledger);
  if (world.compares) [[unlikely]]
    photon.ratios.kept->of(0).begin(world.sea.environments);
  while (on) on = next_event(world, photon, on, tally.ledger, tally, estimates);
}

}  // namespace photic::engine
