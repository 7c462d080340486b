// The local estimate: what every telescope is expected to detect of a collision.
#pragma once

#include <cmath>

#include "engine/world.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect.hpp"
#include "transport/scatter.hpp"

namespace photic::engine {

/// More telescopes than this share the directed light of the first ones.
inline constexpr int target_capacity = 16;
template <class T>
using Targets = transport::Targets<T, target_capacity>;

/// Calls visit(telescope, connection) for every way from a photon's position to a telescope that its detector
/// sees, at the given line.
template <class T, class Visit>
void for_each_way(const World<T>& world, const transport::Photon<T>& photon, const Index<T>& line, Visit&& visit) {
  for (std::size_t t = 0; t < world.telescopes.size(); ++t) {
    const auto& telescope = world.telescopes[t];
    const auto offer = [&](const transport::Connection<T>& way) {
      if (way.acceptance > T(0)) visit(t, way);
    };
    if (!telescope.submerged) {
      offer(transport::connect_through_surface(world.sea, telescope, photon, line));
      continue;
    }
    for (const bool mirrored : {false, true}) {
      offer(transport::connect_in_water(world.sea, telescope, world.telescope_layer[t], photon, line, mirrored));
    }
  }
}

/// Scores what the telescopes expect of a photon that collides where it stands, by every process that can turn its
/// light (docs/theory.md, "The local estimate"): weight before the collision x share of the process x
/// phase function x acceptance x exp(-optical depth back at the emitted wavelength).
template <class T>
void score_collision(const World<T>& world, const transport::Photon<T>& photon, tally::BatchTally& tally) {
  using std::exp;
  const medium::MediumView& sea = world.sea;
  const Index<T> here = sea.at(photon.line, photon.layer);
  const auto score_line = [&](const Index<T>& line, const T& share, const Index<T>& phase) {
    for_each_way(world, photon, line, [&](std::size_t telescope, const transport::Connection<T>& way) {
      const T p = sea.phases.value<T>(one_minus_cos(photon.direction, way.direction), phase);
      tally::Score score;
      score.telescope = telescope;
      score.line = line;
      score.order = photon.order + 1;
      score.depth = -photon.position.z;
      score.path = photon.path + way.path;
      score.value = photon.weight * share * p * way.acceptance * exp(-way.optical_depth);
      tally.score(score);
    });
  };
  score_line(photon.line, T(sea.albedo[here]), sea.elastic_phase[here]);
  if (photon.line != 0) return;
  for (Index<T> i = 0; i < sea.convertible_count[photon.layer]; ++i) {
    const Index<T> line = sea.convertible[photon.layer * sea.lines + i];
    score_line(line, T(sea.conversion[sea.at(line, photon.layer)]), sea.conversion_phase[line]);
  }
}

/// Ways to the telescopes as targets of the directed sampling.
template <class T>
Targets<T> telescopes_in_sight(const World<T>& world, const transport::Photon<T>& photon) {
  Targets<T> targets;
  if (world.directed == T(0)) return targets;
  for_each_way(world, photon, photon.line, [&](std::size_t, const transport::Connection<T>& way) {
    if (targets.count < target_capacity) targets.add(way.direction, true);
  });
  return targets;
}

}  // namespace photic::engine
