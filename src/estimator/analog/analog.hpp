// Analog photons: nothing is expected, everything happens or not, down to the detector that a
// photon falls on. As slow as nature, and as plain: the other estimators are checked against them.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <utility>

#include "core/random.hpp"
#include "estimator/analog/by_chance.hpp"
#include "estimator/analog/collide_by_chance.hpp"
#include "estimator/beyond.hpp"
#include "estimator/book.hpp"
#include "estimator/crossing.hpp"
#include "estimator/draws.hpp"
#include "estimator/event.hpp"
#include "estimator/fly_in_shells.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/tally_events.hpp"
#include "estimator/termination.hpp"
#include "estimator/world.hpp"
#include "instrument/lens.hpp"
#include "lanes/each_score.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect.hpp"
#include "transport/facets_in_line.hpp"
#include "transport/flight.hpp"
#include "transport/touched.hpp"

namespace photic::estimator {

/// The way of a photon in the water straight to a point of a telescope's lens, so long.
template <class T>
geometry::Segment<T> to_lens(const World<T>& world, std::size_t telescope,
                             const transport::Photon<T>& photon,
                             const instrument::PlanePoint<T>& lens, const T& length) {
  const Vec3<T> end = in_space(world.instruments.telescopes[telescope], lens);
  return {photon.line, geometry::level_of(world.slabs, photon),
          world.slabs.level(world.instruments.telescope_region[telescope].layer,
                            geometry::depth_of(end)),
          length};
}
/// Counts the photons of a mask that fall on a detector on their straight way from where they
/// stand, so long, in the water, or from the surface `outside`; `depth` is that of the collision
/// they come from. Telescopes do not stand in each other's way, nor in the light's.
template <class T>
void detect(const World<T>& world, const transport::Photon<T>& photon, const Index<T>& touched,
            Mask<T> flying, const T& length, bool outside, const T& depth,
            tally::BatchTally& tally) {
  const Index<T> of_surface(static_cast<std::int32_t>(transport::Touched::surface));
  flying = flying & ((photon.order > Index<T>(0)) | (touched == of_surface));
  for (std::size_t t = 0; t < world.instruments.telescopes.size(); ++t) {
    const instrument::Telescope<T>& telescope = world.instruments.telescopes[t];
    if (world.instruments.telescope_region[t].outside != outside) continue;
    const auto [open, point, distance] =
        transport::come_to_lens(telescope, photon.position, photon.direction);
    const Mask<T> seen = flying & open & (distance < length) &
                         instrument::sight(telescope, point, photon.direction).on_detector;
    if (!any(seen)) continue;
    const T way = outside
                      ? longer_way(telescope, photon.position, point, distance)
                      : transport::path_within(world.slabs, telescope, photon.position,
                                               to_lens(world, t, photon, point, distance), point);
    const lanes::LaneScores<T> scores{Index<T>(static_cast<std::int32_t>(t)),
                                      world.instruments.path_to_origin[t],
                                      transport::light_of<T>(world.slabs, photon.line, touched),
                                      photon.order,
                                      depth,
                                      photon.path + way,
                                      photon.weight};
    lanes::each_score(
        tally, seen, scores,
        [&](std::size_t, const tally::Score& score, const auto& at) { tally.score(score, at); });
  }
}

/// Photons on their way, one in each lane.
template <class T>
struct AnalogPhotons : Track<T> {
  RandomPlace<T> place;
  Index<T> spectral_bin{};  ///< in which lines it emits
};

/// Photons on their way from one medium to the other.
template <class T>
using AnalogPassed = std::deque<AnalogPhotons<T>>;

/// The steps of an event (estimator/event.hpp) of analog photons: chance decides.
template <class T, class Ledger>
struct AnalogSteps {
  const World<T>& world;
  Ledger& ledger;
  tally::BatchTally& tally;
  AnalogPassed<T>& passed;
  std::array<T, 4> u{}, v{};  ///< numbers of the event

  /// A batch's photons n, n + 1, … of a mask leave the laser.
  AnalogPhotons<T> birth(const Draws<T>& draws, std::int32_t n, const Mask<T>& exist) {
    AnalogPhotons<T> p{
        {}, {world.random.key, draws.photon(Index<T>(n) + lane_numbers<T>()), Index<T>(0)}};
    const auto w = draws.together(n, 0, birth_blocks[0]);
    if (world.slabs.bands > 0) p.spectral_bin = medium::spectral_bin_of(w[3]);
    birth_at_laser(world, w[0], w[1], exist, p, ledger);
    if (!world.instruments.laser_region.outside) return p;
    if (world.tallies && world.tallies->escapes_at_surface)
      TallyEvents<T>(world, tally).leave_source(p.photon, exist, p.on);
    cross_surface(p, p.on, true, w[2], T(0));
    return p;
  }

