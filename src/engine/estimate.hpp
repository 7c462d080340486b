// The local estimate: what every telescope is expected to detect of a collision.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "engine/world.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect_ray.hpp"
#include "transport/scatter.hpp"

namespace photic::engine {

/// Directed sampling aims at no more ways than this; telescopes beyond have to do with the light of
/// the others.
inline constexpr int target_capacity = 16;
template <class T>
using Targets = transport::Targets<T, target_capacity>;

/// Which point of each telescope's lens takes part in a local estimate of single rays.
template <class T>
struct LensChoice {
  const RandomPlace<T>& place;
  std::size_t pair;  ///< of the four uniforms of a block: 0 or 1

  [[nodiscard]] instrument::PlanePoint<T> point(std::size_t number,
                                                const instrument::Telescope<T>& telescope) const {
    const auto u = uniforms(RandomPlace<T>{place.seed, place.photon, 0},
                            4 + static_cast<std::uint32_t>(number));
    return lens_point(telescope, u[0], u[1]);
  }
};

/// Scores one line's light of a collision in all telescopes: weight before the collision x share of
/// the process x phase function x acceptance x exp(-optical depth back at the emitted wavelength)
/// (docs/theory.md, "The local estimate"). Adds the ways to the telescopes to `targets`, if given,
/// for directed sampling: those outside the field of view too, for light that first turns towards a
/// telescope and then enters its view is what a plain walk finds too rarely.
template <class T>
void score_line(const World<T>& world, const transport::Photon<T>& photon, const Index<T>& line,
                const T& share, const Index<T>& phase, const LensChoice<T>& choice,
                tally::BatchTally& tally, Targets<T>* targets) {
  const auto offer = [&](std::size_t telescope, const transport::Connection<T>& way) {
    if (targets != nullptr && way.in_front && targets->count < target_capacity)
      targets->add(way.direction, T(0), T(1));
    if (!(way.acceptance > T(0))) return;
    const T p =
        world.sea.phases.template value<T>(one_minus_cos(photon.direction, way.direction), phase);
    tally::Score score;
    score.telescope = telescope;
    score.line = line;
    score.order = photon.order + 1;
    score.depth = -photon.position.z;
    score.path = photon.path + way.path;
    score.value = photon.weight * share * p * way.acceptance * exp_minus(way.optical_depth);
    tally.score(score);
  };
  for (std::size_t t = 0; t < world.telescopes.size(); ++t) {
    const auto& telescope = world.telescopes[t];
    if (world.single_rays) {
      const auto lens = choice.point(t, telescope);
      for (const bool mirrored : {false, true}) {
        if (mirrored && !telescope.submerged) continue;
        offer(t, transport::connect_ray(world.sea, telescope, world.telescope_layer[t], photon,
                                        line, lens, mirrored));
      }
      continue;
    }
    if (!telescope.submerged) {
      offer(t, transport::connect_through_surface(world.sea, telescope, photon, line,
                                                  targets != nullptr));
      continue;
    }
    const auto& layer = world.telescope_layer[t];
    offer(t, transport::connect_in_water(world.sea, telescope, layer, photon, line, false));
    offer(t, transport::connect_in_water(world.sea, telescope, layer, photon, line, true));
  }
}

/// Adds the views of the telescopes as targets for light that has yet to be converted: converted
/// light leaves in all directions, so what counts is that the laser's light comes into view, at
/// whatever angle. The cones hold the whole of a view's parts, or light from the side could enter
/// it by a direction that is drawn too rarely.
template <class T>
void aim_at_views(const World<T>& world, const transport::Photon<T>& photon, Targets<T>& targets) {
  for (const auto& view : world.views) {
    for (const auto& ball : view.part) {
      const Vec3<T> there = ball.centre - photon.position;
      const T squared = dot(there, there);
      if (targets.count == target_capacity || squared == T(0)) return;
      const T sine_squared = ball.radius * ball.radius / squared;
      const T cone = sine_squared < T(1) ? T(1) - std::sqrt(T(1) - sine_squared) : T(1);
      targets.add((T(1) / std::sqrt(squared)) * there, cone, T(1.0 / view_parts));
    }
  }
}

/// Scores what the telescopes expect of a photon that is scattered where it stands. Fills in the
/// targets of the direction it may take next.
template <class T>
void score_scattering(const World<T>& world, const transport::Photon<T>& photon,
                      const RandomPlace<T>& place, tally::BatchTally& tally, Targets<T>& targets) {
  const medium::MediumView& sea = world.sea;
  const Index<T> here = sea.at(photon.line, photon.layer);
  targets.clear();
  score_line(world, photon, photon.line, T(sea.albedo[here]), sea.elastic_phase[here], {place, 0},
             tally, world.directed > T(0) ? &targets : nullptr);
  if (photon.line == 0 && world.directed > T(0)) aim_at_views(world, photon, targets);
}

/// Scores what the telescopes expect of the conversions on a photon's way to its next collision.
template <class T>
void score_conversions(const World<T>& world, transport::Photon<T> photon,
                       const RandomPlace<T>& place, tally::BatchTally& tally) {
  const medium::MediumView& sea = world.sea;
  const auto u = uniforms(place, 2);
  if (photon.line != 0 || !transport::force_collision(sea, photon, world.cones, {u[0], u[1], u[2]}))
    return;
  for (Index<T> i = 0; i < sea.convertible_count[photon.layer]; ++i) {
    const Index<T> line = sea.convertible[photon.layer * sea.lines + i];
    score_line<T>(world, photon, line, T(sea.conversion[sea.at(line, photon.layer)]),
                  sea.conversion_phase[line], {place, 1}, tally, nullptr);
  }
}

}  // namespace photic::engine
