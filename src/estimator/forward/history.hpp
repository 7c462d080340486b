// One photon of the forward estimator, from the laser to its end.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/flatten.hpp"
#include "estimator/draws.hpp"
#include "estimator/forward/steps.hpp"

namespace photic::estimator {

/// A batch's photons n, n + 1, … of a mask leave the laser.
template <class Events, class T, class Ledger>
void birth(const World<T>& world, const Draws<T>& draws, std::int32_t n, const Mask<T>& exist,
           Travellers<T>& t, Estimates<T>& estimates, tally::BatchTally& tally, Ledger& ledger) {
  t.place.photon = draws.photon(Index<T>(n) + lane_numbers<T>());
  t.place.event = Index<T>(0);
  for (std::size_t k = 0; k < t.lens.size(); ++k) {
    const auto u = draws.together(n, 0, lens_block + static_cast<std::uint32_t>(k));
    t.lens[k] = lens_point(world.groups[k].widest, u[0], u[1]);
  }
  if (world.sea.waves.rough) t.surface = draws.together(n, 0, surface_block);
  const auto u = draws.together(n, 0, 0);
  if (world.sea.bands > 0) t.spectral_bin = medium::spectral_bin_of(u[3]);
  birth_at_laser(world, u[0], u[1], exist, t, ledger);
  if (compares<Events>(world))
    t.ratios.came_down(world.sea, world.laser_region, t.photon.line, t.photon.direction,
                       stands_at_surface(world.sea), t.on);
  if (world.sea.waves.rough && world.laser_region.in_air)
    cross_waves<Events>(world, t, t.on, true, estimates, tally, ledger, [](const auto&...) {});
  if (!world.sea.waves.rough && world.sea.film.exists && world.laser_region.in_air)
    cross_flat_film<Events>(world, t, t.on, true, estimates, tally, ledger);
}

/// Keeps the copies of a photon that was split, each with random numbers of its own.
template <class T>
void keep_copies(const World<T>& world, const Travellers<T>& photon,
                 std::vector<Travellers<T>>& waiting) {
  for (std::int32_t i = 0; i < photon.copies; ++i) {
    waiting.push_back(photon);
    if (world.compares) photon.ratios.paths->copy(world.sea.environments, 0, waiting.size());
    waiting.back().place.photon =
        copy_number(photon.place.key, photon.place.photon, photon.place.event, i);
  }
}

/// Photons on their way from one medium to the other, one by one.
template <class T>
struct Passed {
  explicit Passed(const World<T>& world) : ratios(world.sea.environments, 0) {}

  std::vector<Travellers<T>> photons;
  PathRatios<T> ratios;  ///< of each, in environments
};

/// Who leaves a world's medium by passing the surface waits among the others, to draw random
/// numbers of its own.
template <class T>
auto wait_to_pass(const World<T>& world, Passed<T>& passed) {
  return [&](const Travellers<T>& gone, std::int32_t copy) {
    if (world.compares)
      passed.ratios.copy(world.sea.environments, *gone.ratios.paths, gone.ratios.first,
                         passed.photons.size());
    passed.photons.push_back(gone);
    RandomPlace<T>& place = passed.photons.back().place;
    place.photon = copy_number(world.key, place.photon, place.event, copy);
  };
}

/// Follows a photon from the end of a flight until it is absorbed, escapes or comes too late, and
/// scores its echoes; then all its copies, which wait for each other. `witness` is told of them at
/// the end of each event. Flattened: what is called stays in registers, a tenth of the time.
template <class Events, class T, class Steps, class Witness>
PHOTIC_FLATTEN void follow(const World<T>& world, Travellers<T>& photon,
                           std::vector<Travellers<T>>& waiting, Steps& steps, Witness witness) {
  const auto each = [&](auto stage) { stage(photon); };
  for (;;) {
    while (photon.on) {
      collisions(steps, each);
      witness(photon);
      if (!photon.on) break;
      if constexpr (Events::tools) keep_copies(world, photon, waiting);
      flights(steps, each);
    }
    if (!Events::tools || waiting.empty()) return;
    if (compares<Events>(world))
      photon.ratios.paths->copy(world.sea.environments, waiting.size(), 0);
    photon = std::move(waiting.back());
    waiting.pop_back();
    flights(steps, each);
  }
}
/// The batch's photon n, from the laser on.
template <class Events, class T, class Witness>
PHOTIC_FLATTEN void follow(const World<T>& world, const Draws<T>& draws, std::int32_t n,
                           Travellers<T>& photon, std::vector<Travellers<T>>& waiting,
                           Passed<T>& passed, Estimates<T>& estimates, tally::BatchTally& tally,
                           Witness witness) {
  const auto leave = wait_to_pass(world, passed);
  auto first = forward_steps<Events>(
      world, tally.ledger, tally, estimates,
      [&](std::uint32_t block) { photon.numbers(block) = draws.together(n, 1, block); }, leave);
  auto steps = forward_steps<Events>(
      world, tally.ledger, tally, estimates,
      [&](std::uint32_t block) { photon.numbers(block) = uniforms(photon.place, block); }, leave);
  if (compares<Events>(world)) photon.ratios.paths->of(0).begin(world.sea.environments);
  birth<Events>(world, draws, n, true, photon, estimates, tally, tally.ledger);
  if (photon.on) flights(first, [&](auto stage) { stage(photon); });
  follow<Events>(world, photon, waiting, steps, witness);
}
/// Those who have come from the other medium. `paths`: for what is kept of one here.
template <class Events, class T>
void follow(const World<T>& world, Passed<T>& arrivals, PathRatios<T>& paths,
            std::vector<Travellers<T>>& waiting, Passed<T>& passed, Estimates<T>& estimates,
            tally::BatchTally& tally) {
  for (std::size_t i = 0; i < arrivals.photons.size(); ++i) {
    Travellers<T>& photon = arrivals.photons[i];
    if (world.compares) {
      paths.copy(world.sea.environments, arrivals.ratios, i, 0);
      photon.ratios.paths = &paths;
    }
    auto steps = forward_steps<Events>(
        world, tally.ledger, tally, estimates,
        [&](std::uint32_t block) { photon.numbers(block) = uniforms(photon.place, block); },
        wait_to_pass(world, passed));
    photon.place.key = world.key;
    flights(steps, [&](auto stage) { stage(photon); });
    follow<Events>(world, photon, waiting, steps, [](const auto&) {});
  }
  arrivals.photons.clear();
}

}  // namespace photic::estimator
