// The settings of forward histories.
#pragma once

#include <cstdint>
#include <vector>

#include "core/pack.hpp"
#include "estimator/view.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// Directed sampling aims at no more ways than this; telescopes beyond have to do with the light of
/// the others.
inline constexpr int target_capacity = 16;

/// The forward estimator's tools beyond the plain walk.
template <class T>
struct Tools {
  Index<T> forced_flights{};
  bool scores_on_the_way = false;  ///< collisions, at points chosen in views, not where they happen
  scene::AtThreshold at_threshold = scene::AtThreshold::roulette;
  std::vector<T> importance_depth, importance;
};

/// The choices of histories of the forward estimator, by itself or beside walks.
template <class T>
struct ForwardSettings {
  std::vector<View<T>> views;      ///< of each group; none if nothing is converted
  std::vector<ViewCone<T>> cones;  ///< to choose points in that are scored
  T directed{};                    ///< share of directions drawn towards a telescope
  bool directs = false;            ///< true if any are
  /// Of light to the levels of a radiance, towards which directions are drawn as towards a
  /// telescope; none beside telescopes.
  std::vector<Vec3<T>> radiance_directions;
  T conversion{};              ///< probability of a branch into the inelastic processes
  bool single_rays = false;    ///< local estimates take one point of the lens instead of its mean
  bool makes_choices = false;  ///< true if collisions choose between lines or targets at all
  T weight_threshold{};
  std::int32_t scored_points = 1;  ///< of each flight; 1: where photons collide only
  Tools<T> tools;
  /// Past the surface in one flight: where each part of it is scored alike, and where photons that
  /// are sent there come there so often that it is worth the while.
  bool flies_on = false;
};

}  // namespace photic::estimator
