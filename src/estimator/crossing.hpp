// Light that stands at the sea surface crosses it or goes back: cross_surface() for all light. A
// rule has what differs: histories split weights (SplitsWeight) or leave all to chance (ByChance),
// walks of the bidirectional estimator keep the chances of what they draw (WalkSteps::AtSurface).
// Light meets facets by meet_facets(), with a rule for the facets: FacetsOfHistories, LaserWalk,
// TelescopeWalk. An observer is shown what happens, to score it.
#pragma once

#include <array>
#include <cstdint>

#include "core/flatten.hpp"
#include "core/random.hpp"
#include "estimator/event.hpp"
#include "estimator/random_blocks.hpp"
#include "surface/oil.hpp"
#include "transport/cross.hpp"
#include "transport/meet_waves.hpp"
#include "transport/waves_back.hpp"

namespace photic::estimator {

/// An observer that takes no notice.
struct NoObserver {
  template <class T>
  [[nodiscard]] Mask<T> emit(const Mask<T>&, const surface::AtFilm<T>&, const T&, std::uint32_t) {
    return Mask<T>(false);
  }
  void came_from_film(const auto&, const auto&) {}
  /// Weight that a film takes, and does not emit again.
  void into_film(const auto&, const auto&) {}
  void about_to_meet(const auto&, std::uint32_t) {}
  void met(const auto&, const auto&) {}
  void crossed(std::int32_t, const auto&, const auto&) {}
  void passes(const auto&, const auto&, const auto&, const auto&) {}
  /// Light from outside that the flat surface reflects.
  void reflected(const auto&, const auto&, const auto&) {}
};

/// Has light meet facets and whitecaps of a rough surface, until it goes down in the water or has
/// left. Returns the light in the water.
template <class Rule, class T, class Observer>
Mask<T> meet_facets(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon,
                    typename Rule::At& at, Rule& rule, Observer& observer) {
  Mask<T> in_water(false);
  for (std::uint32_t facet = 0; facet < max_facets && any(at.meets); ++facet) {
    const Mask<T> emitted = rule.begin_facet(surface.waves, photon, at, facet, observer);
    in_water = in_water | emitted;
    at.meets = at.meets & !emitted;
    const Mask<T> meets = at.meets;
    const auto met = rule.meet(surface, photon, at, facet);
    rule.take(photon, meets, met, observer);
    observer.met(meets, met.meeting);
    in_water = in_water | met.in_water;
  }
  return in_water;
}

/// The crossing of a surface that sends light on in one direction on each side, by the shares of
/// light that go there. Photons that are `lossless` keep all of what comes back from it.
template <class T, class Ledger, class Observer>
void cross_by_shares(const geometry::Slabs& sea, Track<T>& t, const Mask<T>& stand,
                     bool from_outside, const Mask<T>& lossless, Ledger& ledger,
                     Observer& observer) {
  transport::Photon<T>& photon = t.photon;
  transport::Photon<T> down = photon;
  const T rise = photon.direction.z;
  const auto leaving = from_outside ? transport::refract_down(sea, down)
                                    : transport::reflect_down(sea, down, lossless);
  book(ledger.escaped, stand, leaving.into_air);
  book(ledger.oil, stand, leaving.into_film);
  observer.into_film(stand, leaving.into_film);
  if (!from_outside) {
    observer.passes(stand & (leaving.into_air > T(0)), leaving.direction, leaving.into_air, [&] {
      return surface::FilmCrossing<T>{photon.line, Index<T>(medium::through_film), rise};
    });
    observer.crossed(medium::back_into_water, rise, stand);
  }
  photon.direction = select(stand, down.direction, photon.direction);
  photon.weight = select(stand, down.weight, photon.weight);
  photon.analog_weight = select(stand, down.analog_weight, photon.analog_weight);
  if (!from_outside) return;
  observer.reflected(stand, leaving.direction, leaving.into_air);
  observer.crossed(medium::through_film, T(T(0) - photon.direction.z), stand);
}

/// Facets as histories meet them. Where `splits`, the weight that rises in the air is split off.
template <class T, class Ledger, bool splits>
struct FacetsOfHistories {
  using At = transport::AtWaves<T>;
  const World<T>& world;
  const RandomPlace<T>& place;
  Ledger& ledger;

