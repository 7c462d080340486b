// One event of a history: a flight, and what stands at its end.
//
// clang-format off
//   birth --> flight --+--> black sea bed, or too late -------------------------------> end
//               ^      +--> surface: reflected, but for what passes -----+               ^
//               |      +--> collision: scattered, converted, absorbed ---+               |
//               +------------------ Russian roulette <-------------------+               |
//                                          +---------------------------------------------+
// clang-format on
//
// Photons of the forward estimator, the bidirectional one's walks and analog photons all go through
// this text. Each estimator defines its steps in its Steps. each(stage) has a stage done to all
// tracks: to one alone, or to many before the next stage begins.
#pragma once

#include <cstdint>
#include <limits>

#include "estimator/book.hpp"
#include "estimator/world.hpp"
#include "transport/cross.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"
#include "transport/touched.hpp"

namespace photic::estimator {

/// A photon that has not ended after so many events is lost, and counted.
inline constexpr std::int32_t max_events = 1'000'000;

/// Photons on their way, one in each lane.
template <class T>
struct Track {
  transport::Photon<T> photon;
  Mask<T> on{};         ///< those on their way
  Mask<T> colliding{};  ///< those of them whose flight has ended in a collision
  Index<T> touched{};   ///< by their light, transport::Touched; of walks not kept
};

/// Ends the photons of a mask; an account of the ledger takes their weight.
template <class T, class Account>
void book_out(Track<T>& t, const Mask<T>& gone, Account& account) {
  book(account, t.on & gone, t.photon.weight);
  t.on = t.on & !gone;
}

/// The places touched by light that sets out in a medium.
inline transport::Touched touched_at_birth(const medium::MediumView& sea) {
  return sea.kind == medium::MediumKind::air ? transport::Touched::air : transport::Touched::water;
}

/// Has light of a mask leave the laser, by two uniforms. Light that stands in the water, or has
/// come down to its surface, is on its way; beside a row of columns there is no surface.
template <class T, class Ledger>
void birth_at_laser(const World<T>& world, const T& u_polar, const T& u_azimuth,
                    const Mask<T>& exist, Track<T>& t, Ledger& ledger) {
  t.photon = transport::emit(world.instruments.laser, world.instruments.laser_region.layer, u_polar,
                             u_azimuth);
  t.touched = Index<T>(static_cast<std::int32_t>(touched_at_birth(world.slabs)));
  t.on = exist;
  if (!world.instruments.laser_region.outside) return;
  const T emitted = t.photon.weight;
  Mask<T> comes = transport::come_down(world.instruments.laser_region, t.photon);
  const medium::RowView& row = world.slabs.row;
  if (row.has_faces) [[unlikely]] {
    comes = comes & row.covers(t.photon.position.x, t.photon.position.y);
    t.photon.layer = row.surface_layer_at(t.photon.position.x);
  }
  book(ledger.escaped, exist, select(comes, emitted - t.photon.weight, emitted));
  t.on = exist & comes;
}

/// Flights of all photons: at their ends, those that have not come to the sea bed, nor come too
/// late, stand at the surface, which they cross, or collide.
template <class Steps, class Each>
void flights(Steps& steps, Each each) {
  steps.begin_event(each);
  each([&](auto& t) { steps.look_ahead(t); });
  each([&](auto& t) { steps.draw_free_path(t); });
  each([&](auto& t) { end_flight(steps, t, steps.fly(t)); });
  each([&](auto& t) { steps.cross(t); });
}

/// Collisions of the photons that collide. Then the event ends for all.
template <class Steps, class Each>
void collisions(Steps& steps, Each each) {
  each([&](auto& t) { steps.score(t); });
  each([&](auto& t) { steps.collide(t); });
  steps.scatter(each);
  each([&](auto& t) { end_event(steps, t); });
}

template <class Steps, class T>
void end_flight(Steps& steps, Track<T>& t, const transport::FlightEnd<T>& end) {
  book_out(t, end.sea_bed, steps.ledger.sea_bed);
  if (any(end.sideways)) [[unlikely]]
    book_out(t, end.sideways, steps.ledger.escaped);
  book_out(t, !steps.in_time(t.photon), steps.ledger.cut_by_time);
  t.colliding = t.on & !end.surface;
  steps.tally.collisions += count(t.colliding);
}

/// Plays roulette, and books losses: weights that are no numbers, and photons that have not ended
/// for too long.
template <class Steps, class Tracks>
void end_event(Steps& steps, Tracks& t) {
  using T = decltype(t.photon.weight);
  steps.play_roulette(t);
  const Mask<T> on = t.on;
  const Mask<T> finite = t.photon.weight <= T(std::numeric_limits<Element<T>>::max());
  const Mask<T> fresh = steps.event_of(t) < Index<T>(max_events);
  t.on = on & finite & fresh;
  if (!any(on & !(finite & fresh))) return;
  steps.tally.not_finite += count(on & !finite);
  const Mask<T> worn = on & finite & !fresh;
  steps.tally.too_many_events += count(worn);
  book(steps.ledger.lost, worn, t.photon.weight);
}

}  // namespace photic::estimator
