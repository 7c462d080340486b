// Analog photons: nothing is expected, everything happens or not, down to the detector that a
// photon falls on. As slow as nature, and as plain: what the other estimators are checked against.
#pragma once

#include <cstdint>
#include <limits>

#include "core/random.hpp"
#include "estimator/analog/collide_by_chance.hpp"
#include "estimator/book.hpp"
#include "estimator/draws.hpp"
#include "estimator/ends.hpp"
#include "estimator/world.hpp"
#include "instrument/lens.hpp"
#include "lanes/each_score.hpp"
#include "tally/batch_tally.hpp"
#include "transport/emit.hpp"
#include "transport/flight.hpp"

namespace photic::estimator {

/// Photons that have been refracted into the water: the surface's losses, taken from their weight,
/// become a chance. Tells who is there.
template <class T, class Ledger>
Mask<T> enter_by_chance(transport::Photon<T>& photon, const Mask<T>& entered, const T& u,
                        Ledger& ledger) {
  const Mask<T> passes = u < photon.weight;
  book(ledger.roulette, entered, photon.weight - select(passes, T(1), T(0)));
  photon.weight = T(1);
  return entered & passes;
}

/// Counts the photons of a mask that fall on a detector on their straight way from where they
/// stand, so long, in the water, or from the surface in the air; `depth` is that of the collision
/// they come from. Telescopes do not stand in each other's way, nor in the light's.
template <class T>
void receive(const World<T>& world, const transport::Photon<T>& photon, Mask<T> flying,
             const T& length, bool submerged, const T& depth, tally::BatchTally& tally) {
  flying = flying & (photon.order > Index<T>(0));
  for (std::size_t t = 0; t < world.telescopes.size(); ++t) {
    const instrument::Telescope<T>& telescope = world.telescopes[t];
    if (telescope.submerged != submerged) continue;
    const T towards = -dot(photon.direction, telescope.axis);
    const Vec3<T> from_lens = photon.position - telescope.position;
    const T distance = dot(from_lens, telescope.axis) / select(towards > T(0), towards, T(1));
    const Vec3<T> met = from_lens + distance * photon.direction;
    const instrument::PlanePoint<T> point{dot(met, telescope.across), dot(met, telescope.up)};
    const Mask<T> seen = flying & (towards > T(0)) & (distance > T(0)) & (distance < length) &
                         instrument::open_at(telescope, point) &
                         instrument::sight(telescope, point, photon.direction).on_detector;
    if (!any(seen)) continue;
    const T way = submerged ? T(distance * gather<T>(world.sea.group_index, photon.line))
                            : longer_way(telescope, photon.position, point, distance);
    const lanes::LaneScores<T> scores{t,     world.path_to_origin[t], photon.line, photon.order,
                                      depth, photon.path + way,       T(1)};
    lanes::each_score(
        tally, seen, scores,
        [&](std::size_t, const tally::Score& score, const auto& at) { tally.score(score, at); });
  }
}

/// A flight in the water, whose photons may meet a submerged detector on it.
template <class T>
transport::FlightEnd<T> fly_and_receive(const World<T>& world, transport::Photon<T>& photon,
                                        const Mask<T>& flying, const T& u, const T& depth,
                                        tally::BatchTally& tally) {
  const transport::Photon<T> before = photon;
  const auto end = transport::fly(world.sea, photon, minus_log(u));
  receive(world, before, flying, end.length, true, depth, tally);
  return end;
}

/// The photons of a mask at the surface, from below, go through it and on. Tells which.
template <class T>
Mask<T> emerge(const World<T>& world, const transport::Photon<T>& photon, const Mask<T>& at_surface,
               const T& u, const T& depth, tally::BatchTally& tally) {
  const T n = gather<T>(world.sea.index, photon.line);
  const auto through = optics::refract(n, T(1), photon.direction.z);
  const Mask<T> leaves = at_surface & (u >= through.reflectance);
  transport::Photon<T> out = photon;
  out.direction = {n * photon.direction.x, n * photon.direction.y, through.cos_transmitted};
  receive(world, out, leaves, T(std::numeric_limits<Element<T>>::max()), false, depth, tally);
  return leaves;
}

/// Photons on their way, one in each lane.
template <class T>
struct AnalogPhotons {
  transport::Photon<T> photon;
  RandomPlace<T> place;
  Index<T> spectral_bin{};  ///< in which lines it emits
  Mask<T> on{};             ///< who is on the way
};

/// Follows photons of the laser until chance has decided what becomes of them. Ledger: of one
/// photon, or of lanes.
template <class T, class Ledger>
class Analog {
 public:
  explicit Analog(const World<T>& world) : world_(world) {}