  template <class Observer>
  Mask<T> begin_facet(const surface::WavesView& waves, const transport::Photon<T>& photon,
                      const At& at, std::uint32_t facet, Observer& observer) const {
    observer.about_to_meet(at, facet);
    if (!world.slabs.surface.emits) return Mask<T>(false);
    const auto u = uniforms(place, facet_blocks[facet]);  // of the facet that is met
    const auto by = transport::facet_met(waves, photon.direction, u[0], u[1], is_conserved(facet));
    return observer.emit(Mask<T>(at.meets & (by.gain > T(0))),
                         surface::AtFilm<T>{at.outside, photon.direction, by.facet.normal}, by.gain,
                         facet);
  }
  auto meet(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon, At& at,
            std::uint32_t facet) const {
    const auto u = uniforms(place, facet_blocks[facet]);
    return transport::meet_waves(surface, photon, at, {u[0], u[1], u[2], u[3]}, splits,
                                 is_conserved(facet));
  }
  /// Returns whether the weight at a facet is not yet over its mean.
  [[nodiscard]] bool is_conserved(std::uint32_t facet) const {
    return facet == 0 && world.slabs.waves.conserving;
  }
  template <class Observer>
  void take(const transport::Photon<T>& photon, const Mask<T>& meets,
            const transport::AfterFacet<T>& met, Observer& observer) const {
    // In the mean facets neither take light nor give it; a single one does.
    book(ledger.roulette, meets, T(0) - met.gained);
    book(ledger.escaped, meets, met.escaped);
    book(ledger.oil, meets, met.into_film);
    observer.into_film(meets, met.into_film);
    if (splits)
      observer.passes(meets & (met.escaped > T(0)), met.risen, met.escaped,
                      [&] { return transport::hit_of_risen(world.slabs.waves, met); });
    if (!any(met.left)) return;
    observer.passes(met.left, photon.direction, photon.weight, [&] { return met.meeting; });
    book(ledger.escaped, met.left, photon.weight);
  }
};
/// Has histories' light cross a rough surface, by a rule.
template <class Rule, class T, class Observer>
PHOTIC_APART void cross_facets(Rule& rule, Track<T>& t, const Mask<T>& stand, bool from_outside,
                               Observer& observer) {
  const auto surface = surface::rough_surface<T>(rule.world.slabs, t.photon.line);
  typename Rule::At at{stand, Mask<T>(from_outside)};
  const Mask<T> in_water = meet_facets(surface, t.photon, at, rule, observer);
  book(rule.ledger.lost, at.meets, t.photon.weight);
  t.on = t.on & ((!stand) | in_water);
}

/// Histories of the forward estimator.
template <class T, class Ledger>
struct SplitsWeight : FacetsOfHistories<T, Ledger, true> {
  Mask<T> lossless{false};

  template <class Observer>
  void cross_facets(Track<T>& t, const Mask<T>& stand, bool from_outside, Observer& observer) {
    estimator::cross_facets(*this, t, stand, from_outside, observer);
  }
  template <class Observer>
  void cross_flat(Track<T>& t, const Mask<T>& stand, bool from_outside, Observer& observer) const {
    cross_by_shares(this->world.slabs, t, stand, from_outside, lossless, this->ledger, observer);
  }
  /// Some go on as light that the film emits.
  template <class Observer>
  PHOTIC_APART void cross_film(Track<T>& t, const Mask<T>& stand, bool from_outside,
                               Observer& observer) const {
    Mask<T> crosses = stand;
    if (this->world.slabs.surface.emits)
      crosses =
          stand & !observer.emit(stand,
                                 surface::AtFilm<T>{
                                     Mask<T>(from_outside), t.photon.direction, {T(0), T(0), T(1)}},
                                 T(1), 0);
    cross_flat(t, crosses, from_outside, observer);
  }
};

/// The facets that walks are to meet: several, by which they come down from the air; or such that
/// send them back into the water, most of them at once. Their weight takes the chance of that.
enum class Facets : std::int8_t { any, several, that_return };

/// The block of one of a facet's two parts; an instrument's walks add their first block.
inline constexpr std::uint32_t block_of_facet(std::uint32_t facet, std::uint32_t part) {
  return walk_facet_blocks[(2 * facet + part) * walk_blocks.count];
}

/// The fate of walks that stood at the surface.
template <class T>
struct ByFacets {
  Mask<T> in_water{};  ///< walks that go down in the water
  Mask<T> several{};   ///< by way of more than one facet
  /// A telescope's walk's chance to go so over that of the laser's.
  T chance{1};
  T into_film{};  ///< weight of the laser's walks that a film of oil has absorbed
};

/// Facets as walks meet them one by one: draw(block) draws their numbers.
template <class T, class Draw>
struct FacetsOfWalks {
  Draw draw;
  Facets which = Facets::any;
  ByFacets<T> fate{};

