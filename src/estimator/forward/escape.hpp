// The chance that a flight leaves the water, for flights that are not to: through the surface, or
// onto a black sea bed.
#pragma once

#include <cmath>

#include "core/elementary.hpp"
#include "geometry/segment.hpp"
#include "medium/medium.hpp"
#include "surface/flat.hpp"
#include "transport/photon.hpp"

namespace photic::estimator {

template <class T>
struct Escape {
  Mask<T> surface;  ///< the way out: through the surface, or else onto the black sea bed
  T probability{};  ///< by the coefficient that free paths are drawn from
  T weight{};       ///< of the light that leaves
};

/// The escape of a photon in the water on its next flight. Light that the surface reflects stays.
template <class T>
Escape<T> escape(const geometry::Slabs& sea, const transport::Photon<T>& photon) {
  using std::abs;
  const T down = -photon.direction.z;
  const auto at = geometry::level_of(sea, photon);
  const auto above = geometry::optical_depths(
      sea, geometry::to_surface(photon.line, at, at.depth, geometry::Slant<T>{}));
  const Mask<T> level = down == T(0);
  const T slant = T(1) / select(level, T(1), abs(down));
  Escape<T> out;
  out.surface = down < T(0);
  const auto chance = [&](const T& to_surface, const T& to_bed) {
    return exp_minus(slant * select(out.surface, to_surface, to_bed - to_surface));
  };
  const T rises = select(out.surface, photon.direction.z, T(1));
  const T reflectance = surface::flat_surface<T>(sea, photon.line).reflectance(rises);
  const T onto_bed(sea.bed_angles > 0 ? 0 : 1);
  const T transmitted = select(level, T(0), select(out.surface, T(1) - reflectance, onto_bed));
  out.probability = transmitted * chance(above.walk, gather<T>(sea.by_walk_tau.end, photon.line));
  out.weight = photon.weight * transmitted * chance(above.all, gather<T>(sea.bed_tau, photon.line));
  return out;
}

}  // namespace photic::estimator
