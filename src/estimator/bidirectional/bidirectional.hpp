// The bidirectional estimator: walks from the laser and from the telescopes, and all connections
// between them (docs/bidirectional.md).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "estimator/bidirectional/connections.hpp"
#include "estimator/bidirectional/surface_entry.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "estimator/bidirectional/walk_track.hpp"
#include "estimator/draws.hpp"
#include "estimator/termination.hpp"

namespace photic::estimator {

/// The random numbers of walks that go with photons of a batch from `first` on.
template <class T>
struct WalkDraws {
  const Draws<T>& draws;
  std::int32_t first;

  [[nodiscard]] std::array<T, 4> draw(const Index<T>& walk, const Index<T>& event,
                                      std::uint32_t block) const {
    return draws(Index<T>(first) + walk, event, block);
  }
};

/// The beginning of the laser's walks.
template <class T, class Ledger>
struct FromLaser : WalkDraws<T> {
  const World<T>& world;
  Ledger& ledger;

  bool of_own_rays = true;  ///< else the others, whose light is not the laser's

  [[nodiscard]] static std::int32_t instrument() { return of_laser; }
  [[nodiscard]] const EntryCone<T>& cone() const { return world.walks.laser_cone; }

  /// met(mask, meeting), flown(mask, segment): as of begin_at_facets().
  template <class Met, class Flown>
  Birth<T> birth(const Index<T>& walk, const Mask<T>& exist, BirthRecord<T>& record, Met met,
                 Flown flown) {
    const auto u = this->draw(walk, Index<T>(0), 0);
    const T n(gather<T>(world.slabs.index, Index<T>(0)));
    if (enters_through_waves(world.slabs, world.instruments.laser_region))
      return birth_through_waves(walk, exist, u, met);
    auto birth =
        world.instruments.laser.collimated
            ? birth_at_collimated_laser(world.slabs, world.instruments.laser,
                                        world.instruments.laser_region, cone(), n, u[0], u[1])
            : birth_at_laser(world.slabs, world.instruments.laser, world.instruments.laser_region,
                             cone(), draw_entry(cone(), n, n, u[0], u[1]));
    if (world.instruments.laser.collimated) birth.own = birth.exists;
    if (!world.slabs.surface.one_direction_each) {
      const auto lost = begin_at_facets(
          world.slabs, cone(), u[2], false, birth,
          [&](std::uint32_t block) { return this->draw(walk, Index<T>(0), block); }, met, flown);
      book(ledger.oil, exist, lost.into_film);
      book(ledger.escaped, exist, lost.weight - lost.into_film);
    } else if (of_own_rays) {
      book_way_in(walk, exist, u, select(birth.own, birth.photon.weight, T(0)));
    }
    record.own = birth.own;
    birth.exists = of_own_rays ? birth.own : !birth.own;
    return birth;
  }
  template <class Met>
  Birth<T> birth_through_waves(const Index<T>& walk, const Mask<T>& exist,
                               const std::array<T, 4>& u, Met met) {
    auto entry =
        entry_of_laser(world.instruments.laser, world.instruments.laser_region, u[0], u[1]);
    const auto v = this->draw(walk, Index<T>(0), 1);
    entry.u_slope = v[0], entry.u_azimuth = v[1];
    auto birth = estimator::birth_through_waves(
        world.slabs, world.instruments.laser_region, cone(), entry, false, Index<T>(0), u[2], u[3],
        [&](std::uint32_t block) { return this->draw(walk, Index<T>(0), block); }, met);
    book_way_in(walk, exist, u, select(birth.exists, birth.photon.weight, T(0)));
    return birth;
  }
  /// Books the weight that does not get into the water; `weight`: that which does.
  void book_way_in(const Index<T>& walk, const Mask<T>& exist, const std::array<T, 4>& u,
                   const T& weight) {
    T escaped = T(1) - weight;
    if (world.slabs.surface.absorbs) [[unlikely]] {
      const T absorbed = absorbed_on_way_in(world, u[0], u[1], [this, walk](std::uint32_t block) {
        return this->draw(walk, Index<T>(0), block);
      });
      book(ledger.oil, exist, absorbed);
      escaped = escaped - absorbed;
    }
    book(ledger.escaped, exist, escaped);
  }
  /// The walks that do not set out.
  [[nodiscard]] Mask<T> left_out(const Birth<T>& birth) const {
    return of_own_rays ? !birth.exists : Mask<T>(false);
  }
  [[nodiscard]] Mask<T> in_time(const transport::Photon<T>& photon) const {
    return estimator::in_time(world.instruments, photon);
  }
};

/// The beginning of a telescope's walks.
template <class T, class Ledger>
struct FromTelescope : WalkDraws<T> {
  const World<T>& world;
  const Receiver<T>& receiver;
  Ledger ledger{};  ///< not reported: the result has the ledger of the laser's light

