// The steps of an event (estimator/event.hpp) of the bidirectional estimator's walks: they note
// their collisions and their ways on, for the connections.
#pragma once

#include <array>
#include <type_traits>

#include "core/flatten.hpp"
#include "estimator/bidirectional/depart.hpp"
#include "estimator/bidirectional/surface_entry.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "estimator/crossing.hpp"
#include "estimator/draws.hpp"
#include "estimator/event.hpp"
#include "estimator/termination.hpp"

namespace photic::estimator {

/// A walk that has begun, and what it has done since.
template <class T>
struct WalkTrack : Track<T> {
  Index<T> walk{};  ///< its number among those kept

  /// The members that a walk is born with.
  template <class F>
  constexpr void each_member(F f) {
    this->photon.each_member(f), f(walk);
  }

  Index<T> event{}, vertices{};
  Ray<T> ray;  ///< its last one
  Leg<T> leg;
  SentBack<T> facets;    ///< on the leg
  RotationAxis<T> axis;  ///< of a telescope's walk that has its pivot behind it
  FirstVertex<T> first;  ///< as far as it is known
};

/// The steps of walks from one instrument. A Source has their beginning and their draws, and
/// decides whether light from a photon's place can still count; its ledger takes the weight that
/// ends.
template <class T, class Source>
class WalkSteps {
 public:
  WalkSteps(const World<T>& world, const Samples<T>& samples, Source& source, Walks<T>& walks,
            tally::BatchTally& batch)
      : ledger(source.ledger),
        tally(batch),
        world_(world),
        sea_(world.slabs),
        samples_(samples),
        source_(source),
        walks_(walks) {}

  template <class Each>
  void begin_event(Each each) {
    each([&](auto& w) {
      w.event = w.event + Index<T>(1);
      u_ = source_.draw(w.walk, w.event, 0);
    });
  }
  void look_ahead(const WalkTrack<T>&) {}
  void draw_free_path(const WalkTrack<T>&) {}

  transport::FlightEnd<T> fly(WalkTrack<T>& w) {
    const transport::Photon<T> before = w.photon;
    T free_path = minus_log(u_[0]);
    const Mask<T> first = w.vertices == Index<T>(0);
    if (any(first))
      free_path =
          free_path * select(first, source_.cone().longer_free_path(before.direction.z), T(1));
    const auto end = transport::fly(sea_, w.photon, free_path);
    if (world_.companion) [[unlikely]]
      world_.companion->flown(w.photon, end.length, w.on);
    const T walk_tau = w.leg.walk_tau;
    add_flight(sea_, before, w.photon, end.length, w.leg);
    if (any(first)) {
      Mask<T> stopped = end.surface | end.sea_bed;
      if (sea_.bed_angles > 0) stopped = stopped | surface::on_bed<T>(sea_, w.photon.layer);
      const T over =
          source_.cone().over_reach(w.leg.walk_tau - walk_tau, before.direction.z, stopped);
      w.photon.weight = w.photon.weight * select(first, over, T(1));
    }
    return end;
  }
  [[nodiscard]] Mask<T> in_time(const transport::Photon<T>& photon) const {
    return source_.in_time(photon);
  }
  void cross(WalkTrack<T>& w) {
    const Mask<T> stand = w.on & !w.colliding;
    if (!any(stand)) return;
    AtSurface rule{sea_, source_, walks_};
    NoObserver observer;
    cross_surface(world_, w, stand, false, rule, observer);
    w.leg.reflected = w.leg.reflected | (stand & w.on);
  }

