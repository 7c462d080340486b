// Everything a history needs, immutable and shared by all threads.
#pragma once

#include <cstdint>
#include <memory>

#include "core/random.hpp"
#include "core/sobol.hpp"
#include "estimator/companion.hpp"
#include "estimator/forward_settings.hpp"
#include "estimator/instruments.hpp"
#include "estimator/plan.hpp"
#include "estimator/tallies/tallies.hpp"
#include "estimator/walk_settings.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// Light that passes the surface is followed in another world.
template <class T>
struct Beyond {
  bool exists = false;
  bool fresh = false;  ///< also light that has not been scattered
  T chance{1};         ///< share of it that is
  T path{};            ///< the excess of its path there [m]
};

/// The part of a run's echo that the histories of a world make.
template <class T>
struct EchoPart {
  Scored scored = Scored::all;
  std::int32_t last_order = 0;  ///< scores go on to this order; 0: no limit
  Beyond<T> beyond;
};

/// The random numbers of histories.
struct RandomNumbers {
  RandomKey key{0};
  std::uint64_t batch_photons = 0;
  SobolPoints points;  ///< of a batch; none: all numbers are drawn independently
};

/// A medium on one side of the sea surface, water or air, with the instruments, and the settings of
/// light in it. Its inside is the medium; its outside lies beyond the surface.
template <class T>
struct World {
  geometry::Slabs slabs;  ///< of the medium
  Instruments<T> instruments;
  ForwardSettings<T> forward;
  WalkSettings<T> walks;
  EchoPart<T> part;
  RandomNumbers random;
  bool has_environments = false;           ///< there are environments
  bool all_events = false;                 ///< see AllEvents
  Companion<T>* companion = nullptr;       ///< of all light; none: nullptr
  std::shared_ptr<const Tallies> tallies;  ///< beside echoes; none: nullptr
};

/// The events that a photon of the forward estimator may meet, known before the loops: most worlds
/// have neither the paper's tools, nor variations (environments and derivatives), nor tallies
/// beside echoes, and loops without them are faster.
struct PlainEvents {
  static constexpr bool tools = false, variations = false, tallies = false;
};
struct AllEvents {
  static constexpr bool tools = true, variations = true, tallies = true;
};

/// Has a companion travel with all light of a world. It is shown every crossing: no flight goes
/// past the surface without meeting it.
template <class T>
void accompany(World<T>& world, Companion<T>& companion) {
  world.companion = &companion;
  world.all_events = true;
  world.forward.flies_on = false;
}

/// Returns whether there are environments.
template <class Events, class T>
bool has_environments(const World<T>& world) {
  if constexpr (Events::variations) {
    return world.has_environments;
  } else {
    return false;
  }
}

/// The coordinates of a batch's points: four for each block of random numbers, of which an event of
/// a photon has three, of the laser's walk one and of a telescope's two.
inline constexpr std::uint32_t quasi_random_events = 3;
inline constexpr std::uint32_t quasi_random_blocks = 3;
inline constexpr std::uint32_t quasi_random_dimensions =
    4 * quasi_random_blocks * quasi_random_events;

}  // namespace photic::estimator