  template <class Each>
  void begin_event(Each each) {
    each([&](auto& p) {
      p.place.event = p.place.event + Index<T>(1);
      u = uniforms(p.place, event_blocks[0]), v = uniforms(p.place, event_blocks[1]);
    });
  }
  void look_ahead(const AnalogPhotons<T>&) {}
  void draw_free_path(const AnalogPhotons<T>&) {}

  /// To the next collision, by way of the surface if need be.
  transport::FlightEnd<T> fly(AnalogPhotons<T>& p) {
    if (is_in_shells(world)) return fly_in_shells(world, p, minus_log(u[0]), tally, ledger);
    const T depth = geometry::depth_of(p.photon.position);
    auto end = fly_to_detectors(p.photon, p.touched, p.on, u[0], depth);
    const Mask<T> at_surface = p.on & end.surface;
    end.surface = Mask<T>(false);
    if (!any(at_surface)) return end;
    cross_surface(p, at_surface, false, u[1], depth);
    return fly_on(p, at_surface & p.on, depth, end);
  }
  [[nodiscard]] Mask<T> in_time(const transport::Photon<T>& photon) const {
    return estimator::in_time(world.instruments, photon);
  }
  void cross(const AnalogPhotons<T>&) {}  // in flight

  void score(const AnalogPhotons<T>&) {}
  void collide(AnalogPhotons<T>& p) {
    const Mask<T> last = p.photon.order == Index<T>(world.part.last_order);
    if (world.part.last_order > 0) book_out(p, last, ledger.cut_by_order);
    const Mask<T> bed = surface::on_bed<T>(world.slabs, p.photon.layer);
    const Index<T> air(static_cast<std::int32_t>(transport::Touched::air));
    const Mask<T> first = (p.photon.order == Index<T>(0)) | (p.touched == air);
    const Index<T> fresh(static_cast<std::int32_t>(touched_at_birth(world.slabs)));
    p.touched =
        transport::touched_at<T>(world.slabs, p.photon.layer, select(first, fresh, p.touched));
    const transport::Photon<T> before = p.photon;
    if (world.tallies) TallyEvents<T>(world, tally).radiate(before, p.on);
    const Mask<T> stays =
        collide_by_chance(world.slabs, p.photon, p.spectral_bin, p.on, u[3], v[0], v[1]);
    if (world.companion) [[unlikely]]
      world.companion->collided(before, p.photon, p.on);
    if (world.tallies) {
      const Mask<T> converted = !(p.photon.line == before.line);
      TallyEvents<T>(world, tally).absorbed(before, p.on & (converted | !stays));
    }
    book_out(p, bed & !stays, ledger.sea_bed);
    book_out(p, !stays, ledger.absorbed);
  }
  template <class Each>
  void scatter(Each) {}

  void play_roulette(const AnalogPhotons<T>&) {}
  [[nodiscard]] static const Index<T>& event_of(const AnalogPhotons<T>& p) { return p.place.event; }

 private:
  /// Photons of a mask leave the surface, as `out`: in clear air they may meet a detector, else
  /// they go on in the other medium. `depth`: of the collision that they come from.
  void leave(const AnalogPhotons<T>& p, const transport::Photon<T>& out, const Mask<T>& leaving,
             const T& depth) {
    if (!world.part.beyond.exists) {
      const T endless(std::numeric_limits<Element<T>>::max());
      return detect(world, out, p.touched, leaving, endless, true, depth, tally);
    }
    if (!any(leaving)) return;
    AnalogPhotons<T> gone = p;
    gone.photon = out;
    gone.on = leaving;
    go_beyond(world.part.beyond, out.direction, gone);
    passed.push_back(gone);
    book(ledger.escaped, leaving, T(0) - out.weight);  // it has not
  }
  /// The observer of photons at the surface.
  struct AtDetectors : NoObserver {
    AnalogSteps& steps;
    AnalogPhotons<T>& p;
    T depth;  ///< of the collision that they come from; light of a film comes from none
    bool from_outside;

