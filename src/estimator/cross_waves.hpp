// Light that comes to a rough surface meets facets, one or several, until it goes down in the water
// or rises in the air.
#pragma once

#include <cstdint>

#include "core/random.hpp"
#include "estimator/event.hpp"
#include "estimator/random_blocks.hpp"
#include "transport/cross_waves.hpp"

namespace photic::estimator {

/// Has the photons of `at` meet facets until they have left the surface. observe(at, facet) is
/// called before each facet that is met, met(mask, meeting) behind it; emit(at, facet) returns the
/// photons that go down in the water as light that a film of oil emits. leave(mask, direction,
/// weight) is called for the light that rises in the air: weight that is split off, or else whole
/// photons.
template <class T, class Ledger, class Observe, class Emit, class Met, class Leave>
void cross_waves(const World<T>& world, const RandomPlace<T>& place, Track<T>& t,
                 transport::AtWaves<T> at, bool splits, Ledger& ledger, Observe observe, Emit emit,
                 Met met_surface, Leave leave) {
  const Mask<T> came = at.meets;
  const auto surface = surface::rough_surface<T>(world.sea, t.photon.line);
  Mask<T> in_water(false);
  for (std::uint32_t facet = 0; facet < max_facets && any(at.meets); ++facet) {
    observe(at, facet);
    const Mask<T> emitted = emit(at, facet);
    in_water = in_water | emitted;
    at.meets = at.meets & !emitted;
    const Mask<T> meets = at.meets;
    const auto u = uniforms(place, facet_blocks[facet]);
    const auto met = transport::meet_waves(surface, t.photon, at, {u[0], u[1], u[2], u[3]}, splits);
    met_surface(meets, met.meeting);
    // In the mean facets neither take light nor give it; a single one does.
    book(ledger.roulette, meets, T(0) - met.gained);
    book(ledger.escaped, meets, met.escaped);
    book(ledger.oil, meets, met.into_film);
    if (splits) leave(meets & (met.escaped > T(0)), met.risen, met.escaped);
    if (any(met.left)) {
      leave(met.left, t.photon.direction, t.photon.weight);
      book(ledger.escaped, met.left, t.photon.weight);
    }
    const Mask<T> lit = t.photon.weight > T(0);
    in_water = in_water | (met.in_water & lit);
    at.meets = at.meets & lit;
  }
  book(ledger.lost, at.meets, t.photon.weight);
  t.on = t.on & ((!came) | in_water);
}

}  // namespace photic::estimator
