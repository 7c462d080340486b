// One photon of the forward estimator, from the laser to its end.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/flatten.hpp"
#include "estimator/draws.hpp"
#include "estimator/forward/steps.hpp"
#include "estimator/random_blocks.hpp"

namespace photic::estimator {

/// A batch's photons n, n + 1, … of a mask leave the laser.
template <class Events, class T, class Ledger>
void birth(const World<T>& world, const Draws<T>& draws, std::int32_t n, const Mask<T>& exist,
           ForwardTracks<T>& t, Estimates<T>& estimates, tally::BatchTally& tally, Ledger& ledger,
           const Leave<T>& leave) {
  t.place.photon = draws.photon(Index<T>(n) + lane_numbers<T>());
  t.place.event = Index<T>(0);
  for (std::size_t k = 0; k < t.lens.size(); ++k) {
    const auto u = draws.together(n, 0, lens_blocks[static_cast<std::uint32_t>(k)]);
    t.lens[k] = lens_point(world.instruments.groups[k].widest, u[0], u[1]);
  }
  if (!world.slabs.surface.one_direction_each) t.surface = draws.together(n, 0, surface_blocks[0]);
  const auto u = draws.together(n, 0, birth_blocks[0]);
  if (world.slabs.bands > 0) t.spectral_bin = medium::spectral_bin_of(u[3]);
  birth_at_laser(world, u[0], u[1], exist, t, ledger);
  if (!world.instruments.laser_region.outside) return;
  if constexpr (Events::tallies)
    if (world.tallies) tally_birth<Ledger>(world, t, exist, tally);
  companions_of<Events>(world, t).came_down(world.instruments.laser_region, t.photon, t.on);
  const Mask<T> stand = t.on;
  cross_surface<Events>(world, t, stand, true, estimates, tally, ledger, leave);
}

/// Keeps the copies of a photon that was split, each with random numbers of its own.
template <class T>
void keep_copies(const World<T>& world, const ForwardTracks<T>& photon,
                 std::vector<ForwardTracks<T>>& waiting) {
  for (std::int32_t i = 0; i < photon.copies; ++i) {
    waiting.push_back(photon);
    photon.ratios.paths->copy(world.slabs.environments, 0, waiting.size());
    waiting.back().place.photon =
        copy_number(photon.place.key, photon.place.photon, photon.place.event, i);
  }
}

/// Photons on their way from one medium to the other, one by one.
template <class T>
struct Passed {
  explicit Passed(const World<T>& world) : ratios(world.slabs.environments, 0) {}

