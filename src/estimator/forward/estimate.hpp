// The local estimate: what every telescope is expected to detect of a collision.
#pragma once

#include <array>
#include <vector>

#include "estimator/contribution.hpp"
#include "estimator/forward/forward_tracks.hpp"
#include "estimator/variations/environments.hpp"
#include "estimator/variations/ratios.hpp"
#include "estimator/world.hpp"
#include "lanes/each_score.hpp"
#include "lanes/queue.hpp"
#include "surface/oil.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect_ray.hpp"
#include "transport/connect_waves.hpp"
#include "transport/scatter.hpp"
#include "transport/touched.hpp"

namespace photic::estimator {

/// The properties in which sources of a scene's scores differ at all.
struct SourcesDiffer {
  bool lines = true, layers = true, points = true, touched = true, surface = true;

  /// Calls f(member) for what does of a source's photon, its weight, line, what it has touched, its
  /// point of the lens, and the numbers of a point of a rough surface.
  template <class Photon, class T, class Number, class Point, class Uniforms, class F>
  constexpr void each(Photon& photon, T& weight, Number& line, Number& touched, Point& lens,
                      Uniforms& u, F f) const {
    f(photon.position.x), f(photon.position.y), f(photon.position.z);
    f(photon.direction.x), f(photon.direction.y), f(photon.direction.z);
    f(weight), f(photon.path), f(photon.order);
    if (points) f(lens.x), f(lens.y);
    if (surface) f(u[0]), f(u[1]), f(u[2]);
    if (layers) f(photon.layer);
    if (lines) f(photon.line), f(line);
    if (this->touched) f(touched);
  }
};
template <class T>
SourcesDiffer sources_differ(const World<T>& world) {
  return {world.slabs.lines > 1, world.slabs.places > 1, world.forward.single_rays,
          world.slabs.bed_angles > 0 || world.slabs.kind == medium::MediumKind::air,
          !world.slabs.surface.one_direction_each};
}

/// Light of one line that leaves collisions, one in each lane: scattered, or converted from another
/// line.
template <class T>
struct Sources {
  transport::Photon<T> photon{};  ///< before the collision
  Index<T> line{}, touched{};
  instrument::PlanePoint<T> lens{};
  std::array<T, 4> surface{};
  SourcesDiffer differ;

  template <class F>
  constexpr void each_member(F f) {
    differ.each(photon, photon.weight, line, touched, lens, surface, f);
  }
};
/// The same, where it stands.
template <class T>
struct SourcesOf {
  const transport::Photon<T>& photon;
  const T weight;
  const Index<T>& line;
  const Index<T> touched;
  const instrument::PlanePoint<T>& lens;
  const std::array<T, 4>& surface;
  SourcesDiffer differ;

  template <class F>
  constexpr void each_member(F f) const {
    differ.each(photon, weight, line, touched, lens, surface, f);
  }
  explicit operator Sources<T>() const {
    Sources<T> out{photon, line, touched, lens, surface, differ};
    out.photon.weight = weight;
    return out;
  }
};

/// The part of a process in a collision: its share, and its phase function.
template <class T>
struct Emission {
  T share;
  Index<T> phase;
};
template <class T>
Emission<T> emission(const medium::MediumView& sea, const Sources<T>& from) {
  const Index<T> here = sea.at(from.line, from.photon.layer);
  const Emission<T> scattered{
      transport::scattered_share(sea, from.line, from.photon.layer, T(-from.photon.direction.z)),
      gather_index<T>(sea.elastic_phase, here)};
  if (!from.differ.lines) return scattered;
  const Mask<T> same = from.line == from.photon.line;
  return {select(same, scattered.share, gather<T>(sea.conversion, here)),
          select(same, scattered.phase, gather_index<T>(sea.conversion_phase, from.line))};
}

/// The needs of local estimates besides the photons: a pool's, or one photon's.
template <class T>
struct Estimates {
  explicit Estimates(const World<T>& world)
      : waiting(world.instruments.groups.size(),
                lanes::Queue<T, Sources<T>>({.differ = sources_differ(world)})),
        ratios(static_cast<std::size_t>(world.slabs.environments.stride)) {
    for (const ViewGroup<T>& group : world.instruments.groups)
      scores.emplace_back(group.number, group.path_to_origin, !group.narrower.empty());
  }

  std::vector<lanes::Queue<T, Sources<T>>> waiting;  ///< of each group of telescopes
  std::vector<lanes::ScoreQueue<T>> scores;          ///< in each group

  // Ratios of the light that is scored, in environments.
  const PathRatios<T>* paths = nullptr;
  std::size_t first = 0;  ///< path of the first lane
  Terms<T> unflown;       ///< of ways that the photons have not gone, but the light has
  Completion<T> completion;

