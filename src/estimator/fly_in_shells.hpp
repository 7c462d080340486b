// Flights through spherical air: of histories and analog photons alike, in double. What tallies are
// shown of them is leg by leg, and light that comes to the top of the air escapes.
#pragma once

#include <algorithm>
#include <type_traits>

#include "estimator/book.hpp"
#include "estimator/event.hpp"
#include "estimator/tallies/legs_of_flight.hpp"
#include "estimator/world.hpp"
#include "tally/batch_tally.hpp"
#include "transport/shell_flight.hpp"

namespace photic::estimator {

/// Returns whether light of a world flies through spherical air, which is known before the loops
/// for all arithmetic but double.
template <class T>
bool is_in_shells(const World<T>& world) {
  if constexpr (std::is_same_v<T, double>) {
    return world.slabs.shells.exist();
  } else {
    return false;
  }
}

/// Moves a photon by a free path, an optical depth. Where it leaves the air, or never comes there,
/// it ends.
template <class T, class Ledger>
transport::FlightEnd<T> fly_in_shells(const World<T>& world, Track<T>& t, const T& free_path,
                                      tally::BatchTally& tally, Ledger& ledger) {
  transport::FlightEnd<T> out{};
  if constexpr (std::is_same_v<T, double>) {
    const medium::ShellsView& shells = world.slabs.shells;
    const auto up = [&](const transport::Photon<double>& photon) {
      return dot(geometry::local_vertical(shells, photon.position), photon.direction);
    };
    const auto escape = [&](double cosine) {
      if (world.tallies && world.tallies->boundaries)
        world.tallies->boundaries->escape(cosine, t.photon.weight, false, tally.tallies);
      book_out(t, t.on, ledger.escaped);
    };
    const bool sets_out = t.photon.order == 0 && shells.source_outside;
    if (sets_out && !transport::come_to_shells(shells, t.photon)) {
      escape(std::max(0.0, up(t.photon)));
      return out;
    }
    LegsOfFlight legs(world.tallies.get(), shells, t.photon, tally.tallies);
    const auto flight = transport::fly_in_shells(world.slabs, t.photon, free_path, legs);
    out.length = flight.length;
    out.sea_bed = flight.end == transport::ShellEnd::ground && world.slabs.bed_angles == 0;
    if (out.sea_bed) legs.end_on_ground(t.photon.weight);
    if (flight.end == transport::ShellEnd::top) escape(up(t.photon));
    if (flight.end == transport::ShellEnd::lost) {
      tally.too_many_events += count(t.on);
      book_out(t, t.on, ledger.lost);
    }
  }
  return out;
}

}  // namespace photic::estimator
