// The local estimate: what every telescope is expected to detect of a collision.
#pragma once

#include <cmath>

#include "engine/world.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect.hpp"
#include "transport/scatter.hpp"

namespace photic::engine {

/// Directed sampling aims at no more ways than this; telescopes beyond have to do with the light of the others.
inline constexpr int target_capacity = 16;
template <class T>
using Targets = transport::Targets<T, target_capacity>;

/// Scores one line's light of a collision in all telescopes: weight before the collision x share of the process
/// x phase function x acceptance x exp(-optical depth back at the emitted wavelength) (docs/theory.md, "The local
/// estimate"). Adds the ways to the telescopes to `targets`, if given, for directed sampling: those outside the
/// field of view too, for light that first turns towards a telescope and then enters its view is what a plain
/// walk finds too rarely.
template <class T>
void score_line(const World<T>& world, const transport::Photon<T>& photon, const Index<T>& line, const T& share,
                      const Index<T>& phase, tally::BatchTally& tally, Targets<T>* targets) {
  const auto offer = [&](std::size_t telescope, const transport::Connection<T>& way) {
    if (targets != nullptr && way.in_front && targets->count < target_capacity) targets->add(way.direction, true);
    if (!(way.acceptance > T(0))) return;
    const T p = world.sea.phases.template value<T>(one_minus_cos(photon.direction, way.direction), phase);
    tally::Score score;
    score.telescope = telescope;
    score.line = line;
    score.order = photon.order + 1;
    score.depth = -photon.position.z;
    score.path = photon.path + way.path;
    score.value = photon.weight * share * p * way.acceptance * std::exp(-way.optical_depth);
    tally.score(score);
  };
  for (std::size_t t = 0; t < world.telescopes.size(); ++t) {
    const auto& telescope = world.telescopes[t];
    if (!telescope.submerged) {
      offer(t, transport::connect_through_surface(world.sea, telescope, photon, line, targets != nullptr));
      continue;
    }
    const auto& layer = world.telescope_layer[t];
    offer(t, transport::connect_in_water(world.sea, telescope, layer, photon, line, false));
    offer(t, transport::connect_in_water(world.sea, telescope, layer, photon, line, true));
  }
}

/// Scores what the telescopes expect of a photon that collides where it stands, by every process that can turn its
/// light; the targets are the ways at the photon's own line, and serve a converted photon as well.
template <class T>
void score_collision(const World<T>& world, const transport::Photon<T>& photon, tally::BatchTally& tally,
                     Targets<T>& targets) {
  const medium::MediumView& sea = world.sea;
  const Index<T> here = sea.at(photon.line, photon.layer);
  targets.clear();
  score_line(world, photon, photon.line, T(sea.albedo[here]), sea.elastic_phase[here], tally,
             world.directed > T(0) ? &targets : nullptr);
  if (photon.line != 0) return;
  for (Index<T> i = 0; i < sea.convertible_count[photon.layer]; ++i) {
    const Index<T> line = sea.convertible[photon.layer * sea.lines + i];
    score_line<T>(world, photon, line, T(sea.conversion[sea.at(line, photon.layer)]), sea.conversion_phase[line], tally,
                  nullptr);
  }
}

}  // namespace photic::engine
