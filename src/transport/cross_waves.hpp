// Light that meets facets of a rough surface, and whitecaps.
#pragma once

#include "surface/lambert.hpp"
#include "surface/waves.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// Light at the surface: it comes down to it in the air, or rises to it in the water.
template <class T>
struct AtWaves {
  Mask<T> meets{};   ///< who is about to meet a facet
  Mask<T> in_air{};  ///< who does so from above; the others from below
};
/// What became of those who met one.
template <class T>
struct AfterFacet {
  Mask<T> in_water{};  ///< who goes down in the water
  Mask<T> left{};      ///< who rises in the air, where weights do not split
  T escaped{};         ///< weight that rises in the air
  T gained{};          ///< weight less what it was, before that is taken off
};

/// Uniforms of one meeting.
template <class T>
struct WavesUniforms {
  T slope, azimuth, choice, whitecap;
};

/// Has photons meet a facet or a whitecap. Those who then neither go down in the water nor rise in
/// the air are between facets: they are about to meet another one. Chance decides whether they go
/// through. Where `splits`, of two ways of which one leads away from the surface in the air the
/// other is taken, and the weight is shared out.
template <class T>
AfterFacet<T> meet_waves(const surface::RoughSurface<T>& surface, Photon<T>& photon, AtWaves<T>& at,
                         const WavesUniforms<T>& u, bool splits) {
  const auto& waves = surface.waves;
  const Mask<T> in_air = at.in_air;
  const auto facet = surface::facet_of(waves, surface::sample_slope(waves, u.slope, u.azimuth));
  const T visible = surface::visibility(photon.direction, facet);
  const T n1 = select(in_air, T(1), surface.n), n2 = select(in_air, surface.n, T(1));
  const auto by_facet = surface::meet_facet(n1, n2, photon.direction, facet);
  Vec3<T> back = by_facet.reflected, through = by_facet.transmitted;
  T reflectance = by_facet.reflectance;
  T seen = select(visible > T(0), visible, T(0)) * surface::series(waves, facet.slope);
  if (waves.whitecap_fraction > 0) {
    const Mask<T> white = u.whitecap < surface.white.fraction;
    const auto [cosine, sine] = cos_sin_of_turns(u.azimuth);
    const Vec3<T> up =
        turned(Vec3<T>{T(0), T(0), T(1)}, surface::lambert_one_minus_cos(u.slope), cosine, sine);
    const Vec3<T> down{up.x, up.y, -up.z};
    back = select(white, select(in_air, up, down), back);
    through = select(white, select(in_air, down, up), through);
    reflectance = select(white, select(in_air, surface.white.from_above, surface.white.from_below),
                         reflectance);
    seen = select(white, T(1), seen);
  }
  // `down`: the way that leads into the water, or back into it; `up` into the air.
  const Vec3<T> down = select(in_air, through, back), up = select(in_air, back, through);
  const T share_down = select(in_air, T(1) - reflectance, reflectance);
  const Mask<T> rises = up.z > T(0);
  const Mask<T> leaves = splits ? rises : Mask<T>(false);
  const Mask<T> goes_down = leaves | (u.choice < share_down);

  AfterFacet<T> met;
  const T weight = photon.weight * seen;
  met.gained = weight - photon.weight;
  met.escaped = select(leaves, weight * (T(1) - share_down), T(0));
  const T kept = select(leaves, share_down, T(1));
  const Vec3<T> direction = select(goes_down, down, up);
  met.in_water = at.meets & goes_down & (direction.z < T(0));
  met.left = at.meets & !goes_down & rises;
  at.in_air = !goes_down;
  const T between = T(1) / (T(1) + surface::smith(waves, direction));
  photon.direction = select(at.meets, direction, photon.direction);
  photon.weight = select(at.meets, weight * kept, photon.weight);
  photon.analog_weight = photon.analog_weight * select(at.meets, kept, T(1));
  at.meets = at.meets & !(met.in_water | met.left);
  met.gained = met.gained + select(at.meets, photon.weight * (between - T(1)), T(0));
  photon.weight = photon.weight * select(at.meets, between, T(1));
  return met;
}

}  // namespace photic::transport
