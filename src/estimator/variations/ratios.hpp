// The walk of photons of the forward estimator, in environments.
#pragma once

#include <cstddef>

#include "core/flatten.hpp"
#include "estimator/variations/environments.hpp"
#include "estimator/variations/other_films.hpp"
#include "estimator/variations/other_surfaces.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

/// The numbers of photons on their walk, and all that is needed to update them. Arguments passed by
/// value stay in the registers of scenes that have no environments.
template <class T>
struct Ratios {
  PathRatios<T>* paths = nullptr;
  std::size_t first = 0;        ///< path of the first lane
  transport::Photon<T> before;  ///< before the event
  Terms<T> terms;
  OtherSurfaces<T> surface;
  OtherEmission<T> emission;

  /// The photons of a mask have flown so far.
  PHOTIC_APART PHOTIC_FLATTEN void flown(const medium::MediumView& sea, transport::Photon<T> after,
                                         T length, Mask<T> mask) {
    terms.clear();
    add_segment(sea,
                {before.line, geometry::level_of(sea, before), geometry::level_of(sea, after),
                 length, geometry::Ray<T>{before.position, before.direction}},
                terms);
    pass(sea, mask);
  }
  /// Notes that photons of a mask were scattered or converted where they stand.
  PHOTIC_APART PHOTIC_FLATTEN void collided(const medium::MediumView& sea,
                                            transport::Photon<T> after, Mask<T> mask) {
    terms.clear();
    add_encounter(sea,
                  {before.line, before.layer, Mask<T>(!(before.line == after.line)), after.line,
                   one_minus_cos(before.direction, after.direction), T(-before.direction.z)},
                  terms);
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      paths->of(first + i).collide(sea.environments, terms, i);
    });
  }
  /// Notes that photons of a mask have come to a flat film, as `crossing` states.
  PHOTIC_APART PHOTIC_FLATTEN void crossed(const medium::MediumView& sea, FilmCrossing<T> crossing,
                                           Mask<T> mask) {
    terms.clear();
    add_flat_film(sea, crossing, terms);
    pass(sea, mask);
  }
  /// Notes that photons of a mask have come from an instrument in a region to the surface, in a
  /// direction.
  PHOTIC_APART PHOTIC_FLATTEN void came_down(const medium::MediumView& sea,
                                             geometry::Region<T> region, Index<T> line,
                                             Vec3<T> direction, Mask<T> mask) {
    if (region.column.excess < 0) return;
    terms.clear();
    add_column(region, line, T(T(0) - direction.z), T(1), terms);
    pass(sea, mask);
  }
  /// A film has emitted the light of those of a mask.
  PHOTIC_APART PHOTIC_FLATTEN void emitted(const medium::MediumView& sea, surface::AtFilm<T> at,
                                           Index<T> line, Vec3<T> direction, bool up,
                                           Mask<T> mask) {
    emission.emit(sea, at, line, direction, up);
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      paths->of(first + i).meet(sea, emission, i);
    });
    if (sea.surface.differs_in_environments)
      met(sea, surface::meeting_by_emission(sea.waves, at.normal), mask);
  }
  /// Notes that photons of a mask have met the surface.
  PHOTIC_APART PHOTIC_FLATTEN void met(const medium::MediumView& sea, surface::FacetHit<T> meeting,
                                       Mask<T> mask) {
    surface.meet(sea, meeting);
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      paths->of(first + i).meet(sea, surface, i);
    });
  }

 private:
  /// They have gone ways of these terms.
  void pass(const medium::MediumView& sea, const Mask<T>& mask) const {
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      paths->of(first + i).pass(sea.environments, terms, i);
    });
  }
};

}  // namespace photic::estimator