  /// Photons `first` … `first + count - 1`, the first of a batch and up. `witness` is told of them
  /// at the end of each event, and who was on the way before.
  template <class Witness>
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Witness witness) {
    const Draws<T> draws = draws_of_laser(world_, first);
    for (std::uint64_t n = 0; n < count; n += lanes_of<T>) {
      auto photons = birth(draws, static_cast<std::int32_t>(n), first_lanes<T>(count - n));
      while (any(photons.on)) {
        const Mask<T> before = photons.on;
        event(photons, tally);
        witness(photons, before);
      }
    }
    tally.ledger = tally.ledger + total(ledger_);
    ledger_ = {};
  }

 private:
  /// A batch's photons n, n + 1, … of a mask on the laser's disc, and on into the water.
  AnalogPhotons<T> birth(const Draws<T>& draws, std::int32_t n, const Mask<T>& exist) {
    AnalogPhotons<T> photons{
        {}, {world_.key, draws.photon(Index<T>(n) + lane_numbers<T>()), Index<T>(0)}};
    const auto u = draws.together(n, 0, 0);
    if (world_.sea.bands > 0) photons.spectral_bin = medium::spectral_bin_of(u[3]);
    transport::Photon<T>& photon = photons.photon;
    photon = transport::emit(world_.laser, world_.laser_layer, u[0], u[1]);
    photons.on = exist;
    if (world_.laser.submerged) return photons;
    const T in_air = photon.weight;
    const Mask<T> entered = transport::enter_water(world_.sea, photon);
    book(ledger_.escaped, exist, select(entered, in_air - photon.weight, in_air));
    photons.on = enter_by_chance(photon, exist & entered, u[2], ledger_);
    return photons;
  }

  /// From one collision to the next, by way of the surface if need be.
  void event(AnalogPhotons<T>& photons, tally::BatchTally& tally) {
    transport::Photon<T>& photon = photons.photon;
    Mask<T> on = photons.on;
    photons.place.event = photons.place.event + Index<T>(1);
    const auto u = uniforms(photons.place, 0), v = uniforms(photons.place, 1);
    const T depth = -photon.position.z;
    auto end = fly_and_receive(world_, photon, on, u[0], depth, tally);
    const Mask<T> at_surface = on & end.surface;
    if (any(at_surface)) {
      const Mask<T> leaves = emerge(world_, photon, at_surface, u[1], depth, tally);
      book(ledger_.escaped, leaves, photon.weight);
      on = on & !leaves;
      transport::Photon<T> down = photon;
      down.direction.z = -down.direction.z;
      const auto after = fly_and_receive(world_, down, at_surface & on, u[2], depth, tally);
      photon = select(at_surface, down, photon);
      end.sea_bed = end.sea_bed | (at_surface & after.sea_bed);
    }
    book(ledger_.sea_bed, on & end.sea_bed, photon.weight);
    on = on & !end.sea_bed;
    const Mask<T> late = on & !in_time(world_, photon);
    book(ledger_.cut_by_time, late, photon.weight);
    on = on & !late;
    const Mask<T> last =
        on & Mask<T>(world_.last_order > 0) & (photon.order == Index<T>(world_.last_order));
    book(ledger_.cut_by_order, last, photon.weight);
    on = on & !last;

    tally.collisions += count(on);
    const Mask<T> stays =
        collide_by_chance(world_.sea, photon, photons.spectral_bin, on, u[3], v[0], v[1]);
    book(ledger_.absorbed, on & !stays, photon.weight);
    const Mask<T> worn = stays & (photons.place.event >= Index<T>(most_events));
    tally.too_many_events += count(worn);
    book(ledger_.lost, worn, photon.weight);
    photons.on = stays & !worn;
  }

  const World<T>& world_;
  Ledger ledger_{};
};

}  // namespace photic::estimator