  /// The vertex.
  void score(WalkTrack<T>& w) {
    if (!any(w.colliding)) return;
    const Mask<T> first = w.colliding & (w.vertices == Index<T>(0));
    Spread<T> spread = any(first) ? walks_.birth_record(w.walk).spread : Spread<T>{};
    if (source_.cone().enters_by_slopes && any(first)) [[unlikely]]
      spread = enter_by_slopes(world_, walks_, source_.instrument(), w.walk, w.photon.line,
                               w.photon.position, first);
    const T reach = reach_of(sea_, source_.cone(), first, w.photon, w.leg);
    const Arrival<T> arrival{w.ray,
                             w.leg,
                             first,
                             w.vertices > Index<T>(1),
                             reach,
                             walks_.has_facets() ? &w.facets : nullptr,
                             walks_.rotates(w.walk, w.vertices)};
    vertex_ = vertex_on(sea_, arrival, spread, w.photon, w.axis, samples_);
    walks_.add(w.colliding, w.walk, w.vertices, vertex_);
    const Mask<T> near = w.colliding & (w.vertices < Index<T>(2));
    if (any(near)) {
      w.first.arrive(vertex_, arrival, spread, samples_);
      walks_.keep(near, w.walk, w.first, samples_.frees());
    }
    if (sea_.bed_angles > 0)
      walks_.come_to_bed(w.colliding & surface::on_bed<T>(sea_, w.photon.layer), w.walk,
                         w.vertices);
    w.vertices = w.vertices + select(w.colliding, Index<T>(1), Index<T>(0));
  }
  void collide(WalkTrack<T>& w) {
    book_out(w, w.colliding & (w.vertices == Index<T>(world_.part.last_order)),
             ledger.cut_by_order);
    const Mask<T> full = w.on & w.colliding & (w.vertices == Index<T>(world_.walks.max_vertices));
    tally.too_many_events += count(full);
    book_out(w, full, ledger.lost);
    w.colliding = w.colliding & w.on;
  }
  /// The ray in which they leave it: scattered, or converted backwards.
  template <class Each>
  void scatter(Each each) {
    each([&](auto& w) { leave_vertex(w); });
  }

  void play_roulette(WalkTrack<T>& w) {
    w.on = estimator::play_roulette(w.photon, T(min_weight), u_[3], w.on, ledger);
  }
  [[nodiscard]] static const Index<T>& event_of(const WalkTrack<T>& w) { return w.event; }

  std::remove_reference_t<decltype(Source::ledger)>& ledger;
  tally::BatchTally& tally;

 private:
  // Under waves. Static, and with copies: what has its address taken is kept in memory.
  /// First vertices, of a mask, may also be connected by entries that slopes draw.
  PHOTIC_APART static Spread<T> enter_by_slopes(const World<T>& world, const Walks<T>& walks,
                                                std::int32_t instrument, Index<T> walk,
                                                Index<T> line, Vec3<T> position, Mask<T> first) {
    const auto record = walks.birth_record(walk);
    return spread_by_entries(
        slopes_over_rays(world, instrument, line, position, walks.entry(walk), record.lens, first),
        record.spread);
  }
  /// The rule of cross_surface(): shares, or facets one by one.
  struct AtSurface {
    const geometry::Slabs& sea;
    Source& source;
    Walks<T>& walks;

