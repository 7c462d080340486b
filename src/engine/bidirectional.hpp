// The bidirectional estimator: walks from the laser and from the telescopes, and all connections
// between them (docs/theory.md, "The bidirectional estimator").
#pragma once

#include <cmath>

#include "core/flatten.hpp"
#include "core/random.hpp"
#include "engine/connections.hpp"
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
                              InTime in_time, RandomPlace<T> place, std::uint32_t stream,
                              Walk<T>& walk, tally::BatchTally& tally, tally::Ledger& ledger) {
  using namespace transport;
  const medium::MediumView& sea = world.sea;
  Photon<T> photon = walk.begin.photon;
  Leg<T> leg;
  walk.add(Ray<T>{walk_point(photon)});
  for (place.event = 1; place.event < most_events; ++place.event) {
    const auto u = uniforms(place, stream);
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
      const auto v = photon.line > 0 ? uniforms(place, stream + 1) : std::array<T, 4>{1, 1, 1, 1};
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
  const RandomPlace<T> place{world.seed, photon, 0};
  const auto u = uniforms(place, 0);
  walk.clear();
  walk.begin = transport::begin_at_laser(world.sea, world.laser, world.laser_layer, u[0], u[1]);
  tally.ledger.escaped += T(1) - (walk.begin.exists ? walk.begin.photon.weight : T(0));
  if (!walk.begin.exists) return;
  take_walk(
      world, samples, [&world](const auto& p) { return in_time(world, p); }, place, 0, walk, tally,
      tally.ledger);
}

/// The first of the random blocks of a receiver; the laser has those below.
template <class T>
std::uint32_t stream_of(const Receiver<T>& receiver) {
  return 4 + 4 * static_cast<std::uint32_t>(receiver.number);
}

/// The walk of a telescope that goes with this photon.
template <class T>
void walk_from_telescope(const World<T>& world, const Receiver<T>& receiver,
                         const transport::Samples<T>& samples, std::uint64_t photon, Walk<T>& walk,
                         tally::BatchTally& tally) {
  const auto& telescope = world.telescopes[receiver.telescope];
  const auto stream = stream_of(receiver);
  const RandomPlace<T> place{world.seed, photon, 0};
  const auto u = uniforms(place, stream);
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
      world, samples, [&world](const auto& p) { return in_time_from_laser(world, p); }, place,
      stream, walk, tally, unused);
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
      walk_from_telescope(world, receiver, samples, first + g, back, tally);
      if (!back.begin.exists) continue;
      const Connections<T> connections(world, receiver, samples, back, tally);
      connections.to_telescope(set.from_laser[g]);
      connections.to_laser();
      const auto u = uniforms(RandomPlace<T>{world.seed, first + g, 0}, stream_of(receiver) + 2);
      if (u[1] < world.connected) connections.between(set.from_laser[g]);
      for (std::size_t i = 0; i < count; ++i) {
        connections.shifted(set.from_laser[i], u[0]);
        connections.turned(set.from_laser[i]);
      }
    }
  }
}

}  // namespace photic::engine
