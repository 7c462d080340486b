// Every block of random numbers that an event of a history or walk may draw, and every stream of
// them. No block or stream is defined anywhere else.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace photic::estimator {

/// Consecutive blocks of four random numbers each, of one event.
struct RandomBlocks {
  std::uint32_t first, count;

  constexpr std::uint32_t operator[](std::uint32_t n) const { return first + n; }
};

// Their numbers.

/// Light that is still between facets after so many is lost, and counted.
inline constexpr std::uint32_t max_facets = 64;
/// Analog light that is still in a film of oil after so many steps is lost, and counted.
inline constexpr std::uint32_t max_film_steps = 4096;
/// Telescopes of a scene, and the laser.
inline constexpr std::uint32_t max_instruments = 1024;

// Blocks of histories.

/// Blocks of each event: of all, and where they are asked for, of choices and of forced collisions.
inline constexpr RandomBlocks event_blocks{0, 3};
/// The number of copies of a photon that is split.
inline constexpr RandomBlocks split_blocks{3, 1};
/// The block of the laser's light.
inline constexpr RandomBlocks birth_blocks{0, 1};
/// The points of lenses, one for each group of telescopes; of a photon's birth.
inline constexpr RandomBlocks lens_blocks{1, max_instruments};
/// The points where a rough surface leads light on to lenses; of a photon's birth.
inline constexpr RandomBlocks surface_blocks{std::uint32_t{1} << 22, 1};
/// One for each facet that light meets.
inline constexpr RandomBlocks facet_blocks{std::uint32_t{1} << 20, max_facets};
/// One for each facet that one-dimensional waves have.
inline constexpr RandomBlocks line_blocks{std::uint32_t{1} << 21, max_facets};
/// One for each time that light comes to a film of oil.
inline constexpr RandomBlocks film_blocks{std::uint32_t{1} << 25, max_facets};
/// One for each time that light passes the surface: whether it is followed. A facet may have it
/// pass twice, and once more as light that its film emits; before it, a forced flight.
inline constexpr RandomBlocks passing_blocks{std::uint32_t{1} << 23, 3 * max_facets + 1};
inline constexpr std::uint32_t forced_passing = 3 * max_facets;
/// The numbers of copies, by which they draw: of photons that are split, and from passing_blocks on
/// of those that pass the surface.
inline constexpr RandomBlocks copy_blocks{std::uint32_t{1} << 30, std::uint32_t{1} << 24};
/// Steps of analog light in the film of each facet: to a face, and there.
inline constexpr RandomBlocks film_step_blocks{std::uint32_t{1} << 24,
                                               2 * max_film_steps* max_facets};

// Blocks of walks.

/// Four blocks of each instrument, the laser's first: of an event, and of a birth.
inline constexpr RandomBlocks walk_blocks{0, 4 * max_instruments};
/// Two for each facet that walks meet, each as far from the next as instruments are apart.
inline constexpr RandomBlocks walk_facet_blocks{facet_blocks.first,
                                                2 * max_facets* walk_blocks.count};

/// The keys that scramble the points of a batch; instead of a photon's number they have the
/// batch's.
inline constexpr RandomBlocks key_blocks{std::uint32_t{1} << 31, walk_blocks.count};

/// Returns whether no two of them overlap.
template <std::size_t n>
constexpr bool are_apart(std::array<RandomBlocks, n> blocks) {
  std::ranges::sort(blocks, {}, &RandomBlocks::first);
  return std::ranges::adjacent_find(blocks, [](const auto& a, const auto& b) {
           return b.first - a.first < a.count;
         }) == blocks.end();
}
static_assert(are_apart(std::array{event_blocks, split_blocks, facet_blocks, line_blocks,
                                   film_blocks, passing_blocks, copy_blocks, film_step_blocks,
                                   key_blocks}),
              "an event of a history draws no number twice");
static_assert(are_apart(std::array{birth_blocks, lens_blocks, surface_blocks, facet_blocks,
                                   line_blocks, film_blocks, passing_blocks, copy_blocks,
                                   film_step_blocks, key_blocks}),
              "the birth of a photon draws no number twice");
static_assert(are_apart(std::array{walk_blocks, walk_facet_blocks, key_blocks}),
              "walks of a set draw no number twice");
static_assert(passing_blocks.first + passing_blocks.count <= copy_blocks.count,
              "copies have numbers of their own");

// Streams: each is folded into the seed, and shares no number with another, nor with the run.

inline constexpr std::uint64_t pilot_stream = 0x1e3779b97f4a7c15;  ///< pilots of estimators
inline constexpr std::uint64_t bench_stream = 0x3c6ef372fe94f82a;  ///< repeats of photic bench
inline constexpr std::uint64_t air_stream = 0x1f83d9abfb41bd6b;    ///< light in the air
inline constexpr std::uint64_t beside_walks_stream = 0x5be0cd19137e2179;  ///< of a film of oil
inline constexpr std::uint64_t beside_air_stream = 0xa54ff53a5f1d36f1;    ///< in the air
inline constexpr std::uint64_t beside_water_stream = 0x3c6ef372fe94f82b;  ///< in the water

}  // namespace photic::estimator