  /// The light is that of such photons, and has gone where they have.
  void begin(const Ratios<T>& photons) {
    paths = photons.paths;
    first = photons.first;
    unflown.clear();
  }
  std::vector<Element<T>> ratios;  ///< of one lane, [environment]
};

/// Scores in telescopes of a group of light that leaves collisions.
template <class T>
lanes::LaneScores<T> scores_of(const World<T>& world, const ViewGroup<T>& group,
                               const Index<T>& telescope, const Sources<T>& from,
                               const T& path_back, const T& value) {
  return {telescope,
          group.path_to_origin,
          transport::component_of<T>(world.slabs, from.line, from.touched),
          from.photon.order + Index<T>(1),
          transport::signed_depth(world.slabs, geometry::depth_of(from.photon.position)),
          from.photon.path + path_back,
          value};
}

/// Scores the lanes of a mask in environments, too, by the completion of their paths.
template <class T>
void score_completed(const World<T>& world, const Mask<T>& seen, const lanes::LaneScores<T>& scores,
                     Estimates<T>& estimates, tally::BatchTally& tally) {
  const geometry::Slabs& sea = world.slabs;
  const auto& completion = estimates.completion;
  lanes::each_score(
      tally, seen, scores, [&](std::size_t lane, const tally::Score& score, const auto& at) {
        const std::size_t path = estimates.first + lane;
        tally.not_finite += complete<T>(
            sea, completion, lane, [&](std::int32_t e) { return estimates.paths->at(path, e); },
            estimates.ratios.data());
        tally.score(score, at, estimates.ratios.data());
      });
}
/// Scores light in telescopes of a group. complete(completion) completes its paths in environments.
template <class Events, class T, class Complete>
void score(const World<T>& world, std::size_t group, const Mask<T>& seen,
           const lanes::LaneScores<T>& scores, Complete complete, Estimates<T>& estimates,
           tally::BatchTally& tally) {
  if (!has_environments<Events>(world)) return estimates.scores[group].push(seen, scores, tally);
  estimates.completion.clear();
  complete(estimates.completion);
  score_completed(world, seen, scores, estimates, tally);
}

/// The ways that complete paths of light from where it stands to a group of telescopes.
template <class T>
void complete_ways(const World<T>& world, const ViewGroup<T>& group, const Sources<T>& from,
                   const transport::Connection<T>& way, Completion<T>& completion) {
  completion.pass_flat(world.slabs, way.in_water, way.direction);
  add_column_by_flat_surface(world.slabs, group.region, from.line, way.direction,
                             group.region.stretch(in_space(group.widest, from.lens).z),
                             completion.ways);
}
/// The same by a rough surface.
template <class T>
void complete_ways(const World<T>& world, const ViewGroup<T>& group, const Sources<T>& from,
                   const transport::WavesConnection<T>& way, Completion<T>& completion) {
  completion.pass(world.slabs, way.in_water);
  if (group.region.outside)
    add_column(group.region, from.line, way.onward.rising_cosine(),
               group.region.stretch(way.onward.height()), completion.ways);
  else
    completion.pass(world.slabs, transport::from_surface_in_water(world.slabs, group.region,
                                                                  from.line, way.onward));
}
/// The effect on paths in environments of waves that lead them on.
template <class T>
void complete_surface(const World<T>&, const transport::Connection<T>&, Completion<T>&) {}
template <class T>
void complete_surface(const World<T>& world, const transport::WavesConnection<T>& way,
                      Completion<T>& completion) {
  if (world.slabs.surface.differs_in_environments)
    completion.surface.meet(world.slabs, way.meeting);
}
/// Completes paths of light that leaves a collision and goes to telescopes of a group. The
/// arguments are copies, whose originals stay in registers.
template <class T, class Way>
PHOTIC_APART PHOTIC_FLATTEN void complete_from_collision(const World<T>& world,
                                                         const ViewGroup<T>& group, Sources<T> from,
                                                         Way way, const Terms<T>& unflown,
                                                         Completion<T>& completion) {
  const transport::Photon<T>& photon = from.photon;
  completion.ways = unflown;
  complete_ways(world, group, from, way, completion);
  complete_surface(world, way, completion);
  completion.collide(world.slabs,
                     {photon.line, photon.layer, Mask<T>(!(from.line == photon.line)), from.line,
                      one_minus_cos(photon.direction, way.direction), T(-photon.direction.z)});
}

/// Scores light in the telescopes of a group: weight before the collision x share of the process x
/// phase function x acceptance x exp(-optical depth back at the emitted wavelength)
/// (docs/theory.md, "The local estimate").
template <class Events, class T>
void score_in(const World<T>& world, std::size_t g, const Sources<T>& from, const Mask<T>& mask,
              tally::BatchTally& tally, Estimates<T>& estimates) {
  using namespace transport;
  tally.operations.local_estimates += count(mask);
  const Photon<T>& photon = from.photon;
  const auto [share, phase] = emission(world.slabs, from);
  const ViewGroup<T>& group = world.instruments.groups[g];
  const auto score_by = [&](const auto& way, const instrument::Sight<T>& sight) {
    const Mask<T> seen = mask & (way.acceptance > T(0));
    if (!any(seen)) return;
    const T of_vertex = contribution(
        world.slabs, Interaction<T>{photon.layer, phase, photon.direction}, way.direction);
    const T value =
        photon.weight * share * of_vertex * way.acceptance * exp_minus(way.optical_depth);
    Index<T> telescope(static_cast<std::int32_t>(group.number));
    if (!group.narrower.empty()) telescope = group.narrowest(sight);
    estimator::score<Events>(
        world, g, seen, scores_of(world, group, telescope, from, way.path, value),
        [&](Completion<T>& completion) {
          complete_from_collision(world, group, from, way, estimates.unflown, completion);
        },
        estimates, tally);
  };
  const auto& telescope = group.widest;
  const auto& region = group.region;
  for (const auto route : geometry::routes_to(region.outside)) {
    if (by_waves(world.slabs, region, route)) {
      const auto& u = from.surface;
      const auto way = connect_by_waves(world.slabs, telescope, region, photon, from.line,
                                        from.lens, {u[0], u[1], u[2]}, mask);
      score_by(way, way.sight);
    } else if (world.forward.single_rays) {
      const auto way =
          connect_ray(world.slabs, telescope, region, photon, from.line, from.lens, route, mask);
      score_by(static_cast<const Connection<T>&>(way), way.sight);
    } else {
      score_by(connect(world.slabs, telescope, region, photon, from.line, route, mask), {});
    }
  }
}

/// Scores light that has waited for company.
template <class T>
PHOTIC_APART PHOTIC_FLATTEN void score_waiting(const World<T>& world, std::size_t g,
                                               const Sources<T>& from, const Mask<T>& mask,
                                               tally::BatchTally& tally, Estimates<T>& estimates) {
  score_in<PlainEvents>(world, g, from, mask, tally, estimates);
}

/// Scores light of a line, and so much of photons' weight, from the collisions of a mask of
/// tracks, in all telescopes that may see it; it waits for company, but for light that has
/// ratios.
template <class Events, class T>
void score_light(const World<T>& world, const ForwardTracks<T>& of,
                 const transport::Photon<T>& photon, const T& weight, const Mask<T>& colliding,
                 const Index<T>& line, Estimates<T>& estimates, tally::BatchTally& tally) {
  const instrument::PlanePoint<T> centre{};
  const auto& lens = of.lens;
  Index<T> touched(0);
  if (world.slabs.bed_angles > 0)
    touched = transport::touched_at<T>(world.slabs, photon.layer, of.touched);
  else if (world.slabs.kind == medium::MediumKind::air)
    touched = of.touched;
  for (std::size_t g = 0; g < world.instruments.groups.size(); ++g) {
    const Mask<T> seen = colliding & may_be_seen(world, g, photon.position, line, lens);
    if (!any(seen)) continue;
    const SourcesOf<T> from{photon,
                            weight,
                            line,
                            touched,
                            world.forward.single_rays ? lens[g] : centre,
                            of.surface,
                            sources_differ(world)};
    if (has_environments<Events>(world)) {
      score_in<Events>(world, g, Sources<T>(from), seen, tally, estimates);
      continue;
    }
    estimates.waiting[g].push(seen, from, [&](const Sources<T>& full, const Mask<T>& mask) {
      score_waiting(world, g, full, mask, tally, estimates);
    });
  }
}

/// Scores what still waits.
template <class T>
void flush_queues(const World<T>& world, Estimates<T>& estimates, tally::BatchTally& tally) {
  for (std::size_t g = 0; g < estimates.waiting.size(); ++g) {
    estimates.waiting[g].flush([&](const Sources<T>& rest, const Mask<T>& mask) {
      score_waiting(world, g, rest, mask, tally, estimates);
    });
    estimates.scores[g].flush(tally);
  }
}

/// The part of a photon's weight that collides at one of the points of a flight that are scored.
template <class T>
T weight_at_point(const ForwardSettings<T>& forward, const transport::Photon<T>& photon) {
  return photon.weight * T(1.0 / forward.scored_points);
}

/// The photons of a mask whose light a world's histories score.
template <class T>
Mask<T> who_are_scored(const World<T>& world, const ForwardTracks<T>& t, const Mask<T>& mask) {
  switch (world.part.scored) {
    [[likely]] case Scored::all:
      return mask;
    case Scored::film:
      return mask & surface::is_film_light<T>(world.slabs, t.photon.line);
    case Scored::from_water: {
      const Index<T> air(static_cast<std::int32_t>(transport::Touched::air));
      Mask<T> scored = !(t.touched == air);
      if (world.slabs.surface.emits)
        scored = scored | surface::is_film_light<T>(world.slabs, t.photon.line);
      return mask & scored;
    }
    case Scored::none:
      break;
  }
  return Mask<T>(false);
}

/// Scores what the telescopes expect of photons of a mask that are scattered where they stand.
template <class Events, class T>
void score_scattering(const World<T>& world, const ForwardTracks<T>& at, const Mask<T>& scored,
                      Estimates<T>& estimates, tally::BatchTally& tally) {
  if constexpr (Events::variations) estimates.begin(at.ratios);
  score_light<Events>(world, at, at.photon, weight_at_point(world.forward, at.photon), scored,
                      at.photon.line, estimates, tally);
}

}  // namespace photic::estimator
