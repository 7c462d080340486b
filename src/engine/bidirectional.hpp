// The bidirectional estimator: walks from the laser and from the telescopes, and all connections
// between them (docs/theory.md, "The bidirectional estimator").
#pragma once

#include <cmath>

#include "core/flatten.hpp"
#include "engine/connections.hpp"
#include "engine/draws.hpp"
#include "engine/history.hpp"
#include "engine/walk.hpp"
#include "transport/depart.hpp"
#include "transport/flight.hpp"

namespace photic::engine {

/// Walks on from where a walk begins in the water and notes its vertices, until it is lost to the
/// echo. `in_time` tells whether light from where the photon stands can still count; the ledger
/// takes what ends.
template <class T, class InTime>
PHOTIC_FLATTEN void take_walk(const World<T>& world, const transport::Samples<T>& samples,
                              InTime in_time, const Draws<T>& draws, Walk<T>& walk,
                              tally::BatchTally& tally, tally::Ledger& ledger) {
  using namespace transport;
  const medium::MediumView& sea = world.sea;
  Photon<T> photon = walk.begin.photon;
  Leg<T> leg;
  walk.add(Ray<T>{walk_point(photon)});
  for (std::int32_t event = 1; event < most_events; ++event) {
    const auto u = draws(event, 0);
    const Photon<T> before = photon;
    const auto end = fly(sea, photon, u[0]);
    add_flight(sea, before, photon, leg);
    if (end.sea_bed) return void(ledger.sea_bed += photon.weight);
    if (!in_time(photon)) return void(ledger.cut_by_time += photon.weight);
    if (end.surface) {
      ledger.escaped += reflect_down(sea, photon);
      leg.mirrored = true;
    } else {
      ++tally.collisions;
      walk.add(vertex_on(sea, walk.last_ray(), walk.spread(walk.rays - 1), photon, leg, walk.axis,
                         samples));
      if (walk.vertices == world.last_order) return void(ledger.cut_by_order += photon.weight);
      if (walk.vertices == world.most_vertices) {
        ++tally.too_many_events;
        return void(ledger.lost += photon.weight);
      }
      const T weight = photon.weight;
      const auto v = photon.line > 0 ? draws(event, 1) : std::array<T, 4>{1, 1, 1, 1};
      const auto departure = depart(sea, photon, world.reversal, {u[1], u[2], v[0], v[1]});
      ledger.absorbed += weight - photon.weight;
      if (photon.line != before.line) walk.converts();
      walk.add(next_ray(photon, walk.last_vertex(), departure));
      leg = {};
    }
    const T heavy = photon.weight;
    const bool survives = roulette(photon, world.roulette_threshold, u[3]);
    ledger.roulette += survives ? heavy - photon.weight : heavy;
    if (!survives) return;
    if (!std::isfinite(photon.weight)) return void(++tally.not_finite);
  }
  ++tally.too_many_events;
  ledger.lost += photon.weight;
}

/// Whether light of a telescope's walk can still come from the laser within the last gate.
template <class T>
bool in_time_from_laser(const World<T>& world, const transport::Photon<T>& photon) {
  const T z = photon.position.z;
  const T shortest = world.laser.submerged
                         ? world.least_group_index * std::abs(world.laser.centre.z - z)
                         : world.laser.centre.z - world.least_group_index * z;
  return photon.path + shortest < world.last_path;
}

/// Photon number `photon` of the laser as a walk to be connected.
template <class T>
void walk_from_laser(const World<T>& world, const transport::Samples<T>& samples,
                     std::uint64_t photon, Walk<T>& walk, tally::BatchTally& tally) {
  const Draws<T> draws{world, photon, 0, 0};
  const auto u = draws(0, 0);
  walk.clear();
  walk.begin = transport::begin_at_laser(world.sea, world.laser, world.laser_layer, u[0], u[1]);
  tally.ledger.escaped += T(1) - (walk.begin.exists ? walk.begin.photon.weight : T(0));
  if (!walk.begin.exists) return;
  take_walk(
      world, samples, [&world](const auto& p) { return in_time(world, p); }, draws, walk, tally,
      tally.ledger);
}

/// The random numbers of a telescope's walk; the laser has the blocks below.
template <class T>
Draws<T> draws_of(const World<T>& world, const Receiver<T>& receiver, std::uint64_t photon) {
  return {world, photon, 4 + 4 * static_cast<std::uint32_t>(receiver.number), 1};
}

/// The walk of a telescope that goes with this photon.
template <class T>
void walk_from_telescope(const World<T>& world, const Receiver<T>& receiver,
                         const transport::Samples<T>& samples, const Draws<T>& draws, Walk<T>& walk,
                         tally::BatchTally& tally) {
  const auto& telescope = world.telescopes[receiver.telescope];
  const auto u = draws(0, 0);
  walk.clear();
  walk.lens = lens_point(telescope, u[0], u[1]);
  walk.outward = outward(telescope, walk.lens,
                         instrument::ring_point(T(0), telescope.detector_radius, u[2], u[3]));
  walk.shift_area = shift_area(telescope, dot(walk.outward, telescope.axis));
  walk.begin = transport::begin_at_telescope(world.sea, telescope, receiver.layer, receiver.line,
                                             walk.lens, walk.outward);
  if (!walk.begin.exists) return;
  tally::Ledger unused;  // the ledger is the laser's light's
  take_walk(
      world, samples, [&world](const auto& p) { return in_time_from_laser(world, p); }, draws, walk,
      tally, unused);
}

/// Follows photons `first` … `first + count - 1` from the laser, as one set of walks.
template <class T>
void follow_set(const World<T>& world, std::uint64_t first, std::size_t count, WalkSet<T>& set,
                tally::BatchTally& tally) {
  // An echo is per photon emitted, and so are the samples.
  const transport::Samples<T> samples{T(1), world.connected, T(count),
                                      world.turns ? T(count) : T(0), world.meeting_grid};
  for (std::size_t g = 0; g < count; ++g)
    walk_from_laser(world, samples, first + g, set.from_laser[g], tally);
  for (const Receiver<T>& receiver : world.receivers) {
    for (std::size_t g = 0; g < count; ++g) {
      Walk<T>& back = set.from_telescope;
      const auto draws = draws_of(world, receiver, first + g);
      walk_from_telescope(world, receiver, samples, draws, back, tally);
      if (!back.begin.exists) continue;
      const Connections<T> connections(world, receiver, samples, back, tally);
      connections.to_telescope(set.from_laser[g]);
      connections.to_laser();
      const auto u = draws(0, 1);
      if (u[1] < world.connected) connections.between(set.from_laser[g]);
      for (std::size_t i = 0; i < count; ++i) {
        connections.shifted(set.from_laser[i], u[0]);
        connections.turned(set.from_laser[i]);
      }
    }
  }
}

}  // namespace photic::engine
