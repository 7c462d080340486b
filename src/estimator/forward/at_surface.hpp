// The forward estimator's photons at the surface. What telescopes expect of light that meets facets
// is scored there: the surface's own echo, and light that goes from facet to facet. Light that
// comes there from the water for the first time has been scored at its collision.
#pragma once

#include "estimator/crossing.hpp"
#include "estimator/forward/estimate.hpp"
#include "estimator/forward/film.hpp"
#include "estimator/forward/passing.hpp"
#include "estimator/forward/tools.hpp"
#include "estimator/random_blocks.hpp"
#include "transport/connect_waves.hpp"

namespace photic::estimator {

/// Scores photons of a mask that are about to meet facets, by a way to a group of telescopes.
template <class Events, class T>
void score_from_surface(const World<T>& world, const ForwardTracks<T>& t, const ViewGroup<T>& group,
                        const transport::SurfaceConnection<T>& way, const Mask<T>& mask,
                        Estimates<T>& estimates, tally::BatchTally& tally) {
  const transport::Photon<T>& photon = t.photon;
  const Mask<T> seen = mask & (way.acceptance > T(0));
  if (!any(seen)) return;
  const Index<T> of_surface(static_cast<std::int32_t>(transport::Touched::surface));
  const Index<T> touched = select(photon.order == Index<T>(0), of_surface, t.touched);
  Index<T> telescope(static_cast<std::int32_t>(group.number));
  if (!group.narrower.empty()) telescope = group.narrowest(way.sight);
  const lanes::LaneScores<T> scores{telescope,
                                    group.path_to_origin,
                                    transport::component_of<T>(world.slabs, photon.line, touched),
                                    photon.order,
                                    T(0),
                                    photon.path + way.path,
                                    photon.weight * way.acceptance * exp_minus(way.optical_depth)};
  estimates.begin(t.ratios);
  const auto complete = [&](Completion<T>& completion) {
    if (world.slabs.surface.differs_in_environments)
      completion.surface.meet(world.slabs, way.meeting);
    if (group.region.outside)
      add_column(group.region, photon.line, way.direction.z, way.stretch, completion.ways);
    else
      completion.pass(world.slabs, way.in_water);
  };
  score<Events>(world, static_cast<std::size_t>(&group - world.instruments.groups.data()), seen,
                scores, complete, estimates, tally);
}
/// Before the given facet of an event.
template <class Events, class T>
PHOTIC_APART void score_at_surface(const World<T>& world, const ForwardTracks<T>& t,
                                   const Mask<T>& outside, const Mask<T>& mask, std::uint32_t facet,
                                   Estimates<T>& estimates, tally::BatchTally& tally) {
  const bool anywhere = world.slabs.surface.leads_anywhere;
  for (std::size_t g = 0; g < world.instruments.groups.size(); ++g) {
    const ViewGroup<T>& group = world.instruments.groups[g];
    const auto score = [&](const transport::SurfaceConnection<T>& way) {
      score_from_surface<Events>(world, t, group, way, mask, estimates, tally);
    };
    if (anywhere || world.slabs.waves.whitecap_fraction > 0)
      score(transport::connect_from_surface(world.slabs, group.widest, group.region, t.photon,
                                            outside, t.lens[g]));
    if (!anywhere)
      score(transport::connect_in_line(world.slabs, group.widest, group.region, t.photon, outside,
                                       uniforms(t.place, line_blocks[facet])[0]));
  }
}

/// The observer that scores the events of photons at the surface. `leave`: see pass_surface().
template <class Events, class T, class Ledger>
struct ScoredAtSurface {
  const World<T>& world;
  ForwardTracks<T>& t;
  Estimates<T>& estimates;
  tally::BatchTally& tally;
  Ledger& ledger;
  const Leave<T>& leave;
  std::uint32_t passings = 0;

  [[nodiscard]] Mask<T> emit(const Mask<T>& mask, const surface::AtFilm<T>& at, const T& met,
                             std::uint32_t number) {
    return emit_by_film<Events>(world, t, {mask, at, met}, number, passings++, leave, estimates,
                                tally, ledger);
  }
  void about_to_meet(const transport::AtWaves<T>& at, std::uint32_t facet) {
    tally.operations.facets += count(at.meets);
    Mask<T> scored = at.meets;
    const auto fresh = [&] { return t.photon.order == Index<T>(0); };
    if (facet == 0) scored = scored & fresh();
    if (world.slabs.kind == medium::MediumKind::air)
      scored = scored & !fresh();  // the surface's own echo is another
    if (world.part.scored != Scored::all) [[unlikely]] {
      const Mask<T> own = world.part.scored == Scored::film ? scored & fresh() : Mask<T>(false);
      scored = own | who_are_scored(world, t, scored);
    }
    if (any(scored))
      score_at_surface<Events>(world, t, at.outside, scored, facet, estimates, tally);
  }
  void met(const Mask<T>& meets, const surface::FacetHit<T>& meeting) {
    companions_of<Events>(world, t).met(meeting, meets);
  }
  void crossed(std::int32_t way, const T& cosine, const Mask<T>& crosses) {
    companions_of<Events>(world, t).crossed(t.photon.line, way, cosine, crosses);
  }
  void reflected(const Mask<T>&, const Vec3<T>&, const T&) {}
  void into_film(const Mask<T>&, const T&) {}
  /// `by`: what the light that passes has met, which the rest has not.
  template <class By>
  void passes(const Mask<T>& mask, const Vec3<T>& direction, const T& weight, By by) {
    const std::uint32_t passing = passings++;
    if (!world.part.beyond.exists) return;
    const auto companions = companions_of<Events>(world, t);
    companions.apart(
        mask, [&] { companions.passed(by(), mask); },
        [&] { pass_surface(world, t, mask, direction, weight, passing, leave); });
  }
};

/// Has photons of a mask that stand at the surface cross it or go back.
template <class Events, class T, class Ledger>
void cross_surface(const World<T>& world, ForwardTracks<T>& t, const Mask<T>& stand,
                   bool from_outside, Estimates<T>& estimates, tally::BatchTally& tally,
                   Ledger& ledger, const Leave<T>& leave) {
  if (!any(stand)) return;
  SplitsWeight<T, Ledger> rule{{world, t.place, ledger}, Mask<T>(false)};
  if constexpr (Events::tools) rule.lossless = are_forced(world.forward.tools, t.place);
  ScoredAtSurface<Events, T, Ledger> observer{world, t, estimates, tally, ledger, leave};
  estimator::cross_surface(world, t, stand, from_outside, rule, observer);
}

}  // namespace photic::estimator