  std::vector<ForwardTracks<T>> photons;
  std::vector<instrument::PlanePoint<T>> lens;  ///< of each, its points
  PathRatios<T> ratios;                         ///< of each, in environments
};

/// Has photons that leave a world's medium through the surface wait among the others, to draw
/// random numbers of their own.
template <class T>
Leave<T> wait_to_pass(const World<T>& world, Passed<T>& passed) {
  return [&](const ForwardTracks<T>& gone, std::int32_t copy) {
    passed.ratios.copy(world.slabs.environments, *gone.ratios.paths, gone.ratios.first,
                       passed.photons.size());
    passed.photons.push_back(gone);
    passed.lens.insert(passed.lens.end(), gone.lens.begin(), gone.lens.end());
    RandomPlace<T>& place = passed.photons.back().place;
    place.photon = copy_number(world.random.key, place.photon, place.event, copy);
  };
}

/// Follows a photon from the beginning of a flight until it is absorbed, escapes or comes too late,
/// and scores its echoes; then all its copies, which wait for each other. `first`: the steps of the
/// first flight, `steps`: those of all others. `witness` is called for them at the end of each
/// event. Flattened: all that it calls stays in registers, which saves a tenth of the time.
template <class Events, class T, class Steps, class Witness>
PHOTIC_APART PHOTIC_FLATTEN void follow(const World<T>& world, ForwardTracks<T>& photon,
                                        std::vector<ForwardTracks<T>>& waiting, Steps& first,
                                        Steps& steps, Witness& witness) {
  const auto each = [&](auto stage) { stage(photon); };
  for (Steps* now = &first;; now = &steps) {
    flights(*now, each);
    if (photon.on) {
      collisions(steps, each);
      witness(photon);
      if constexpr (Events::tools)
        if (photon.on) keep_copies(world, photon, waiting);
      if (photon.on) continue;
    }
    if (!Events::tools || waiting.empty()) return;
    photon.ratios.paths->copy(world.slabs.environments, waiting.size(), 0);
    photon = waiting.back();
    waiting.pop_back();
  }
}
/// The batch's photons `first` … `first + count - 1`, from the laser on.
template <class Events, class T, class Witness>
void follow(const World<T>& world, std::uint64_t first, std::uint64_t count, Passed<T>& passed,
            tally::BatchTally& tally, Witness& witness) {
  const Draws<T> draws = draws_of_laser<T>(world.random, first);
  std::vector<instrument::PlanePoint<T>> lens(lens_points(world));
  ForwardTracks<T> photon(world, lens);
  PathRatios<T> paths(world.slabs.environments, 1);
  photon.ratios.paths = &paths;
  std::vector<ForwardTracks<T>> waiting;
  Estimates<T> estimates(world);
  std::int32_t n = 0;
  using Steps = ForwardSteps<Events, T, tally::Ledger>;
  Steps first_flight{
      world,
      tally.ledger,
      tally,
      estimates,
      [&](std::uint32_t block) { photon.numbers(block) = draws.together(n, 1, block); },
      wait_to_pass(world, passed)};
  Steps steps{world,
              tally.ledger,
              tally,
              estimates,
              [&](std::uint32_t block) { photon.numbers(block) = uniforms(photon.place, block); },
              wait_to_pass(world, passed)};
  for (; n < static_cast<std::int32_t>(count); ++n) {
    paths.begin(world.slabs.environments, 0);
    birth<Events>(world, draws, n, true, photon, estimates, tally, tally.ledger,
                  first_flight.leave);
    if (photon.on) follow<Events>(world, photon, waiting, first_flight, steps, witness);
  }
}
/// Follows the photons that have come from the other medium.
template <class Events, class T, class Witness>
void follow(const World<T>& world, Passed<T>& arrivals, Passed<T>& passed, tally::BatchTally& tally,
            Witness& witness) {
  ForwardTracks<T> photon(world, {});
  PathRatios<T> paths(world.slabs.environments, 1);
  std::vector<ForwardTracks<T>> waiting;
  Estimates<T> estimates(world);
  ForwardSteps<Events, T, tally::Ledger> steps{
      world,
      tally.ledger,
      tally,
      estimates,
      [&](std::uint32_t block) { photon.numbers(block) = uniforms(photon.place, block); },
      wait_to_pass(world, passed)};
  for (std::size_t i = 0; i < arrivals.photons.size(); ++i) {
    photon = arrivals.photons[i];
    photon.lens = LensPoints<T>(arrivals.lens).subspan(i * lens_points(world), lens_points(world));
    paths.copy(world.slabs.environments, arrivals.ratios, i, 0);
    photon.ratios.paths = &paths;
    photon.place.key = world.random.key;
    follow<Events>(world, photon, waiting, steps, steps, witness);
  }
  arrivals.photons.clear();
  arrivals.lens.clear();
}

/// Follows light by the events that a world asks for: `from` is a batch's first photon and how
/// many, or photons that have come from the other medium.
template <class T, class Witness, class... From>
void follow_in(const World<T>& world, tally::BatchTally& tally, Passed<T>& passed, Witness witness,
               From&&... from) {
  if (world.all_events)
    follow<AllEvents>(world, from..., passed, tally, witness);
  else
    follow<PlainEvents>(world, from..., passed, tally, witness);
}

}  // namespace photic::estimator
