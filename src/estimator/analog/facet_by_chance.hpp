// An analog photon at an oily facet of a rough sea: it goes through the facet's film as through a
// flat one (film_by_chance.hpp), in the facet's own frame.
#pragma once

#include <cstdint>

#include "estimator/analog/film_by_chance.hpp"
#include "surface/waves.hpp"
#include "transport/meet_waves.hpp"

namespace photic::estimator {

/// The axes of a facet: two along it, and its normal.
template <class T>
struct FacetFrame {
  explicit FacetFrame(const Vec3<T>& up) : normal(up) {
    const T per = T(1) / (T(1) + up.z);  // facets look upwards
    const T xy = T(0) - up.x * up.y * per;
    first = {T(1) - up.x * up.x * per, xy, T(0) - up.x};
    second = {xy, T(1) - up.y * up.y * per, T(0) - up.y};
  }
  [[nodiscard]] Vec3<T> into(const Vec3<T>& v) const {
    return {dot(v, first), dot(v, second), dot(v, normal)};
  }
  [[nodiscard]] Vec3<T> out_of(const Vec3<T>& v) const {
    return v.x * first + v.y * second + v.z * normal;
  }

  Vec3<T> first, second, normal;
};

/// The fate of photons that met an oily facet.
template <class T>
struct AfterOilyFacet : transport::AfterFacet<T> {
  Mask<T> emitted{};  ///< those whose light the film has emitted
  T weight{};         ///< with which they met it
};

/// Has photons meet oily facets. They keep the weight by which facets are met more or less densely
/// than they are drawn; all else is left to chance. `facet`: its number in the event.
template <class T>
AfterOilyFacet<T> facet_by_chance(const medium::MediumView& sea, const RandomPlace<T>& place,
                                  const Index<T>& spectral_bin, std::uint32_t facet,
                                  transport::Photon<T>& photon, transport::AtWaves<T>& at,
                                  bool conserved) {
  const auto u = uniforms(place, facet_blocks[facet]);
  const auto by = transport::facet_met(sea.waves, photon.direction, u[0], u[1], conserved);
  AfterOilyFacet<T> met;
  met.gained = photon.weight * (by.gain - T(1));
  photon.weight = select(at.meets, photon.weight * by.gain, photon.weight);
  met.weight = photon.weight;
  const Mask<T> meets = at.meets & (by.gain > T(0));
  const FacetFrame<T> frame(by.facet.normal);
  transport::Photon<T> turned = photon;
  turned.direction = frame.into(photon.direction);
  const auto from_above =
      film_by_chance(sea, place, spectral_bin, Mask<T>(meets & at.outside), true, turned, facet);
  const auto from_below =
      film_by_chance(sea, place, spectral_bin, Mask<T>(meets & !at.outside), false, turned, facet);
  const Mask<T> up = from_above.up | from_below.up, down = from_above.down | from_below.down;
  met.emitted = from_above.emitted | from_below.emitted;
  const Vec3<T> direction = frame.out_of(turned.direction);
  photon.direction = select(meets, direction, photon.direction);
  photon.line = select(meets, turned.line, photon.line);
  photon.order = select(meets, turned.order, photon.order);
  const Mask<T> absorbed = meets & !(up | down);
  met.into_film = select(absorbed, photon.weight, T(0));
  photon.weight = select(absorbed, T(0), photon.weight);
  met.in_water = down & (photon.direction.z < T(0));
  met.left = up & (photon.direction.z > T(0));
  at.outside = up;
  at.meets = meets & (up | down) & !(met.in_water | met.left);
  const T between =
      select(at.meets, transport::share_between_facets(sea.waves, photon.direction), T(1));
  met.gained = met.gained + photon.weight * (between - T(1));
  photon.weight = photon.weight * between;
  return met;
}

}  // namespace photic::estimator
