// The escape of light as tallies take it: by expected value, wherever a flight may leave the water
// or the air. The light's own history is left as it is, and books nothing where it does leave.
#pragma once

#include "core/elementary.hpp"
#include "core/flatten.hpp"
#include "estimator/crossing.hpp"
#include "estimator/forward/forward_tracks.hpp"
#include "estimator/tally_events.hpp"
#include "transport/cross.hpp"

namespace photic::estimator {

/// The observer of light that leaves by the surface: into clear air, where it escapes, or else it
/// is followed there by itself.
template <class T>
struct EscapesAtSurface : NoObserver {
  const TallyEvents<T>& events;
  const transport::Photon<T>& photon;
  bool into_clear_air = false, was_in_water = false;

  void passes(const Mask<T>& mask, const Vec3<T>& direction, const T& weight, const auto&) const {
    reflected(mask, direction, weight);
  }
  void reflected(const Mask<T>& mask, const Vec3<T>& direction, const T& weight) const {
    if (!into_clear_air) return;
    events.escape(mask, direction.z, weight, Mask<T>(was_in_water));
    events.rise_in_clear_air(mask, photon, direction, weight);
  }
  void into_film(const Mask<T>& mask, const T& weight) const {
    events.absorbed_in_film(mask, weight);
  }
};

/// Light of a mask that stands at the surface leaves by it, or is absorbed in a film there, as far
/// as it may; `photon` is what is left.
template <class Ledger, class T>
PHOTIC_APART void tally_at_surface(const World<T>& world, const ForwardTracks<T>& t,
                                   transport::Photon<T> photon, const Mask<T>& stand,
                                   bool from_outside, tally::BatchTally& tally) {
  if (!any(stand)) return;
  Ledger ledger;
  Track<T> there{photon, stand, stand, t.touched};
  SplitsWeight<T, Ledger> rule{{world, t.place, ledger}, Mask<T>(false)};
  const TallyEvents<T> events(world, tally);
  EscapesAtSurface<T> observer{
      {}, events, there.photon, world.tallies->escapes_at_surface, !from_outside};
  estimator::cross_surface(world, there, stand, from_outside, rule, observer);
}

/// Returns whether anything of light at the surface counts there.
template <class T>
bool counts_at_surface(const World<T>& world) {
  const Tallies& tallies = *world.tallies;
  const bool escapes = tallies.boundaries || tallies.outside.exist();
  return (tallies.escapes_at_surface && escapes) ||
         (world.slabs.surface.absorbs && tallies.boundaries);
}

/// Photons of a mask have been emitted outside, and stand at the surface if they fall.
template <class Ledger, class T>
void tally_birth(const World<T>& world, const ForwardTracks<T>& t, const Mask<T>& exist,
                 tally::BatchTally& tally) {
  if (world.tallies->escapes_at_surface)
    TallyEvents<T>(world, tally).leave_source(t.photon, exist, t.on);
  if (counts_at_surface(world)) tally_at_surface<Ledger>(world, t, t.photon, t.on, true, tally);
}

/// Before a flight of photons in a medium whose far end is the top of the air.
template <class T>
void tally_escape_from_air(const World<T>& world, const ForwardTracks<T>& t, const Mask<T>& mask,
                           tally::BatchTally& tally) {
  const transport::Photon<T>& photon = t.photon;
  const Mask<T> rises = mask & (photon.direction.z < T(0));
  if (!any(rises)) return;
  const T up = select(rises, T(0) - photon.direction.z, T(1));
  const auto at = geometry::level_of(world.slabs, photon);
  const T here =
      geometry::optical_depths(
          world.slabs, geometry::to_surface(photon.line, at, at.depth, geometry::Slant<T>{}))
          .all;
  const T rest = (gather<T>(world.slabs.bed_tau, photon.line) - here) / up;
  const TallyEvents<T> events(world, tally);
  events.escape(rises, up, photon.weight * exp_minus(select(rest > T(0), rest, T(0))),
                events.were_in_water(t.touched));
}

/// Before a flight of photons of a mask.
template <class Ledger, class T>
PHOTIC_APART void tally_escape_ahead(const World<T>& world, const ForwardTracks<T>& t,
                                     const Mask<T>& mask, tally::BatchTally& tally) {
  const Mask<T> light = of_source(t.photon, mask);
  if (!any(light)) return;
  const bool above_sea = world.tallies->escapes_at_end;
  if (above_sea && world.tallies->boundaries) tally_escape_from_air(world, t, light, tally);
  if (!counts_at_surface(world)) return;
  // Light straight from a source above the air is taken in the water's world.
  const Mask<T> comes = above_sea ? light & (t.photon.order > Index<T>(0)) : light;
  transport::Photon<T> photon = t.photon;
  const auto came = transport::come_up(world.slabs, photon);
  tally_at_surface<Ledger>(world, t, photon, comes & came.rises, false, tally);
}

}  // namespace photic::estimator
