// Light that meets facets of a rough surface, and whitecaps.
#pragma once

#include "surface/lambert.hpp"
#include "surface/waves.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// Light at the surface: it comes down to it in the air, or rises to it in the water.
template <class T>
struct AtWaves {
  Mask<T> meets{};    ///< the photons about to meet a facet
  Mask<T> outside{};  ///< those that do so from above; the others from below
};
/// The fate of photons that met one.
template <class T>
struct AfterFacet {
  Mask<T> in_water{};  ///< those that go down in the water
  Mask<T> left{};      ///< those that rise in the air, where weights do not split
  T escaped{};         ///< weight that rises in the air ...
  Vec3<T> risen;       ///< ... in this direction
  T into_film{};       ///< weight that a film of oil absorbs
  T gained{};          ///< weight less what it was, before that is taken off
  surface::FacetHit<T> meeting;
  /// Where weights do not split: the likelihood that a walk the other way (waves_back.hpp) draws
  /// this facet and goes on as this light has come, over the likelihood of this light's own draws.
  T chance_back{1};
};

/// The chance that a walk which goes the way of light backwards, and could leave the surface into
/// the water, goes on to one more facet.
inline constexpr double further_facet = 0.1;

/// Uniforms of one meeting.
template <class T>
struct WavesUniforms {
  T slope, azimuth, choice, whitecap;
};

/// The two ways on from a facet or a whitecap: one into the water, or back into it, one into the
/// air, or back there. Not all lead to the right side of the surface.
template <class T>
struct WaysOn {
  Vec3<T> down, up;
  T share_down{};   ///< of the light, with all that does not pass as if it were reflected
  T unabsorbed{1};  ///< of what does not pass: the share that is reflected
  T gain{};         ///< of the weight: how densely facets are met over how they are drawn
  surface::Facet<T> facet;
  T seen{};               ///< visibility of that facet
  Mask<T> meets_white{};  ///< a whitecap is met, and no facet
};
/// A direction in which whitecaps send light upwards.
template <class T>
Vec3<T> up_from_whitecap(const WavesUniforms<T>& u) {
  const auto [cosine, sine] = cos_sin_of_turns(u.azimuth);
  return turned(Vec3<T>{T(0), T(0), T(1)}, surface::lambert_one_minus_cos(u.slope), cosine, sine);
}
/// The share of its weight that light carries between two facets (docs/theory.md, section 14):
/// without it the sum over the facets that it meets has no mean.
template <class T>
T share_between_facets(const surface::WavesView& waves, const Vec3<T>& direction) {
  if (waves.conserving) return T(1) / surface::mean_visibility(waves, direction);
  return T(1) / (T(1) + surface::smith(waves, direction));
}

/// A facet that light meets, and how densely it is met over how it is drawn: 0 where it cannot be.
template <class T>
struct FacetMet {
  surface::Facet<T> facet;
  T seen{};  ///< its visibility
  T gain{};
};
/// `conserved`: the weight is over its mean, so that no light is gained.
template <class T>
FacetMet<T> facet_met(const surface::WavesView& waves, const Vec3<T>& direction, const T& u1,
                      const T& u2, bool conserved = false) {
  FacetMet<T> met;
  met.facet = surface::facet_of(waves, surface::sample_slope(waves, u1, u2));
  met.seen = surface::visibility(direction, met.facet);
  met.gain = select(met.seen > T(0), met.seen, T(0)) * surface::series(waves, met.facet.slope);
  if (conserved) met.gain = met.gain / surface::mean_visibility(waves, direction);
  return met;
}
template <class T>
WaysOn<T> ways_on(const surface::RoughSurface<T>& surface, const Vec3<T>& direction,
                  const Mask<T>& outside, const WavesUniforms<T>& u, bool conserved) {
  const auto& waves = surface.waves;
  const auto [facet, seen, gain] = facet_met(waves, direction, u.slope, u.azimuth, conserved);
  const T n1 = select(outside, T(1), surface.n), n2 = select(outside, surface.n, T(1));
  const auto at = surface::meet_facet(surface.face, n1, n2, direction, facet);
  WaysOn<T> out{select(outside, at.transmitted, at.reflected),
                select(outside, at.reflected, at.transmitted),
                select(outside, at.transmittance, T(1) - at.transmittance),
                T(1),
                gain,
                facet,
                seen,
                Mask<T>(false)};
  if (surface.face.oily) out.unabsorbed = at.reflected_of_rest();
  if (waves.whitecap_fraction == 0) return out;
  const auto& white = surface.white;
  const Mask<T> meets_white = out.meets_white = u.whitecap < white.fraction;
  const Vec3<T> up = up_from_whitecap(u);
  out.down = select(meets_white, Vec3<T>{up.x, up.y, -up.z}, out.down);
  out.up = select(meets_white, up, out.up);
  out.share_down = select(meets_white, select(outside, T(1) - white.from_above, white.from_below),
                          out.share_down);
  out.gain = select(meets_white, T(1), out.gain);
  out.unabsorbed = select(meets_white, T(1), out.unabsorbed);
  return out;
}

