// The forward estimator's steps of an event (estimator/event.hpp): expected values stand in for
// draws, and telescopes score each collision.
#pragma once

#include <cstdint>
#include <functional>

#include "estimator/event.hpp"
#include "estimator/fly_in_shells.hpp"
#include "estimator/forward/at_surface.hpp"
#include "estimator/forward/companions.hpp"
#include "estimator/forward/estimate.hpp"
#include "estimator/forward/expected_collision.hpp"
#include "estimator/forward/film.hpp"
#include "estimator/forward/tally_escape.hpp"
#include "estimator/forward/targets.hpp"
#include "estimator/forward/tools.hpp"
#include "estimator/termination.hpp"
#include "transport/collide.hpp"
#include "transport/scatter.hpp"

namespace photic::estimator {

/// The steps of photons by Events: PlainEvents or AllEvents, as the world asks for. draw(block)
/// draws a block of the random numbers of their events, and is called once for each stage of an
/// event. `leave`: see pass_surface(). Ledger: of one photon, or of lanes.
template <class Events, class T, class Ledger>
struct ForwardSteps {
  const World<T>& world;
  Ledger& ledger;
  tally::BatchTally& tally;
  Estimates<T>& estimates;
  std::function<void(std::uint32_t block)> draw;
  Leave<T> leave;

  template <class Each>
  void begin_event(Each each) {
    each([](auto& t) { t.place.event = t.place.event + Index<T>(1); });
    draw(event_blocks[0]);
    if (world.forward.makes_choices) draw(event_blocks[1]);
    if (!world.forward.cones.empty()) draw(event_blocks[2]);
  }

  /// Scores a flight before it begins.
  void look_ahead(ForwardTracks<T>& t) {
    if constexpr (Events::tallies)
      if (world.tallies && !is_in_shells(world)) tally_escape_ahead<Ledger>(world, t, t.on, tally);
    if (!world.forward.cones.empty())
      score_on_the_way<Events>(world, t, who_are_scored(world, t, t.on), estimates, tally);
    if constexpr (Events::tools) begin_with_tools<Events>(world, t, t.on, ledger, leave);
    score_further_points<Events>(world, t, estimates, tally);
  }

  void draw_free_path(ForwardTracks<T>& t) {
    t.free_path = minus_log(path_number<Events>(t, t.u[0]));
  }

  transport::FlightEnd<T> fly(ForwardTracks<T>& t) {
    transport::Photon<T>& photon = t.photon;
    const auto companions = companions_of<Events>(world, t);
    companions.before(photon);
    if constexpr (Events::tallies)
      if (is_in_shells(world)) {
        const auto end = fly_in_shells(world, t, t.free_path, tally, ledger);
        companions.flown(photon, end.length, t.on);
        return end;
      }
    auto end = transport::fly(world.slabs, photon, t.free_path);
    if constexpr (Events::tallies)
      if (world.tallies) TallyEvents<T>(world, tally).flown(t.ratios.before, photon, end, t.on);
    if (flies_on()) {
      transport::fly_on(world.slabs, photon, end, [&](const Mask<T>& reflected, auto& down) {
        t.on = (t.on & !reflected) | reflect_in_flight(t, t.on & reflected, down);
      });
    }
    companions.flown(photon, end.length, t.on);
    return end;
  }
  [[nodiscard]] Mask<T> in_time(const transport::Photon<T>& photon) const {
    return estimator::in_time(world.instruments, photon);
  }

  void cross(ForwardTracks<T>& t) {
    if (flies_on()) return;
    cross_surface<Events>(world, t, Mask<T>(t.on & !t.colliding), false, estimates, tally, ledger,
                          leave);
  }

  /// If that has not been done on the way, where only collisions in the water are.
  void score(const ForwardTracks<T>& t) {
    Mask<T> scored = who_are_scored(world, t, t.colliding);
    if (Events::tools && world.forward.tools.scores_on_the_way)
      scored = scored & surface::on_bed<T>(world.slabs, t.photon.layer);
    if (any(scored)) score_scattering<Events>(world, t, scored, estimates, tally);
  }

  /// Some go on as light of another wavelength, what is absorbed is lost.
  void collide(ForwardTracks<T>& t) {
    if (world.part.last_order > 0) {
      const Index<T> next = t.photon.order + Index<T>(1);
      book_out(t, t.colliding & (next == Index<T>(world.part.last_order)), ledger.cut_by_order);
      t.colliding = t.colliding & t.on;
    }
    const Mask<T>& colliding = t.colliding;
    if (!any(colliding)) return;
    transport::Photon<T> photon = t.photon;
    const Index<T> here = world.slabs.at(photon.line, photon.layer);
    book(ledger.absorbed, colliding, photon.weight * gather<T>(world.slabs.absorption, here));
    if (world.slabs.bed_angles > 0) book_bed(photon, colliding);
    if constexpr (Events::tallies)
      if (world.tallies) TallyEvents<T>(world, tally).collide(photon, colliding);
    companions_of<Events>(world, t).before(photon);
    t.branch = transport::collide(world.slabs, photon, t.spectral_bin, world.forward.conversion,
                                  t.choices[0], t.choices[1]);
    transport::Photon<T>& after = t.photon;
    after.weight = select(colliding, photon.weight, after.weight);
    after.analog_weight = select(colliding, photon.analog_weight, after.analog_weight);
    after.line = select(colliding, photon.line, after.line);
    after.order = select(colliding, photon.order, after.order);
  }

