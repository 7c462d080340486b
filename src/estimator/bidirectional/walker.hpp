// Walks of the bidirectional estimator on their way: one, or one in each lane.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/flatten.hpp"
#include "estimator/bidirectional/depart.hpp"
#include "estimator/bidirectional/leg_terms.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "estimator/draws.hpp"
#include "estimator/ends.hpp"
#include "lanes/lane_columns.hpp"
#include "transport/flight.hpp"

namespace photic::estimator {

/// A walk that has begun, and what it has done since.
template <class T>
struct Walker {
  transport::Photon<T> photon;
  Index<T> walk{};  ///< where it is kept

  /// What a walk is born with.
  template <class F>
  constexpr void each_member(F f) {
    photon.each_member(f), f(walk);
  }

  Index<T> event{}, vertices{};
  Ray<T> ray;  ///< its last one
  Leg<T> leg;
  Vertical<T> axis;  ///< of a telescope's walk, where it has converted
};

/// Takes the walks from one instrument. A Source tells how they begin, what they draw, and whether
/// light from where a photon stands can still count; its ledger takes what ends.
template <class T, class Source>
class WalkTaker {
 public:
  WalkTaker(const World<T>& world, const Samples<T>& samples, Source& source, Walks<T>& walks,
            tally::BatchTally& tally)
      : world_(world),
        sea_(world.sea),
        samples_(samples),
        source_(source),
        walks_(walks),
        tally_(tally) {}

  /// Takes so many to their ends.
  PHOTIC_FLATTEN void take(std::size_t count) {
    std::size_t begun = 0;
    for (Mask<T> on(false);;) {
      for (Mask<T> free = !on; any(free); free = !on) {
        if (waiting_ == 0) {
          if (begun >= count) break;
          births(begun, count - begun);
          begun += lanes;
        } else {
          on = on | take_from_queue(free);
        }
      }
      if (!any(on)) return;
      on = next_event(on);
    }
  }

 private:
  static constexpr std::size_t lanes = lanes_of<T>;

  /// The next walks, as many as there are lanes.
  void births(std::size_t first, std::size_t left) {
    const Mask<T> exist = first_lanes<T>(left);
    Walker<T> walker;
    // Lanes without a walk draw the numbers of another: beyond the batch there are none.
    walker.walk = select(exist, Index<T>(first) + lane_numbers<T>(), Index<T>(first));
    BirthRecord<T> record;
    const auto birth = source_.birth(walker.walk, exist, record);
    const Mask<T> born = exist & birth.exists;
    walker.photon = birth.photon;
    record.spread = birth.spread;
    walks_.leave_out(exist & !birth.exists, walker.walk);
    walks_.birth(born, walker.walk, record, {walk_point(birth.photon)});
    if (world_.compares) [[unlikely]]
      begin_ratios(walker.walk, born);
    waiting_columns_.each(
        walker, [&](const auto& member, auto* column) { compress(born, member, column); });
    waiting_ = count(born);
    taken_ = 0;
  }
  /// Gives free lanes to those who wait. Tells which it gave.
  Mask<T> take_from_queue(const Mask<T>& free) {
    std::uint32_t given = 0;
    std::size_t n = 0;
    for (std::uint32_t left = lane_bits(free); left != 0 && n < waiting_; left &= left - 1, ++n)
      given |= left & -left;
    const Mask<T> mask = mask_of_bits<T>(given);
    waiting_columns_.each(
        walker_, [&](auto& member, const auto* column) { expand(mask, column + taken_, member); });
    walker_.event = select(mask, Index<T>(0), walker_.event);
    walker_.vertices = select(mask, Index<T>(0), walker_.vertices);
    lanes::assign<T>(mask, Ray<T>{walk_point(walker_.photon)}, walker_.ray);
    walker_.leg = select(mask, Leg<T>{}, walker_.leg);
    walker_.axis.exists = walker_.axis.exists & !mask;
    taken_ += n;
    waiting_ -= n;
    return mask;
  }

  /// One event of those who are `on` their way: a flight, and what stands at its end. Tells who
  /// goes on.
  Mask<T> next_event(Mask<T> on) {
    using namespace transport;
    Photon<T>& photon = walker_.photon;
    walker_.event = walker_.event + Index<T>(1);
    const auto u = source_.draw(walker_.walk, walker_.event, 0);
    const Photon<T> before = photon;
    const auto end = fly(sea_, photon, minus_log(u[0]));
    add_flight(sea_, before, photon, walker_.leg);
    book(source_.ledger.sea_bed, on & end.sea_bed, photon.weight);
    on = on & !end.sea_bed;
    const Mask<T> late = on & !source_.in_time(photon);
    book(source_.ledger.cut_by_time, late, photon.weight);
    on = on & !late;

    const Mask<T> reflected = on & end.surface;
    Mask<T> colliding = on & !end.surface;
    Photon<T> down = photon;
    if (any(reflected)) {
      book(source_.ledger.escaped, reflected, reflect_down(sea_, down));
      walker_.leg.mirrored = walker_.leg.mirrored | reflected;
    }
    if (any(colliding)) collide(u, colliding);
    if (any(reflected)) photon = select(reflected, down, photon);
    on = reflected | colliding;

    on = play_roulette(photon, world_.weight_threshold, u[3], on, source_.ledger);
    const Mask<T> finite = photon.weight <= T(std::numeric_limits<Element<T>>::max());
    tally_.not_finite += count(on & !finite);
    on = on & finite;
    const Mask<T> worn = on & (walker_.event + Index<T>(1) >= Index<T>(most_events));
    tally_.too_many_events += count(worn);
    book(source_.ledger.lost, worn, photon.weight);
    return on & !worn;
  }