    void cross_flat(WalkTrack<T>& w, const Mask<T>& stand, bool, NoObserver& observer) const {
      cross_by_shares(sea, w, stand, false, Mask<T>(false), source.ledger, observer);
    }
    void cross_film(WalkTrack<T>& w, const Mask<T>& stand, bool, NoObserver& observer) const {
      cross_flat(w, stand, false, observer);
    }
    void cross_facets(WalkTrack<T>& w, const Mask<T>&, bool, NoObserver&) const {
      w = meet_facets(sea, source, walks, w);
    }
  };
  /// Has walks at the surface meet facets until they go down in the water, or have left. Walks
  /// straight from an instrument end: others begin with light sent back by facets.
  PHOTIC_APART static WalkTrack<T> meet_facets(const geometry::Slabs& sea, Source& source,
                                               Walks<T>& walks, WalkTrack<T> w) {
    const bool back = walks.from_telescope();
    w.on = w.on & (w.colliding | (w.vertices > Index<T>(0)));
    const Mask<T> stand = w.on & !w.colliding;
    if (!any(stand)) return w;
    const T before = w.photon.weight;
    const auto draw = [&](std::uint32_t block) { return source.draw(w.walk, w.event, block); };
    const auto surface = surface::rough_surface<T>(sea, w.photon.line);
    const auto met = [&](const Mask<T>& mask, const surface::FacetHit<T>& meeting) {
      if (auto* ratios = walks.ratios())
        ratios->met(sea, meeting, Walks<T>::slot(w.walk, w.vertices), mask);
    };
    const auto by = walk_by_facets(back, surface, w.photon, stand, false, Facets::any, draw, met);
    // A walk's weight is what light is worth that comes the path, but for its chances.
    if (back) {
      w.photon.weight = w.photon.weight * select(stand, by.chance, T(1));
      w.facets.chance = select(stand, by.chance, w.facets.chance);
    } else {
      w.facets.reverse_chance = select(stand, by.chance, w.facets.reverse_chance);
    }
    w.facets.walk_tau = select(stand, w.leg.walk_tau, w.facets.walk_tau);
    walks.send_back(stand & by.in_water, w.walk, w.vertices,
                    behind_facets(w.ray, w.photon, w.facets));
    const T gone = before - select(by.in_water, w.photon.weight, T(0));
    book(source.ledger.oil, stand, by.into_film);
    book(source.ledger.escaped, stand, gone - by.into_film);
    w.on = w.on & ((!stand) | by.in_water);
    return w;
  }
  void leave_vertex(WalkTrack<T>& w) {
    const Mask<T>& colliding = w.colliding;
    if (!any(colliding)) return;
    const Mask<T> convertible = colliding & (w.photon.line > Index<T>(0));
    const auto v = any(convertible) ? source_.draw(w.walk, w.event, 1) : std::array<T, 4>{};
    transport::Photon<T> photon = w.photon;
    const auto departure = depart(sea_, photon, world_.walks.inverse_conversion,
                                  {u_[1], u_[2], v[0], v[1]}, walks_.from_telescope());
    if (world_.companion) [[unlikely]]
      world_.companion->collided(w.photon, photon, colliding);
    Mask<T> in_water = colliding;
    if (sea_.bed_angles > 0) {
      const Mask<T> bed = surface::on_bed<T>(sea_, w.photon.layer);
      book(ledger.sea_bed, colliding & bed, w.photon.weight - photon.weight);
      in_water = colliding & !bed;
    }
    book(ledger.absorbed, in_water, w.photon.weight - photon.weight);
    w.photon = any(w.on & !colliding) ? select(colliding, photon, w.photon) : photon;
    const Ray<T> ray = next_ray(sea_, photon, vertex_, departure,
                                w.vertices > Index<T>(2));  // of edges with the one that is left
    walks_.add(colliding, w.walk, w.vertices, ray);
    const Mask<T> near = colliding & (w.vertices < Index<T>(3));
    if (any(near)) {
      const Mask<T> from_first = colliding & (w.vertices == Index<T>(1));
      const T averaged = source_.cone().by_depth && any(from_first)
                             ? averaged_over_drawn(world_, source_.instrument(), vertex_.line,
                                                   vertex_.layer, vertex_.line == ray.line,
                                                   vertex_.direction.z, ray.direction, departure.p)
                             : T(1);
      w.first.depart(ray, averaged, from_first);
      walks_.keep(near, w.walk, w.first, samples_.frees());
    }
    if (walks_.from_telescope()) {
      const Mask<T> pivots = walks_.pivot(sea_, colliding, w.walk, w.vertices - Index<T>(1),
                                          vertex_, ray, world_.walks.uses.rotated_scattered);
      w.axis = select(pivots, {Mask<T>(true), vertex_.position.x, vertex_.position.y}, w.axis);
    }
    if (auto* ratios = walks_.ratios()) [[unlikely]]
      ratios->collided(sea_, w.ray, vertex_, ray, walks_.from_telescope(),
                       Walks<T>::slot(w.walk, w.vertices), w.vertices, colliding);
    lanes::assign<T>(colliding, ray, w.ray);
    w.leg = select(colliding, Leg<T>{}, w.leg);
  }

  const World<T>& world_;
  const geometry::Slabs& sea_;
  const Samples<T>& samples_;
  Source& source_;
  Walks<T>& walks_;
  // For the event:
  std::array<T, 4> u_{};
  Vertex<T> vertex_;
};

}  // namespace photic::estimator
