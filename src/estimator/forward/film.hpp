// The light that a film of oil emits: telescopes score it whenever light of the laser's line comes
// to the film, and some photons go on as light that it sends down into the water.
#pragma once

#include <cstdint>

#include "estimator/book.hpp"
#include "estimator/forward/companions.hpp"
#include "estimator/forward/estimate.hpp"
#include "estimator/forward/passing.hpp"
#include "estimator/random_blocks.hpp"
#include "surface/oil.hpp"
#include "transport/connect_waves.hpp"

namespace photic::estimator {

/// The chance that a photon goes on as light that the film emits downwards. Such photons add a few
/// per cent to an echo of the film, but all of the film's light in deeper gates.
inline constexpr double film_conversion = 0.1;

/// Photons of a mask that come to a film; `met`: how often such a film is met over how often it is
/// drawn.
template <class T>
struct ComeToFilm {
  Mask<T> mask{};
  surface::AtFilm<T> at;
  T met{1};
};

/// Scores, in a group of telescopes, what the film emits in a line.
template <class Events, class T>
void score_film(const World<T>& world, const ForwardTracks<T>& t, std::size_t g,
                const Index<T>& line, const ComeToFilm<T>& film, Estimates<T>& estimates,
                tally::BatchTally& tally) {
  const ViewGroup<T>& group = world.instruments.groups[g];
  const transport::Photon<T>& photon = t.photon;
  const auto way = transport::from_surface(group.widest, t.lens[g], photon.position);
  const Mask<T> seen = film.mask & way.seen;
  if (!any(seen)) return;
  const T emitted =
      surface::emitted_by_film(world.slabs, film.at, line, way.direction, group.region.outside);
  Sources<T> from{photon, line, t.touched, t.lens[g], t.surface, sources_differ(world)};
  const T value = photon.weight * film.met * emitted * group.widest.area() *
                  way.sight.cos_off_axis / (way.length * way.length) *
                  exp_minus(transport::depth_to_lens(world.slabs, group.region, line, way));
  Index<T> telescope(static_cast<std::int32_t>(group.number));
  if (!group.narrower.empty()) telescope = group.narrowest(way.sight);
  const auto scores =
      scores_of(world, group, telescope, from,
                transport::path_to_telescope(world.slabs, group.widest, group.region, line,
                                             t.lens[g], photon.position, way),
                value);
  estimates.begin(t.ratios);
  const auto complete = [&](Completion<T>& completion) {
    completion.emission.emit(world.slabs, film.at, line, way.direction, group.region.outside);
    if (world.slabs.surface.differs_in_environments)
      completion.surface.meet(world.slabs,
                              surface::meeting_by_emission(world.slabs.waves, film.at.normal));
    if (group.region.outside)
      add_column(group.region, line, way.rising_cosine(), group.region.stretch(way.height()),
                 completion.ways);
    else
      completion.pass(world.slabs,
                      transport::from_surface_in_water(world.slabs, group.region, line, way));
  };
  score<Events>(world, g, seen, scores, complete, estimates, tally);
}

/// Weight that leaves the film of what it emits into one half of all directions: by one of them, an
/// even one as Lambert's law has it.
template <class T>
T emitted_weight(const geometry::Slabs& sea, const transport::Photon<T>& photon,
                 const Index<T>& line, const ComeToFilm<T>& film, const Vec3<T>& direction,
                 bool up) {
  const T lambert = T(1 / pi) * (up ? direction.z : T(0) - direction.z);
  return photon.weight * film.met * surface::emitted_by_film(sea, film.at, line, direction, up) /
         lambert;
}

/// Has the light that a film emits outwards go on in the other medium. `passing`: of the event.
template <class Events, class T>
void pass_emitted(const World<T>& world, const ForwardTracks<T>& t, const ComeToFilm<T>& lit,
                  const Index<T>& line, const Vec3<T>& up, const T& weight, std::uint32_t passing,
                  const Leave<T>& leave) {
  ForwardTracks<T> emitted = t;
  emitted.photon.line = line;
  emitted.photon.order = t.photon.order + Index<T>(1);
  Mask<T> goes_on = lit.mask & (weight > T(0));
  if (world.part.last_order > 0)
    goes_on = goes_on & (emitted.photon.order < Index<T>(world.part.last_order));
  const auto companions = companions_of<Events>(world, emitted);
  companions.apart(
      goes_on, [&] { companions.emitted(lit.at, line, up, true, goes_on); },
      [&] { pass_surface(world, emitted, goes_on, up, weight, passing, leave); });
}

/// Scores the emitted light, has it go on in the other medium, and sends photons down into the
/// medium as such light, by chance. Returns which; the weight of the others makes up for them. In
/// the air, what the laser's light excites straight is left to the histories in the water, where it
/// comes from outside. `passing`: of the event.
template <class Events, class T, class Ledger>
PHOTIC_APART Mask<T> emit_by_film(const World<T>& world, ForwardTracks<T>& t,
                                  const ComeToFilm<T>& film, std::uint32_t number,
                                  std::uint32_t passing, const Leave<T>& leave,
                                  Estimates<T>& estimates, tally::BatchTally& tally,
                                  Ledger& ledger) {
  ComeToFilm<T> lit = film;
  lit.mask = film.mask & (t.photon.line == Index<T>(0));
  if (world.slabs.kind == medium::MediumKind::air)
    lit.mask = lit.mask & (t.photon.order > Index<T>(0));
  if (!any(lit.mask)) return lit.mask;
  const Index<T> line = surface::film_line<T>(world.slabs, t.spectral_bin);
  for (std::size_t g = 0; g < world.instruments.groups.size() && world.part.scored != Scored::none;
       ++g)
    score_film<Events>(world, t, g, line, lit, estimates, tally);

  const auto u = uniforms(t.place, film_blocks[number]);
  const auto [cosine, sine] = cos_sin_of_turns(u[1]);
  const Vec3<T> up =
      turned(Vec3<T>{T(0), T(0), T(1)}, surface::lambert_one_minus_cos(u[2]), cosine, sine);
  const Vec3<T> down{up.x, up.y, T(0) - up.z};
  transport::Photon<T>& photon = t.photon;
  const T rises = emitted_weight(world.slabs, photon, line, lit, up, true);
  book(ledger.escaped, lit.mask, rises);
  book(ledger.oil, lit.mask, T(0) - rises);
  if (world.part.beyond.exists)
    pass_emitted<Events>(world, t, lit, line, up, rises, passing, leave);

  const T sinks =
      emitted_weight(world.slabs, photon, line, lit, down, false) * T(1 / film_conversion);
  const Mask<T> converted = lit.mask & (u[0] < T(film_conversion));
  companions_of<Events>(world, t).emitted(lit.at, line, down, false, converted);
  book(ledger.oil, converted, T(0) - sinks);
  photon.weight = photon.weight * select(lit.mask, T(1 / (1 - film_conversion)), T(1));
  photon.weight = select(converted, sinks, photon.weight);
  photon.line = select(converted, line, photon.line);
  photon.direction = select(converted, down, photon.direction);
  photon.order = photon.order + select(converted, Index<T>(1), Index<T>(0));
  t.on = t.on & ((!converted) | (sinks > T(0)));
  if (world.part.last_order > 0)
    book_out(t, converted & (photon.order == Index<T>(world.part.last_order)), ledger.cut_by_order);
  return converted;
}

}  // namespace photic::estimator