  /// What becomes of walks that collide where they stand: they note the vertex and the ray in which
  /// they leave it, or end.
  void collide(const std::array<T, 4>& u, Mask<T>& colliding) {
    using namespace transport;
    Photon<T>& photon = walker_.photon;
    tally_.collisions += count(colliding);
    const Mask<T> first = colliding & (walker_.vertices == Index<T>(0));
    const Spread<T> spread = any(first) ? walks_.birth_record(walker_.walk).spread : Spread<T>{};
    Vertex<T> vertex =
        vertex_on(sea_, walker_.ray, first, spread, photon, walker_.leg, walker_.axis, samples_);
    source_.keep_unshifted(walks_, walker_.walk, first, vertex);
    walks_.add(colliding, walker_.walk, walker_.vertices, vertex);
    walker_.vertices = walker_.vertices + select(colliding, Index<T>(1), Index<T>(0));

    const Mask<T> last = colliding & (walker_.vertices == Index<T>(world_.last_order));
    book(source_.ledger.cut_by_order, last, photon.weight);
    colliding = colliding & !last;
    const Mask<T> full = colliding & (walker_.vertices == Index<T>(world_.most_vertices));
    tally_.too_many_events += count(full);
    book(source_.ledger.lost, full, photon.weight);
    colliding = colliding & !full;

    const T weight = photon.weight;
    const Mask<T> convertible = colliding & (photon.line > Index<T>(0));
    const auto v =
        any(convertible) ? source_.draw(walker_.walk, walker_.event, 1) : std::array<T, 4>{};
    const auto departure = depart(sea_, photon, world_.inverse_conversion, {u[1], u[2], v[0], v[1]},
                                  walks_.from_telescope());
    book(source_.ledger.absorbed, colliding, weight - photon.weight);
    const Ray<T> ray = next_ray(photon, vertex, departure);
    walks_.add(colliding, walker_.walk, walker_.vertices, ray);
    if (walks_.from_telescope()) {
      const Mask<T> pivots =
          walks_.pivot(sea_, colliding, walker_.walk, walker_.vertices - Index<T>(1), vertex, ray,
                       world_.turns_scattered);
      walker_.axis =
          select(pivots, {Mask<T>(true), vertex.position.x, vertex.position.y}, walker_.axis);
    }
    if (world_.compares) [[unlikely]]
      keep_ratios(vertex, ray, colliding);
    lanes::assign<T>(colliding, ray, walker_.ray);
    walker_.leg = select(colliding, Leg<T>{}, walker_.leg);
  }

  PHOTIC_APART void begin_ratios(Index<T> walk, const Mask<T>& mask) {
    const auto first = each_lane(Walks<T>::slot(walk, Index<T>(0)));
    for_each_lane(mask, [&](int lane) {
      walks_.ratios().of(first[static_cast<std::size_t>(lane)]).begin(sea_.environments);
    });
  }
  /// Of walks that leave a vertex by a new ray, from those of the ray before.
  PHOTIC_APART void keep_ratios(const Vertex<T>& vertex, const Ray<T>& ray, const Mask<T>& mask) {
    way_.clear();
    collision_.clear();
    add_leg(sea_, walker_.ray, vertex, way_);
    add_encounter(sea_,
                  {vertex.line, vertex.layer, Mask<T>(!(vertex.line == ray.line)), vertex.line,
                   one_minus_cos(vertex.direction, ray.direction)},
                  collision_);
    const auto next = each_lane(Walks<T>::slot(walker_.walk, walker_.vertices));
    for_each_lane(mask, [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      const auto slot = static_cast<std::size_t>(next[k]);
      walks_.ratios().copy(sea_.environments, slot - 1, slot);
      const auto kept = walks_.ratios().of(slot);
      kept.pass(sea_.environments, way_, k);
      kept.collide(sea_.environments, collision_, k);
    });
  }

  const World<T>& world_;
  const medium::MediumView& sea_;
  const Samples<T>& samples_;
  Source& source_;
  Walks<T>& walks_;
  tally::BatchTally& tally_;
  Walker<T> walker_;
  Terms<T> way_, collision_;  ///< of what happens to it, in environments

  /// Of those who have begun without a lane; readable for as many more.
  lanes::LaneColumns<T, Walker<T>, 2 * lanes> waiting_columns_;
  std::size_t waiting_ = 0, taken_ = 0;
};

}  // namespace photic::estimator
