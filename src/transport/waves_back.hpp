// The way of light from facet to facet of a rough surface, followed backwards: by walks that begin
// at telescopes (docs/theory.md, "The rough surface").
//
// Light that a facet sends to the wrong side of the mean surface meets another facet
// (meet_waves.hpp). Backwards, a walk may thus have come from any facet that sends it to the right
// side: it leaves the surface there, or goes on to a facet so steep that light from the wrong side
// has come from it.
#pragma once

#include "surface/waves.hpp"
#include "transport/meet_waves.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// A walk at the surface.
template <class T>
struct BackAtWaves {
  Mask<T> meets{};    ///< the walks about to meet a facet
  Mask<T> outside{};  ///< those beyond the surface
  Mask<T> leaving{};  ///< those that could have left the surface, and go on to a steeper facet
};
template <class T>
struct AfterFacetBack {
  Mask<T> in_water{};  ///< those that leave the surface, down in the water
  T chance{1};         ///< to have gone so over the chance that light goes the other way
  surface::FacetHit<T> meeting;
};

/// The chance, at least, with which the first facet sends a walk back that is to return.
inline constexpr double sent_back = 0.9;

/// The way on that chance decides for.
template <class T>
struct WayBack {
  Vec3<T> direction;
  Mask<T> outside{};
  T gain{};     ///< of the weight
  T chance{1};  ///< as of AfterFacetBack
  surface::Slope<T> slope{};
  surface::FilmCrossing<T> film{};
};
/// From a facet. `returns`: most are to be sent back.
template <class T>
WayBack<T> back_from_facet(const surface::RoughSurface<T>& surface, const Vec3<T>& before,
                           const BackAtWaves<T>& at, const WavesUniforms<T>& u, bool returns) {
  using std::abs;
  const auto& waves = surface.waves;
  const auto facet = surface::facet_of(waves, surface::sample_slope(waves, u.slope, u.azimuth));
  const T met = surface::visibility(before, facet);
  const T seen = select(at.leaving, T(0) - met, met);
  const Mask<T> exists = seen > T(0);
  const T n1 = select(at.outside, T(1), surface.n), n2 = select(at.outside, surface.n, T(1));
  const auto by = surface::meet_facet(surface.face, n1, n2, before, facet);
  const T back = T(1) - by.transmittance;
  const T drawn = returns ? select(back > T(sent_back), back, T(sent_back)) : back;
  const Mask<T> reflects = u.choice < drawn;
  WayBack<T> way;
  way.slope = facet.slope;
  way.direction = select(reflects, by.reflected, by.transmitted);
  way.outside = (at.outside & reflects) | !(at.outside | reflects);
  // Light that passes takes (n_i / n_t)^2 along: a walk from a telescope carries étendue.
  const T passes = (n1 / n2) * (n1 / n2);
  way.gain = select(exists, seen, T(0)) * surface::series(waves, facet.slope) *
             select(reflects, T(1), passes);
  if (returns)
    way.gain = way.gain * select(reflects, back / drawn, by.transmittance / (T(1) - drawn));
  if (surface.face.oily) {
    way.gain = way.gain * select(reflects, by.reflected_of_rest(), T(1));
    // The light's direction: the other way.
    way.film = surface::film_crossing(surface.line, way.outside, Mask<T>(!reflects), way.direction,
                                      before, facet.normal);
  }
  way.chance = abs(surface::visibility(way.direction, facet)) / select(exists, seen, T(1));
  return way;
}
/// From a whitecap. They send no light to the wrong side: no walk comes to them that could have
/// left.
template <class T>
WayBack<T> back_from_whitecap(const surface::RoughSurface<T>& surface, const BackAtWaves<T>& at,
                              const WavesUniforms<T>& u) {
  const auto& white = surface.white;
  const Mask<T> reflects = u.choice < select(at.outside, white.from_above, white.from_below);
  const Vec3<T> up = up_from_whitecap(u);
  const T n1 = select(at.outside, T(1), surface.n), n2 = select(at.outside, surface.n, T(1));
  WayBack<T> way;
  way.outside = (at.outside & reflects) | !(at.outside | reflects);
  way.direction = select(way.outside, up, Vec3<T>{up.x, up.y, -up.z});
  way.gain = select(at.leaving, T(0), select(reflects, T(1), T((n1 / n2) * (n1 / n2))));
  return way;
}

/// Has walks meet a facet or a whitecap. `u_leaves`: a uniform. `must`: all go on to a further
/// facet; `returns`: most are to be sent back, and their chance is not known.
template <class T>
AfterFacetBack<T> meet_waves_back(const surface::RoughSurface<T>& surface, Photon<T>& photon,
                                  BackAtWaves<T>& at, const WavesUniforms<T>& u, const T& u_leaves,
                                  bool must, bool returns) {
  auto way = back_from_facet(surface, photon.direction, at, u, returns);
  AfterFacetBack<T> out;
  out.meeting.slope = way.slope;
  out.meeting.film = way.film;
  if (surface.waves.whitecap_fraction > 0) {
    const Mask<T> white = u.whitecap < surface.white.fraction;
    const auto by = back_from_whitecap(surface, at, u);
    way.direction = select(white, by.direction, way.direction);
    way.outside = (white & by.outside) | (way.outside & !white);
    way.gain = select(white, by.gain, way.gain);
    way.chance = select(white, by.chance, way.chance);
    out.meeting.by_whitecaps = select(white, T(1), T(0));
  }
  const Mask<T> goes_on =
      must ? Mask<T>(true) : Mask<T>(way.outside | (u_leaves < T(further_facet)));
  const T chosen =
      must ? T(1)
           : select(way.outside, T(1), select(goes_on, T(further_facet), T(1 - further_facet)));
  const T between =
      select(goes_on, T(1) / (T(1) + surface::smith(surface.waves, way.direction)), T(1));
  const T upwards = select(way.outside, way.direction.z, T(0) - way.direction.z);
  const Mask<T> lit = at.meets & (upwards > T(0)) & (way.gain > T(0));
  photon.direction = select(at.meets, way.direction, photon.direction);
  photon.weight =
      photon.weight * select(at.meets, select(lit, way.gain * between / chosen, T(0)), T(1));
  out.meeting.between = select(goes_on, way.direction, Vec3<T>{});
  out.chance = select(lit, way.chance * chosen, T(1));
  out.in_water = lit & !goes_on;
  at.outside = way.outside;
  at.leaving = at.leaving | lit;
  at.meets = lit & goes_on;
  return out;
}

}  // namespace photic::transport
