// One history, as the physics tells it.
#pragma once

#include <cmath>

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
bool in_time(const World<T>& world, const transport::Photon<T>& photon) {
  T shortest = world.lowest_in_air - world.least_group_index * photon.position.z;
  for (const T& z : world.submerged_z)
    shortest = std::min(shortest, world.least_group_index * std::abs(z - photon.position.z));
  return photon.path + shortest < world.last_path;
}

/// Follows photon number `number` from the laser until it is absorbed, escapes or comes too late,
/// and scores its echoes. Flattened: what is called stays in registers, a tenth of the time.
template <class T>
[[gnu::flatten]] void follow(const World<T>& world, std::uint64_t number,
                             tally::BatchTally& tally) {
  using namespace transport;
  RandomPlace<T> place{world.seed, number, 0};
  tally::Ledger& ledger = tally.ledger;

  const auto birth = uniforms(place, 0);
  Photon<T> photon = emit(world.laser, world.laser_layer, birth[0], birth[1]);
  if (!world.laser.submerged) {
    const T in_air = photon.weight;
    if (!enter_water(world.sea, photon)) return void(ledger.escaped += in_air);
    ledger.escaped += in_air - photon.weight;
  }

  Targets<T> targets;
  while (place.event < most_events) {
    ++place.event;
    const auto u = uniforms(place, 0);
    if (!world.views.empty()) score_conversions(world, photon, place, tally);
    const auto end = fly(world.sea, photon, u[0]);
    if (end.sea_bed) return void(ledger.sea_bed += photon.weight);
    if (!in_time(world, photon)) return void(ledger.cut_by_time += photon.weight);
    if (end.surface) {
      ledger.escaped += reflect_down(world.sea, photon);
    } else {
      ++tally.collisions;
      score_scattering(world, photon, place, tally, targets);
      if (photon.order + 1 == world.last_order) return void(ledger.cut_by_order += photon.weight);

      ledger.absorbed +=
          photon.weight * T(world.sea.absorption[world.sea.at(photon.line, photon.layer)]);
      const auto v = world.makes_choices ? uniforms(place, 1) : std::array<T, 4>{};
      const auto branch = collide(world.sea, photon, world.conversion, v[0], v[1]);
      scatter(world.sea, photon, branch.phase, branch.lobe, targets, world.directed,
              {u[1], u[2], v[2], v[3]});
    }
    const T before = photon.weight;
    const bool survives = roulette(photon, world.roulette_threshold, u[3]);
    ledger.roulette += survives ? before - photon.weight : before;
    if (!survives) return;
    if (!std::isfinite(photon.weight)) return void(++tally.not_finite);
  }
  ++tally.too_many_events;
  ledger.lost += photon.weight;
}

}  // namespace photic::engine
