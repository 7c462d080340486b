// The ways in which the bidirectional estimator draws paths: those that a scene leaves out, and
// why. Each that needs a symmetry of the scene is checked here.
#pragma once

#include <string>
#include <vector>

#include "medium/medium.hpp"
#include "scene/scene.hpp"

namespace photic::estimator {

/// A way to draw paths.
struct Strategy {
  std::string name;
  bool used = true;
  std::string reason;  ///< why not; what it is limited by, if it is used
};

/// The strategies of the bidirectional estimator. Telescopes' walks are always connected to the
/// lens, and the laser's walks with them.
struct Strategies {
  Strategy to_laser;           ///< telescopes' walks are connected to the laser
  Strategy between;            ///< vertices of both walks are connected
  Strategy translated;         ///< telescopes' walks are translated so that two rays meet
  Strategy rotated;            ///< they are rotated about where they convert
  Strategy rotated_scattered;  ///< walks of the laser's line about their first vertex
  Strategy free_telescope;     ///< walks of telescopes are put where rays meet, and seen anew
  Strategy free_laser;         ///< walks of the laser are, and lit anew

  /// A line for each.
  [[nodiscard]] std::vector<std::string> report() const;
};

Strategies make_strategies(const scene::Scene& scene, const medium::Medium& medium);

/// The axis of the laser as it goes on in the water.
Vec3<double> beam_in_water(const scene::Scene& scene, const medium::Medium& medium);

/// The lines for a scene, whatever its estimator; none of those that have no choice.
std::vector<std::string> reported_strategies(const scene::Scene& scene,
                                             const medium::Medium& medium);

}  // namespace photic::estimator