  /// They go on in a direction about their own, or towards a target.
  template <class Each>
  void scatter(Each each) {
    if (world.forward.directs) each([&](auto& t) { aim_at_targets(world, t); });
    each([&](auto& t) { deflect(t); });
    each([&](auto& t) { turn(t); });
    if (world.forward.directs) each([&](auto& t) { weigh_direction(t); });
    if (world.slabs.bed_angles > 0) each([&](auto& t) { leave_bed(t); });
  }

  void play_roulette(ForwardTracks<T>& t) {
    if constexpr (Events::tools)
      t.on = end_with_tools(world, t, t.on, left_of_direction(t), ledger);
    else if (any(t.photon.analog_weight < world.forward.weight_threshold))
      t.on = estimator::play_roulette(t.photon, world.forward.weight_threshold,
                                      left_of_direction(t), t.on, ledger);
  }
  [[nodiscard]] static const Index<T>& event_of(const ForwardTracks<T>& t) { return t.place.event; }

 private:
  [[nodiscard]] bool flies_on() const { return !Events::tools && world.forward.flies_on; }

  /// Books the weight that the bed absorbs.
  void book_bed(const transport::Photon<T>& photon, const Mask<T>& colliding) {
    const T albedo =
        surface::bed_albedo(world.slabs, photon.line, photon.layer, T(-photon.direction.z));
    book(ledger.sea_bed, colliding & surface::on_bed<T>(world.slabs, photon.layer),
         photon.weight * (T(1) - albedo));
  }

  /// Reflects photons of a mask at the surface, but for the weight that passes. Photons left with
  /// far less than the threshold play roulette at once, before more is done for little light; the
  /// others use the rest of the number that it is played by. Returns which go on.
  Mask<T> reflect_in_flight(ForwardTracks<T>& t, const Mask<T>& reflected,
                            transport::Photon<T>& photon) {
    book(ledger.escaped, reflected, transport::reflect_down(world.slabs, photon).into_air);
    constexpr double far_less = 1.0 / 8;
    const Mask<T> light = photon.analog_weight < T(far_less) * world.forward.weight_threshold;
    if (!any(reflected & light)) return reflected;
    const T level = select(reflected & light, world.forward.weight_threshold, T(0));
    T& u = t.u[3];
    const T chance = transport::survival(photon, level);
    const Mask<T> survives = estimator::play_roulette(photon, level, u, reflected, ledger);
    u = left_of_choice(u, chance);
    return survives;
  }

  void deflect(ForwardTracks<T>& t) {
    if (!any(t.colliding)) return;
    t.deflection = transport::deflect(
        world.slabs, t.photon.layer, t.photon.direction, t.branch.phase, t.branch.lobe, t.targets,
        world.forward.directed, {t.u[1], t.u[2], t.u[3], t.choices[2]});
  }
  void turn(ForwardTracks<T>& t) {
    const Mask<T>& colliding = t.colliding;
    if (!any(colliding)) return;
    transport::Photon<T>& photon = t.photon;
    if (world.forward.directs) t.old_direction = photon.direction;
    photon.direction = select<T>(colliding, transport::turned(t.deflection), photon.direction);
    companions_of<Events>(world, t).collided(photon, colliding);
  }
  /// The weight takes the ratio of the true density of directions to that with targets.
  void weigh_direction(ForwardTracks<T>& t) {
    if (!any(t.colliding)) return;
    const T ratio = transport::true_over_drawn(world.slabs, t.photon.layer, t.old_direction,
                                               t.photon.direction, t.branch.phase, t.branch.lobe,
                                               t.targets, world.forward.directed);
    t.photon.weight = t.photon.weight * select(t.colliding, ratio, T(1));
  }
  /// Ends the photons that were sent towards a target below it: no light goes there.
  void leave_bed(ForwardTracks<T>& t) {
    transport::leave_ground(world.slabs, t.photon);
    t.on = t.on & !(t.colliding & (t.photon.weight == T(0)));
    t.touched = select(t.colliding,
                       transport::touched_at<T>(world.slabs, t.photon.layer, t.touched), t.touched);
    t.photon.layer =
        select(t.colliding, world.slabs.template layer_of<T>(t.photon.layer), t.photon.layer);
  }
  /// The rest of the number that decided whether directions were drawn towards targets.
  T left_of_direction(const ForwardTracks<T>& t) const {
    const T& u = t.u[3];
    if (!world.forward.directs) return u;
    return select(t.colliding, left_of_choice(u, t.targets.share(world.forward.directed)), u);
  }
};

}  // namespace photic::estimator
