// Photons that come to the surface: the share of their weight that goes on.
#pragma once

#include "core/elementary.hpp"
#include "geometry/region.hpp"
#include "geometry/segment.hpp"
#include "medium/medium.hpp"
#include "surface/flat.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// Takes photons from a region of the air to the surface, as if it were flat; their weight takes
/// the air's share. Returns which get there; the others fly away and are left as they are.
template <class T>
Mask<T> come_down(const geometry::Region<T>& from, Photon<T>& photon) {
  const Mask<T> downward = photon.direction.z < T(0);
  const T distance = photon.position.z / -select(downward, photon.direction.z, T(-1));
  const Vec3<T> there = photon.position + distance * photon.direction;
  photon.position = select(downward, Vec3<T>{there.x, there.y, T(0)}, photon.position);
  photon.path = photon.path + select(downward, distance, T(0));
  if (from.column.exists()) [[unlikely]] {
    const T cosine = select(downward, T(0) - photon.direction.z, T(1));
    photon.path = photon.path + select(downward, from.delay(photon.line, cosine), T(0));
    photon.weight =
        photon.weight * select(downward, from.through_column(photon.line, cosine), T(1));
  }
  return downward;
}

/// The way up to the surface.
template <class T>
struct CameUp {
  Mask<T> rises{};  ///< the photons that come there
  geometry::Segment<T> way;
};
/// Takes photons in the water to the surface, without colliding: their weight takes the chance of
/// that. Photons that do not rise are left as they are.
template <class T>
CameUp<T> come_up(const geometry::Slabs& sea, Photon<T>& photon) {
  const Mask<T> rises = photon.direction.z > T(0);
  const T steep = select(rises, photon.direction.z, T(1));
  const T length = geometry::depth_of(photon.position) / steep;
  const auto way = geometry::to_surface(photon.line, geometry::level_of(sea, photon), length,
                                        geometry::Slant<T>::of_cosine(steep),
                                        geometry::Ray<T>{photon.position, photon.direction});
  const T tau = geometry::optical_depths(sea, way).all;
  const Vec3<T> there = photon.position + length * photon.direction;
  const T path = geometry::group_path(sea, way);
  photon.position = select(rises, Vec3<T>{there.x, there.y, T(0)}, photon.position);
  photon.path = photon.path + select(rises, path, T(0));
  photon.weight = photon.weight * select(rises, exp_minus(tau), T(1));
  photon.layer = select(rises, sea.row.surface_layer_at(there.x), photon.layer);
  return {rises, way};
}

/// Weight that comes to the surface and does not go down from there.
template <class T>
struct Leaving {
  T into_air{}, into_film{};
  Vec3<T> direction;  ///< of the light that goes up in the air
};

/// Takes a photon that comes down to the flat surface in the air into the water: its weight takes
/// the share that passes. Photons that do not come down go straight down, and mean nothing.
template <class T>
Leaving<T> refract_down(const medium::MediumView& sea, Photon<T>& photon) {
  Vec3<T> direction = photon.direction;
  direction.z = select(direction.z < T(0), direction.z, T(-1));
  const auto split = surface::flat_surface<T>(sea, photon.line).from_above(direction);
  const T passed = photon.weight * split.transmittance;
  Leaving<T> leaving{photon.weight - passed, T(0), split.reflected};
  if (sea.surface.absorbs) {
    leaving.into_air = photon.weight * split.reflectance;
    leaving.into_film = photon.weight * (T(1) - split.reflectance - split.transmittance);
  }
  photon.direction = split.transmitted;
  photon.weight = passed;
  return leaving;
}

/// Reflects a photon that stands at the surface back into the water: its weight takes the
/// reflectance, 1 in total reflection at bare water. Clear air returns nothing of what leaves.
/// Photons that are `lossless` keep all: of them it has been taken before.
template <class T>
Leaving<T> reflect_down(const medium::MediumView& sea, Photon<T>& photon,
                        const Mask<T>& lossless = Mask<T>(false)) {
  const auto split = surface::flat_surface<T>(sea, photon.line).from_below(photon.direction);
  const T r = select(lossless, T(1), split.reflectance);
  const T gone = photon.weight * (T(1) - r);
  Leaving<T> leaving{gone, T(0), split.transmitted};
  if (sea.surface.absorbs) {
    leaving.into_air = photon.weight * select(lossless, T(0), split.transmittance);
    leaving.into_film = gone - leaving.into_air;
  }
  photon.weight = photon.weight * r;
  photon.analog_weight = photon.analog_weight * r;
  photon.direction = split.reflected;
  return leaving;
}

}  // namespace photic::transport