  template <class At, class Observer>
  Mask<T> begin_facet(const surface::WavesView&, const transport::Photon<T>&, const At& at,
                      std::uint32_t facet, Observer&) {
    if (facet == 1) fate.several = at.meets;
    return Mask<T>(false);
  }
};
/// The laser's walks, as light does.
template <class T, class Draw>
struct LaserWalk : FacetsOfWalks<T, Draw> {
  using At = transport::AtWaves<T>;

  auto meet(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon, At& at,
            std::uint32_t facet) {
    const std::array<T, 4> u = this->draw(block_of_facet(facet, 0));
    return transport::meet_waves(surface, photon, at, {u[0], u[1], u[2], u[3]},
                                 this->which == Facets::that_return);
  }
  void take(const transport::Photon<T>&, const Mask<T>& meets, const transport::AfterFacet<T>& met,
            const auto&) {
    this->fate.into_film = this->fate.into_film + select(meets, met.into_film, T(0));
    this->fate.chance = this->fate.chance * select(meets, met.chance_back, T(1));
  }
};
/// Telescopes' walks, backwards.
template <class T, class Draw>
struct TelescopeWalk : FacetsOfWalks<T, Draw> {
  using At = transport::BackAtWaves<T>;

  auto meet(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon, At& at,
            std::uint32_t facet) {
    const std::array<T, 4> u = this->draw(block_of_facet(facet, 0));
    const std::array<T, 4> v = this->draw(block_of_facet(facet, 1));
    const bool first = facet == 0;
    return transport::meet_waves_back(surface, photon, at, {u[0], u[1], u[2], u[3]}, v[0],
                                      first && this->which == Facets::several,
                                      first && this->which == Facets::that_return);
  }
  void take(const transport::Photon<T>&, const Mask<T>&, const transport::AfterFacetBack<T>& met,
            const auto&) {
    this->fate.chance = this->fate.chance * met.chance;
  }
};

/// Leads walks of a mask by facets. `back`: they are telescopes'. met(mask, meeting) is called for
/// each facet.
template <class T, class Draw, class Met>
ByFacets<T> walk_by_facets(bool back, const surface::RoughSurface<T>& surface,
                           transport::Photon<T>& photon, const Mask<T>& stand, bool from_outside,
                           Facets which, Draw draw, Met met_surface) {
  struct : NoObserver {
    Met met;
  } observer{{}, met_surface};
  const auto lead = [&](auto rule) {
    typename decltype(rule)::At at{stand, Mask<T>(from_outside)};
    rule.fate.in_water = meet_facets(surface, photon, at, rule, observer);
    return rule.fate;
  };
  return back ? lead(TelescopeWalk<T, Draw>{{draw, which}})
              : lead(LaserWalk<T, Draw>{{draw, which}});
}

/// Has photons of a mask that stand at the surface, in the water or outside, cross it or go back,
/// by a rule.
template <class T, class Tracks, class Rule, class Observer>
void cross_surface(const World<T>& world, Tracks& t, const Mask<T>& stand, bool from_outside,
                   Rule& rule, Observer& observer) {
  transport::Photon<T> before;
  if (world.companion) [[unlikely]]
    before = t.photon;
  const auto& surface = world.slabs.surface;
  if (!surface.one_direction_each) [[unlikely]] {
    rule.cross_facets(t, stand, from_outside, observer);
  } else if (surface.absorbs) [[unlikely]] {
    rule.cross_film(t, stand, from_outside, observer);
  } else {
    rule.cross_flat(t, stand, from_outside, observer);
  }
  if (world.companion) [[unlikely]]
    world.companion->crossed(before, t.photon, stand, Mask<T>(stand & t.on));
}

}  // namespace photic::estimator