    void about_to_meet(const transport::AtWaves<T>& at, std::uint32_t facet) {
      const Index<T> of_surface(static_cast<std::int32_t>(transport::Touched::surface));
      const Mask<T> fresh = at.meets & (p.photon.order == Index<T>(0));
      if (facet == 0) p.touched = select(fresh, of_surface, p.touched);
    }
    /// `weight`: with which light has come to the film.
    void came_from_film(const Mask<T>& by_film, const T& weight) {
      depth = select(by_film, T(0), depth);
      if (!steps.world.tallies) return;
      TallyEvents<T>(steps.world, steps.tally).absorbed_in_film(by_film, weight);
    }
    void into_film(const Mask<T>& mask, const T& weight) const {
      if (!steps.world.tallies) return;
      TallyEvents<T>(steps.world, steps.tally).absorbed_in_film(of_source(p.photon, mask), weight);
    }
    void reflected(const Mask<T>& mask, const Vec3<T>& direction, const T& weight) const {
      rise(mask, direction, weight);
    }
    void passes(const Mask<T>& mask, const Vec3<T>& direction, const T&, const auto&) {
      transport::Photon<T> out = p.photon;
      out.direction = direction;
      rise(mask, direction, out.weight);
      steps.leave(p, out, mask, depth);
    }
    /// Light that leaves in clear air.
    void rise(const Mask<T>& mask, const Vec3<T>& direction, const T& weight) const {
      if (!steps.world.tallies || !steps.world.tallies->escapes_at_surface) return;
      const TallyEvents<T> events(steps.world, steps.tally);
      const Mask<T> light = of_source(p.photon, mask);
      events.escape(light, direction.z, weight, Mask<T>(!from_outside));
      events.rise_in_clear_air(light, p.photon, direction, weight);
    }
  };
  /// Photons of a mask that stand at the surface cross it, where they may meet a detector, or go
  /// back. `number`: a uniform.
  void cross_surface(AnalogPhotons<T>& p, const Mask<T>& stand, bool from_outside, const T& number,
                     const T& depth) {
    const Mask<T> standing = stand;  // it may be p.on, which changes
    ByChance<T, Ledger> rule{{world, p.place, ledger}, p.spectral_bin, number};
    AtDetectors observer{{}, *this, p, depth, from_outside};
    estimator::cross_surface(world, p, standing, from_outside, rule, observer);
  }
  /// Shows the tallies beside echoes a flight, and its end at a black end of the medium.
  void tally_flight(const transport::Photon<T>& before, const transport::Photon<T>& after,
                    const Index<T>& touched, const Mask<T>& flying,
                    const transport::FlightEnd<T>& end) {
    const TallyEvents<T> events(world, tally);
    events.flown(before, after, end, flying);
    if (!world.tallies->escapes_at_end) return;
    events.escape(of_source(after, flying & end.sea_bed), T(0) - after.direction.z, after.weight,
                  events.were_in_water(touched));
  }
  /// Photons of a mask that have been at the surface fly down from there. `depth`: of the collision
  /// that they come from.
  transport::FlightEnd<T> fly_on(AnalogPhotons<T>& p, const Mask<T>& flying, const T& depth,
                                 transport::FlightEnd<T> end) {
    transport::Photon<T> down = p.photon;
    const auto onward = fly_to_detectors(down, p.touched, flying, u[2], depth);
    p.photon = select(flying, down, p.photon);
    end.sea_bed = end.sea_bed | (flying & onward.sea_bed);
    end.sideways = end.sideways | (flying & onward.sideways);
    return end;
  }
  /// A flight in the water, whose photons may meet a detector there.
  transport::FlightEnd<T> fly_to_detectors(transport::Photon<T>& photon, const Index<T>& touched,
                                           const Mask<T>& flying, const T& number, const T& depth) {
    const transport::Photon<T> before = photon;
    const auto end = transport::fly(world.slabs, photon, minus_log(number));
    if (world.companion) [[unlikely]]
      world.companion->flown(photon, end.length, flying);
    if (world.tallies) tally_flight(before, photon, touched, flying, end);
    detect(world, before, touched, flying, end.length, false, depth, tally);
    return end;
  }
};

/// Follows photons until chance has decided what becomes of them; those that leave the world's
/// medium are added to `passed`. A witness is called at the end of each event with them and the
/// mask of those on their way before. Ledger: of one photon, or of lanes.
template <class T, class Ledger>
class Analog {
 public:
  Analog(const World<T>& world, tally::BatchTally& tally, AnalogPassed<T>& passed)
      : steps_{world, ledger_, tally, passed} {}

  /// Photons `first` … `first + count - 1` of the laser, the first of a batch and up.
  template <class Witness>
  void run(std::uint64_t first, std::uint64_t count, Witness witness) {
    const Draws<T> draws = draws_of_laser<T>(steps_.world.random, first);
    for (std::uint64_t n = 0; n < count; n += lanes_of<T>) {
      auto photons = steps_.birth(draws, static_cast<std::int32_t>(n), first_lanes<T>(count - n));
      follow(photons, witness);
    }
    close_ledger();
  }
  /// Photons that have come from the other medium.
  template <class Witness>
  void run(AnalogPassed<T>& arrivals, Witness witness) {
    for (AnalogPhotons<T>& photons : arrivals) {
      photons.place.key = steps_.world.random.key;
      follow(photons, witness);
    }
    arrivals.clear();
    close_ledger();
  }

 private:
  template <class Witness>
  void follow(AnalogPhotons<T>& photons, Witness& witness) {
    const auto each = [&](auto stage) { stage(photons); };
    while (any(photons.on)) {
      const Mask<T> before = photons.on;
      flights(steps_, each);
      collisions(steps_, each);
      witness(photons, before);
    }
  }
  void close_ledger() {
    tally::Ledger all = total(std::exchange(ledger_, {}));
    if (steps_.world.slabs.kind == medium::MediumKind::air)
      all.escaped += std::exchange(all.sea_bed, 0);  // upwards
    steps_.tally.ledger += all;
  }

  Ledger ledger_{};
  AnalogSteps<T, Ledger> steps_;
};

}  // namespace photic::estimator