  [[nodiscard]] std::int32_t instrument() const { return of_telescope(receiver.telescope); }
  [[nodiscard]] const EntryCone<T>& cone() const {
    return world.walks.telescope_cones[receiver.telescope];
  }

  template <class Met, class Flown>
  Birth<T> birth(const Index<T>& walk, const Mask<T>& exist, BirthRecord<T>& record, Met met,
                 Flown flown) {
    const auto& telescope = world.instruments.telescopes[receiver.telescope];
    const auto u = this->draw(walk, Index<T>(0), 0);
    record.lens = lens_point(telescope, u[0], u[1]);
    const auto v = this->draw(walk, Index<T>(0), 1);
    record.grid_offset = v[0];
    record.connected = select(v[1] < world.walks.connected, Index<T>(1), Index<T>(0));
    record.line = line_of(medium::spectral_bin_of(v[2]));
    if (enters_through_waves(world.slabs, receiver.region))
      return birth_through_waves(walk, record, u, met);
    const auto ray = draw_entry(cone(), gather<T>(world.slabs.index, record.line),
                                gather<T>(world.slabs.index, Index<T>(0)), u[2], u[3]);
    record.outward = ray.outside;
    record.translation_area = translation_area(world, telescope, receiver.region, record.outward);
    auto birth = birth_at_telescope(world.slabs, telescope, receiver.region, cone(), ray,
                                    record.line, record.lens);
    record.telescope = world.instruments.groups[receiver.group].narrowest(birth.sight);
    if (!cone().even_outside) birth.exists = exist;
    if (!world.slabs.surface.one_direction_each) {
      const auto w = this->draw(walk, Index<T>(0), 2);
      birth.entry.u_choice = w[0], birth.entry.u_slope = w[1], birth.entry.u_azimuth = w[2];
      begin_at_facets(
          world.slabs, cone(), v[3], true, birth,
          [&](std::uint32_t block) { return this->draw(walk, Index<T>(0), block); }, met, flown);
    }
    record.own = birth.own;
    return birth;
  }
  template <class Met>
  Birth<T> birth_through_waves(const Index<T>& walk, BirthRecord<T>& record,
                               const std::array<T, 4>& u, Met met) {
    const auto& telescope = world.instruments.telescopes[receiver.telescope];
    const auto w = this->draw(walk, Index<T>(0), 2);
    const auto point = transport::point_seen(telescope, record.lens, w[0], w[1]);
    instrument::Sight<T> sight;
    T density;
    auto entry = entry_of_telescope(telescope, record.lens, point.at, sight, density);
    entry = behind_air(receiver.region, record.line, entry);
    entry.exists = entry.exists & point.exists;
    entry.u_slope = w[2], entry.u_azimuth = w[3];
    record.outward = entry.outside;
    record.translation_area = translation_area(world, telescope, receiver.region, record.outward);
    record.telescope = world.instruments.groups[receiver.group].narrowest(sight);
    return estimator::birth_through_waves(
        world.slabs, receiver.region, cone(), entry, true, record.line, u[2], u[3],
        [&](std::uint32_t block) { return this->draw(walk, Index<T>(0), block); }, met);
  }
  [[nodiscard]] static Mask<T> left_out(const Birth<T>& birth) { return !birth.exists; }
  /// The line that a walk of a spectral_bin detects.
  [[nodiscard]] Index<T> line_of(const Index<T>& spectral_bin) const {
    if (receiver.band < 0) return receiver.line;
    return gather_index<T>(world.slabs.line_of_spectral_bin,
                           Index<T>(receiver.band * medium::spectral_bins) + spectral_bin);
  }
  /// Returns whether light can still come from the laser within the last gate.
  [[nodiscard]] Mask<T> in_time(const transport::Photon<T>& photon) const {
    return receiver.deadline.is_met(photon, world.instruments.min_group_index);
  }
};

/// Follows photons of the laser, some of them at once. Ledger: of one photon, or of lanes.
template <class T, class Ledger>
class Bidirectional {
 public:
  /// `at_once`: so many sets of walks.
  Bidirectional(const World<T>& world, std::size_t at_once)
      : world_(world),
        at_once_(at_once * world.walks.laser_walks),
        laser_(at_once_, false, comes_through_flat(world.slabs, world.instruments.laser_region),
               world.slabs) {
    for (const auto& group : world.instruments.groups)
      back_.emplace_back(at_once_, true, comes_through_flat(world.slabs, group.region),
                         world.slabs);
  }

