// How the forward estimator samples where a scene does not say: what a scene gets that names
// neither key, what "auto" chooses from.
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

/// Those worth a try, each with what the scene names; at least one. Beside a telescope in the water
/// few directions to it and few points miss light that comes from nearby.
std::vector<ForwardSettings> forward_settings(const Scene& scene);

/// What a scene of the forward estimator gets: by how high above the sea its telescopes are
/// (docs/decisions/0038).
double directed_fraction_in(const Scene& scene);
std::int64_t scored_points_in(const Scene& scene);

}  // namespace photic::scene