/// Has photons meet a facet or a whitecap. Photons without weight meet no more. Photons that then
/// neither go down in the water nor rise in the air are between facets: they are about to meet
/// another one. Chance decides between the ways. Where `splits`, if one way leads away from the
/// surface in the air the other one is taken, and the weight is shared out. `conserved`: see
/// facet_met(); light between two facets is always so.
template <class T>
AfterFacet<T> meet_waves(const surface::RoughSurface<T>& surface, Photon<T>& photon, AtWaves<T>& at,
                         const WavesUniforms<T>& u, bool splits, bool conserved = false) {
  const auto way = ways_on(surface, photon.direction, at.outside, u, conserved);
  const auto& [down, up, share_down, unabsorbed, gain, facet, seen, meets_white] = way;
  const Mask<T> rises = up.z > T(0);
  const Mask<T> leaves = splits ? rises : Mask<T>(false);
  const Mask<T> goes_down = leaves | (u.choice < share_down);
  const Vec3<T> direction = select(goes_down, down, up);
  const T weight = photon.weight * gain;
  T kept = select(leaves, share_down, T(1));

  AfterFacet<T> met;
  met.gained = weight - photon.weight;
  met.escaped = select(leaves, weight * (T(1) - share_down), T(0));
  met.risen = up;
  if (surface.face.oily) {
    const T share_back = select(at.outside, T(1) - share_down, share_down);
    met.into_film = weight * share_back * (T(1) - unabsorbed);
    met.escaped = met.escaped * select(at.outside, unabsorbed, T(1));
    const Mask<T> goes_back = (at.outside & !goes_down) | (goes_down & !at.outside);
    kept = kept * select(goes_back, unabsorbed, T(1));
  }
  met.in_water = at.meets & goes_down & (direction.z < T(0));
  met.left = at.meets & !goes_down & rises;
  const Mask<T> came_from_air = at.outside;
  const Vec3<T> came = photon.direction;
  photon.direction = select(at.meets, direction, photon.direction);
  photon.weight = select(at.meets, weight * kept, photon.weight);
  photon.analog_weight = photon.analog_weight * select(at.meets, kept, T(1));

  at.outside = !goes_down;
  at.meets = at.meets & !(met.in_water | met.left);
  const T between = select(at.meets, share_between_facets(surface.waves, direction), T(1));
  met.gained = met.gained + photon.weight * (between - T(1));
  met.meeting = {
      facet.slope, select(meets_white, T(1), T(0)), select(at.meets, direction, Vec3<T>{}), {}};
  if (surface.face.oily) {
    const Mask<T> passes = (came_from_air & goes_down) | !(came_from_air | goes_down);
    met.meeting.film =
        surface::film_crossing(surface.line, came_from_air, passes, came, direction, facet.normal);
  }
  using std::abs;
  const T back = abs(surface::visibility(direction, facet));
  met.chance_back =
      select(meets_white | !(back > T(0)), T(1), seen / select(back > T(0), back, T(1)));
  met.chance_back =
      met.chance_back * select(met.in_water, T(1 - further_facet),
                               select(at.meets & !at.outside, T(further_facet), T(1)));
  photon.weight = photon.weight * between;
  const Mask<T> lit = photon.weight > T(0);
  met.in_water = met.in_water & lit;
  at.meets = at.meets & lit;
  return met;
}

/// The meeting of the light that is split off and leaves, where the rest goes on as `met` states.
template <class T>
surface::FacetHit<T> hit_of_risen(const surface::WavesView& waves, const AfterFacet<T>& met) {
  using std::abs;
  surface::FacetHit<T> hit = met.meeting;
  hit.between = {};
  // Light from outside that the film lets pass goes down: what leaves is reflected by it.
  const Mask<T> from_outside = hit.film.way == Index<T>(medium::through_film);
  const T along = abs(dot(met.risen, surface::facet_of(waves, hit.slope).normal));
  hit.film.cosine = select(from_outside, along, hit.film.cosine);
  hit.film.way =
      select(from_outside, Index<T>(medium::back_into_air), Index<T>(medium::through_film));
  return hit;
}

}  // namespace photic::transport