  /// Photons `first` … `first + count - 1`, the first of a batch and up. A witness is called after
  /// each receiver's walks.
  template <class Witness>
  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally, Witness witness) {
    const auto laser = draws_of_laser<T>(world_.random, first);
    std::vector<WantedReceiver> back;
    for (const Receiver<T>& receiver : world_.walks.receivers)
      if (is_wanted(receiver, tally))
        back.push_back({receiver, draws_of<T>(world_.random, receiver, first)});
    Ledger ledger;
    for (std::size_t done = 0; done < count;) {
      // The last set may have fewer walks, and then fewer samples are made.
      const std::size_t left = count - done;
      const std::size_t walks = std::min(world_.walks.laser_walks, left);
      const std::size_t now = std::min(at_once_, left / walks * walks);
      follow(static_cast<std::int32_t>(done), now, walks, laser, back, ledger, tally, witness);
      done += now;
    }
    tally.ledger += total(ledger);
  }

 private:
  static bool comes_through_flat(const geometry::Slabs& sea, const geometry::Region<T>& region) {
    return region.outside && sea.surface.one_direction_each;
  }

  /// A receiver whose light is asked for, and the random numbers of its walks.
  struct WantedReceiver {
    const Receiver<T>& receiver;
    Draws<T> draws;
  };
  [[nodiscard]] bool is_wanted(const Receiver<T>& receiver, const tally::BatchTally& tally) const {
    if (receiver.band < 0) return tally.wants(receiver.telescope, each_lane(receiver.line)[0]);
    for (std::int32_t spectral_bin = 0; spectral_bin < medium::spectral_bins; ++spectral_bin) {
      const std::int32_t line =
          world_.slabs.line_of_spectral_bin[receiver.band * medium::spectral_bins + spectral_bin];
      if (tally.wants(receiver.telescope, line)) return true;
    }
    return false;
  }

  template <class Witness>
  void follow(std::int32_t first, std::size_t count, std::size_t walks, const Draws<T>& laser,
              const std::vector<WantedReceiver>& back, Ledger& ledger, tally::BatchTally& tally,
              Witness& witness) {
    // An echo is per photon emitted, and so are the samples.
    const Samples<T> samples{T(1),
                             world_.walks.connected,
                             T(walks),
                             T(world_.walks.uses.rotated ? walks : 0),
                             world_.walks.meeting_grid,
                             world_.walks.free_telescope,
                             world_.walks.free_laser};
    FromLaser<T, Ledger> from_laser{{laser, first}, world_, ledger};
    WalkTracer(world_, samples, from_laser, laser_, tally).trace(count);
    if (!world_.walks.laser_cone.exact && any(samples.free_laser.most > T(0))) {
      Ledger of_no_light;
      FromLaser<T, Ledger> others{{laser, first}, world_, of_no_light, false};
      WalkTracer(world_, samples, others, laser_, tally).trace(count);
    }
    for (const auto& [receiver, draws] : back) {
      Walks<T>& walks_back = back_[receiver.group];
      FromTelescope<T, Ledger> from_telescope{{draws, first}, world_, receiver};
      WalkTracer(world_, samples, from_telescope, walks_back, tally).trace(count);
      connect(receiver, samples, walks_back, count, walks, tally);
      witness(receiver);
    }
  }

  void connect(const Receiver<T>& receiver, const Samples<T>& samples, const Walks<T>& back,
               std::size_t count, std::size_t walks, tally::BatchTally& tally) {
    Connections<T> connections(world_, receiver, samples, laser_, back, tally);
    for (std::size_t g = 0; g < count; ++g) {
      const bool lit = laser_.is_own(g), seen = back.is_own(g);
      if (lit) connections.to_telescope(g);
      if (back.rays(g) == 0) continue;
      if (seen) connections.to_laser(g);
      if (lit && seen && back.connected(g)) connections.between(g);
      connections.meetings(g / walks * walks, walks, g);
    }
    connections.flush();
  }

  const World<T>& world_;
  std::size_t at_once_;
  Walks<T> laser_;
  std::vector<Walks<T>> back_;  ///< of each group of telescopes, and one line after the other
};

}  // namespace photic::estimator
