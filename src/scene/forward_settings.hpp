// The sampling of the forward estimator where a scene does not set it: the values of a scene that
// names neither key, and those that "auto" chooses from.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace photic::scene {

/// Values of [simulation]: directed_fraction and scored_points.
struct ForwardSettings {
  double directed_fraction{};
  std::int64_t scored_points{};
  friend bool operator==(const ForwardSettings&, const ForwardSettings&) = default;
};

/// The settings worth a try, each with what the scene names; at least one. Beside a telescope in
/// the water few directions to it and few points miss light that comes from nearby.
std::vector<ForwardSettings> forward_settings(const Scene& scene);

/// The fraction of a scene of the forward estimator, by the height of its telescopes above the sea
/// (docs/decisions/0038).
double directed_fraction_in(const Scene& scene);
std::int64_t scored_points_in(const Scene& scene);

}  // namespace photic::scene
