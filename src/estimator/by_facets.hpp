// Walks of the bidirectional estimator that meet facets of a rough surface one by one: the laser's
// as light does, telescopes' backwards.
#pragma once

#include <cstdint>

#include "estimator/cross_waves.hpp"
#include "estimator/random_blocks.hpp"
#include "transport/cross_waves.hpp"
#include "transport/waves_back.hpp"

namespace photic::estimator {

/// The fate of walks that stood at the surface.
template <class T>
struct ByFacets {
  Mask<T> in_water{};  ///< walks that go down in the water
  Mask<T> several{};   ///< by way of more than one facet
  /// A telescope's walk's chance to go so over that of the laser's.
  T chance{1};
  T into_film{};  ///< weight of the laser's walks that a film of oil has absorbed
};

/// The facets that walks are to meet: several, by which they come down from the air; or such that
/// send them back into the water, most of them at once. Their weight takes the chance of that.
enum class Facets : std::int8_t { any, several, that_return };

/// The block of one of a facet's two parts; an instrument's walks add their first block.
inline constexpr std::uint32_t block_of_facet(std::uint32_t facet, std::uint32_t part) {
  return walk_facet_blocks[(2 * facet + part) * walk_blocks.count];
}

/// Leads walks of a mask, of the laser's light, by facets. met(mask, meeting) is called for each
/// facet.
template <class T, class Draw, class Met>
ByFacets<T> light_by_facets(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon,
                            const Mask<T>& stand, bool in_air, Facets which, Draw draw,
                            Met met_surface) {
  ByFacets<T> out;
  transport::AtWaves<T> at{stand, Mask<T>(in_air)};
  for (std::uint32_t facet = 0; facet < max_facets && any(at.meets); ++facet) {
    if (facet == 1) out.several = at.meets;
    const Mask<T> meets = at.meets;
    const std::array<T, 4> u = draw(block_of_facet(facet, 0));
    const auto met = transport::meet_waves(surface, photon, at, {u[0], u[1], u[2], u[3]},
                                           which == Facets::that_return);
    met_surface(meets, met.meeting);
    if (surface.face.oily) [[unlikely]]
      out.into_film = out.into_film + select(meets, met.into_film, T(0));
    out.in_water = out.in_water | met.in_water;
    out.chance = out.chance * select(meets, met.chance_back, T(1));
    at.meets = at.meets & (photon.weight > T(0));
  }
  out.in_water = out.in_water & (photon.weight > T(0));
  return out;
}

/// A telescope's.
template <class T, class Draw, class Met>
ByFacets<T> back_by_facets(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon,
                           const Mask<T>& stand, bool in_air, Facets which, Draw draw,
                           Met met_surface) {
  ByFacets<T> out;
  transport::BackAtWaves<T> at{stand, Mask<T>(in_air), Mask<T>(false)};
  for (std::uint32_t facet = 0; facet < max_facets && any(at.meets); ++facet) {
    if (facet == 1) out.several = at.meets;
    const Mask<T> meets = at.meets;
    const std::array<T, 4> u = draw(block_of_facet(facet, 0));
    const std::array<T, 4> v = draw(block_of_facet(facet, 1));
    const bool first = facet == 0;
    const auto met = transport::meet_waves_back(surface, photon, at, {u[0], u[1], u[2], u[3]}, v[0],
                                                first && which == Facets::several,
                                                first && which == Facets::that_return);
    met_surface(meets, met.meeting);
    out.in_water = out.in_water | met.in_water;
    out.chance = out.chance * met.chance;
  }
  return out;
}

}  // namespace photic::estimator
