// The crossing of the surface by analog photons: chance decides between all ways.
#pragma once

#include "estimator/analog/facet_by_chance.hpp"
#include "estimator/analog/film_by_chance.hpp"
#include "estimator/crossing.hpp"
#include "surface/flat.hpp"

namespace photic::estimator {

/// A rule of cross_surface().
template <class T, class Ledger>
struct ByChance : FacetsOfHistories<T, Ledger, false> {
  Index<T> spectral_bin{};
  T number{};  ///< a uniform

  AfterOilyFacet<T> meet(const surface::RoughSurface<T>& surface, transport::Photon<T>& photon,
                         transport::AtWaves<T>& at, std::uint32_t facet) const {
    if (surface.face.oily)
      return facet_by_chance(this->world.slabs, this->place, spectral_bin, facet, photon, at,
                             this->is_conserved(facet));
    return {FacetsOfHistories<T, Ledger, false>::meet(surface, photon, at, facet), Mask<T>(false),
            T(0)};
  }
  template <class Observer>
  void take(const transport::Photon<T>& photon, const Mask<T>& meets, const AfterOilyFacet<T>& met,
            Observer& observer) const {
    observer.came_from_film(met.emitted, met.weight);
    FacetsOfHistories<T, Ledger, false>::take(photon, meets, met, observer);
  }
  template <class Observer>
  void cross_facets(Track<T>& t, const Mask<T>& stand, bool from_outside, Observer& observer) {
    estimator::cross_facets(*this, t, stand, from_outside, observer);
  }
  template <class Observer>
  void cross_flat(Track<T>& t, const Mask<T>& stand, bool from_outside, Observer& observer) const {
    auto& ledger = this->ledger;
    transport::Photon<T>& photon = t.photon;
    if (from_outside) {  // the loss of weight becomes a chance
      const Vec3<T>& falls = photon.direction;
      const Vec3<T> rises{falls.x, falls.y, T(0) - falls.z};
      NoObserver none;
      cross_by_shares(this->world.slabs, t, stand, true, Mask<T>(false), ledger, none);
      const Mask<T> passes = number < photon.weight;
      observer.reflected(stand & !passes, rises, T(1));
      book(ledger.roulette, stand, photon.weight - select(passes, T(1), T(0)));
      photon.weight = T(1);
      t.on = t.on & passes;
      return;
    }
    const auto split =
        surface::flat_surface<T>(this->world.slabs, photon.line).from_below(photon.direction);
    const Mask<T> leaves = stand & (number >= split.reflectance);
    observer.passes(leaves, split.transmitted, photon.weight, [] {});
    book_out(t, leaves, ledger.escaped);
    photon.direction = select(stand, split.reflected, photon.direction);
  }
  template <class Observer>
  void cross_film(Track<T>& t, const Mask<T>& stand, bool from_outside, Observer& observer) const {
    const auto after =
        film_by_chance(this->world.slabs, this->place, spectral_bin, stand, from_outside, t.photon);
    observer.came_from_film(after.emitted, t.photon.weight);
    observer.passes(after.up, t.photon.direction, t.photon.weight, [] {});
    book_out(t, after.up, this->ledger.escaped);
    const Mask<T> absorbed = stand & t.on & !after.down;
    observer.into_film(absorbed, t.photon.weight);
    book_out(t, absorbed, this->ledger.oil);
  }
};

}  // namespace photic::estimator
