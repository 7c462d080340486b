// The weights of walks in environments, kept for each of their rays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/flatten.hpp"
#include "estimator/bidirectional/leg_terms.hpp"
#include "estimator/bidirectional/path_point.hpp"
#include "estimator/variations/environments.hpp"
#include "geometry/region.hpp"
#include "medium/medium.hpp"

namespace photic::estimator {

/// A walk of so many rays has as many slots, one behind the other.
template <class T>
class WalkRatios {
 public:
  WalkRatios(const medium::MediumView& sea, std::size_t slots)
      : ratios_(sea.environments, slots),
        at_surface_(sea.environments, sea.other_entry() ? slots : 0) {}

  /// The walks of a mask begin, in the slots of their first rays.
  PHOTIC_APART void begin(const medium::MediumView& sea, Index<T> slot, Mask<T> mask) {
    each(slot, mask, [&](std::size_t s, std::size_t) {
      ratios_.begin(sea.environments, s);
      if (sea.other_entry()) at_surface_.begin(sea.environments, s);
    });
  }
  /// They have come from their instrument to the surface, under a cosine to the vertical.
  PHOTIC_APART void came_down(const medium::MediumView& sea, const geometry::Region<T>& from,
                              Index<T> line, T cosine, Index<T> slot, Mask<T> mask) {
    if (!from.outside || !sea.environments.other_outside) return;
    Terms<T> ways;
    add_column(from, line, cosine, T(1), ways);
    pass(sea, at_surface_, ways, slot, mask);
  }
  /// They have flown so before their first ray begins.
  PHOTIC_APART void flown(const medium::MediumView& sea, geometry::Segment<T> way, Index<T> slot,
                          Mask<T> mask) {
    Terms<T> ways;
    add_segment(sea, way, ways);
    pass(sea, ratios_, ways, slot, mask);
  }
  /// They have met the surface behind the ray of a slot.
  PHOTIC_APART PHOTIC_FLATTEN void met(const medium::MediumView& sea, surface::FacetHit<T> meeting,
                                       Index<T> slot, Mask<T> mask) {
    if (!sea.surface.differs_in_environments) return;
    OtherSurfaces<T> met;
    met.meet(sea, meeting);
    each(slot, mask,
         [&](std::size_t s, std::size_t lane) { at_surface_.of(s).meet(sea, met, lane); });
  }
  /// They have left by a ray, to a vertex where they collide, and go on by the `next` one, in its
  /// slot. `back`: they are telescopes'.
  PHOTIC_APART void collided(const medium::MediumView& sea, Ray<T> left, Vertex<T> vertex,
                             Ray<T> next, bool back, Index<T> slot, Index<T> vertices,
                             Mask<T> mask) {
    Terms<T> way, collision;
    add_leg(sea, left, vertex, way);
    add_encounter(sea,
                  {vertex.line, vertex.layer, Mask<T>(!(vertex.line == next.line)), vertex.line,
                   one_minus_cos(vertex.direction, next.direction),
                   back ? next.direction.z : T(-vertex.direction.z)},
                  collision);
    const auto before = each_lane(vertices);
    each(slot, mask, [&](std::size_t s, std::size_t lane) {
      if (before[lane] == 2) {
        ratios_.begin(sea.environments, s);
      } else {
        ratios_.copy(sea.environments, s - 1, s);
      }
      const auto ratios = ratios_.of(s);
      ratios.pass(sea.environments, way, lane);
      ratios.collide(sea.environments, collision, lane);
      if (!sea.other_entry()) return;
      ratios.join(sea.environments, at_surface_.of(s - 1));
      at_surface_.begin(sea.environments, s);
    });
  }

  /// Product and depth of a walk up to where it leaves by a ray, beyond the second ray without the
  /// part before it, which a free walk has anew: for environments from `first` on.
  [[nodiscard]] std::array<T, 2> at(std::size_t slot, std::int32_t first) const {
    return ratios_.at(slot, first);
  }
  /// The same of the surface on its way from there to the next vertex; of the first ray also of the
  /// air between the instrument and the surface.
  [[nodiscard]] std::array<T, 2> at_surface(std::size_t slot, std::int32_t first) const {
    return at_surface_.at(slot, first);
  }
  /// Bytes for each slot.
  static std::size_t size(const medium::MediumView& sea) {
    return (sea.other_entry() ? 2 : 1) * PathRatios<T>::size(sea.environments);
  }

 private:
  /// Calls act(slot, lane) for the lanes of a mask.
  template <class Act>
  static void each(const Index<T>& slot, const Mask<T>& mask, Act act) {
    const auto slots = each_lane(slot);
    for_each_lane(mask, [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      act(static_cast<std::size_t>(slots[k]), k);
    });
  }
  static void pass(const medium::MediumView& sea, PathRatios<T>& ratios, const Terms<T>& ways,
                   const Index<T>& slot, const Mask<T>& mask) {
    each(slot, mask,
         [&](std::size_t s, std::size_t lane) { ratios.of(s).pass(sea.environments, ways, lane); });
  }

  PathRatios<T> ratios_;      ///< of each ray
  PathRatios<T> at_surface_;  ///< of each vertex, if surfaces differ
};

}  // namespace photic::estimator
