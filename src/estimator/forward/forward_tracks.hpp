// Photons of the forward estimator on their way, and what they carry from one stage of an event to
// the next.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "estimator/event.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/variations/ratios.hpp"
#include "estimator/world.hpp"
#include "transport/collide.hpp"
#include "transport/connect.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

/// Directed sampling aims at no more ways than this; telescopes beyond have to do with the light of
/// the others.
inline constexpr int target_capacity = 16;
template <class T>
using Targets = transport::Targets<T, target_capacity>;

/// Photons on their way, one in each lane, and the event that they are in.
template <class T>
struct ForwardTracks : Track<T> {
  explicit ForwardTracks(const World<T>& world)
      : place{world.key, {}, {}}, lens(world.single_rays ? world.groups.size() : 0) {}

  RandomPlace<T> place;
  Index<T> spectral_bin{};                      ///< in which lines it emits
  std::vector<instrument::PlanePoint<T>> lens;  ///< the point of each group's lens that takes part
                                                ///< in local estimates of single rays
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

  /// The numbers of a block of the event.
  std::array<T, 4>& numbers(std::uint32_t block) {
    return block == event_blocks[0] ? u : (block == event_blocks[1] ? choices : forced);
  }
};

/// Returns whether a route to a region leads by waves.
template <class T>
bool by_waves(const World<T>& world, const geometry::Region<T>& region, geometry::Route route) {
  return !world.sea.surface.one_direction_each && geometry::meets_surface(region, route);
}

/// Returns whether a group of telescopes may see a point, by the points of the lenses that take
/// part in local estimates of single rays.
template <class T>
Mask<T> may_be_seen(const World<T>& world, std::size_t g, const Vec3<T>& position,
                    const Index<T>& line, const std::vector<instrument::PlanePoint<T>>& lens) {
  const auto& telescope = world.groups[g].widest;
  if (!world.sea.surface.one_direction_each) return Mask<T>(true);  // a steep facet may lead it
  return world.single_rays ? transport::may_see(world.sea, telescope, position, line, lens[g])
                           : transport::may_see(world.sea, telescope, position, line);
}

}  // namespace photic::estimator
