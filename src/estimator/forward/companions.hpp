// The companions of a history's light, which change by the events of its way: its weight in
// environments, and a world's Companion. These functions are called at the same points of every
// event. Where nothing travels with the light (PlainEvents) they cost nothing.
#pragma once

#include <cstdint>

#include "estimator/variations/ratios.hpp"
#include "estimator/world.hpp"

namespace photic::estimator {

template <class Events, class T>
class Companions {
 public:
  Companions(const World<T>& world, Ratios<T>& ratios) : world_(world), ratios_(ratios) {}

  /// The photons as they are before they fly or collide.
  void before(const transport::Photon<T>& photon) const {
    if constexpr (Events::variations) ratios_.before = photon;
  }
  /// Photons of a mask have come down from an instrument to the surface.
  void came_down(const geometry::Region<T>& from, const transport::Photon<T>& photon,
                 const Mask<T>& mask) const {
    if (in_environments())
      ratios_.came_down(world_.slabs, from, photon.line, photon.direction, mask);
  }
  /// They have flown so far in the water.
  void flown(const transport::Photon<T>& after, const T& length, const Mask<T>& mask) const {
    if (in_environments()) ratios_.flown(world_.slabs, after, length, mask);
    if (Events::variations && world_.companion) world_.companion->flown(after, length, mask);
  }
  /// They were scattered or converted where they stand.
  void collided(const transport::Photon<T>& after, const Mask<T>& mask) const {
    if (in_environments()) ratios_.collided(world_.slabs, after, mask);
    if (Events::variations && world_.companion)
      world_.companion->collided(ratios_.before, after, mask);
  }
  /// They have come to a surface that sends light on in one direction on each side.
  void crossed(const Index<T>& line, std::int32_t way, const T& cosine, const Mask<T>& mask) const {
    if (in_environments() && world_.slabs.environments.other_film)
      ratios_.crossed(world_.slabs, {line, Index<T>(way), cosine}, mask);
  }
  /// The same of light that passes it, by a film or a facet.
  void passed(const surface::FilmCrossing<T>& by, const Mask<T>& mask) const {
    crossed(by.line, medium::through_film, by.cosine, mask);
  }
  void passed(const surface::FacetHit<T>& by, const Mask<T>& mask) const { met(by, mask); }
  /// They have met a facet of it.
  void met(const surface::FacetHit<T>& meeting, const Mask<T>& mask) const {
    if (in_environments() && world_.slabs.surface.differs_in_environments)
      ratios_.met(world_.slabs, meeting, mask);
  }
  /// A part of the light goes another way than the rest: change() notes by which, and take() takes
  /// along what travels with it. Then all is as before.
  template <class Change, class Take>
  void apart(const Mask<T>& mask, Change change, Take take) const {
    if (!in_environments()) return take();
    PathRatios<T> kept(world_.slabs.environments, lanes_of<T>);
    const auto each = [&](auto act) {
      for_each_lane(mask, [&](int lane) {
        act(static_cast<std::size_t>(lane), ratios_.first + static_cast<std::size_t>(lane));
      });
    };
    each([&](std::size_t lane, std::size_t path) {
      kept.copy(world_.slabs.environments, *ratios_.paths, path, lane);
    });
    change();
    take();
    each([&](std::size_t lane, std::size_t path) {
      ratios_.paths->copy(world_.slabs.environments, kept, lane, path);
    });
  }
  /// A film has emitted their light.
  void emitted(const surface::AtFilm<T>& at, const Index<T>& line, const Vec3<T>& direction,
               bool up, const Mask<T>& mask) const {
    if (in_environments() && any(mask))
      ratios_.emitted(world_.slabs, at, line, direction, up, mask);
  }

 private:
  [[nodiscard]] bool in_environments() const { return has_environments<Events>(world_); }

  const World<T>& world_;
  Ratios<T>& ratios_;
};

/// Those of photons on their way.
template <class Events, class T, class Tracks>
Companions<Events, T> companions_of(const World<T>& world, Tracks& t) {
  return {world, t.ratios};
}

}  // namespace photic::estimator
