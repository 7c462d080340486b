// Photons of the forward estimator on their way, and what they carry from one stage of an event to
// the next.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "core/random.hpp"
#include "estimator/event.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/variations/ratios.hpp"
#include "estimator/world.hpp"
#include "transport/collide.hpp"
#include "transport/connect.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

template <class T>
using Targets = transport::Targets<T, target_capacity>;

/// The points of lenses, one of each group, that take part in local estimates of single rays.
template <class T>
using LensPoints = std::span<instrument::PlanePoint<T>>;
template <class T>
std::size_t lens_points(const World<T>& world) {
  return world.forward.single_rays ? world.instruments.groups.size() : 0;
}

/// Photons on their way, one in each lane, and the event that they are in.
template <class T>
struct ForwardTracks : Track<T> {
  ForwardTracks(const World<T>& world, LensPoints<T> own)
      : place{world.random.key, {}, {}}, lens(own) {}

  RandomPlace<T> place;
  Index<T> spectral_bin{};     ///< in which lines it emits
  LensPoints<T> lens;          ///< those of the history
  std::array<T, 4> surface{};  ///< numbers of where a rough surface leads light on to lenses: the
                               ///< same for all of a history, so that light can be sent there
  Ratios<T> ratios;            ///< of their weights in environments

  // For the event:
  std::array<T, 4> u{}, choices{}, forced{};  ///< numbers: of all events, and where they are asked
                                              ///< for, of choices and of forced collisions
  T free_path{};                              ///< of the flight, an optical depth
  transport::Branch<T> branch;                ///< their collision
  Targets<T> targets;                         ///< of the directions that they may take next
  transport::Deflection<T> deflection;        ///< by the collision
  Vec3<T> old_direction;                      ///< before it
  T stays{1};                              ///< chance that a forced flight has to end in the water
  T analog_before{}, importance_before{};  ///< the flight, for tools that ask
  Index<T> copies{};  ///< of photons that were split in the event, besides those that go on

  /// Takes over others, but for the places of their lenses' points and ratios.
  void copy(const ForwardTracks& others) {
    const auto [own_lens, own_ratios] = std::pair{lens, ratios};
    *this = others;
    lens = own_lens, ratios = own_ratios;
    std::ranges::copy(others.lens, lens.begin());
  }

  /// The numbers of a block of the event.
  std::array<T, 4>& numbers(std::uint32_t block) {
    return block == event_blocks[0] ? u : (block == event_blocks[1] ? choices : forced);
  }
};

/// Returns whether a route to a region leads by waves.
template <class T>
bool by_waves(const geometry::Slabs& sea, const geometry::Region<T>& region,
              geometry::Route route) {
  return !sea.surface.one_direction_each && geometry::meets_surface(region, route);
}

/// Returns whether a group of telescopes may see a point, by the points of the lenses that take
/// part in local estimates of single rays.
template <class T>
Mask<T> may_be_seen(const World<T>& world, std::size_t g, const Vec3<T>& position,
                    const Index<T>& line, const LensPoints<T>& lens) {
  const auto& telescope = world.instruments.groups[g].widest;
  if (!world.slabs.surface.one_direction_each) return Mask<T>(true);  // a steep facet may lead it
  return world.forward.single_rays
             ? transport::may_see(world.slabs, telescope, position, line, lens[g])
             : transport::may_see(world.slabs, telescope, position, line);
}

}  // namespace photic::estimator
