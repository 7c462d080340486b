#include <algorithm>
#include <cmath>
#include <cstdint>

#include "estimator/model.hpp"
#include "estimator/walk_attenuation.hpp"
#include "medium/upside_down.hpp"

namespace photic::estimator {
namespace {

/// Instruments at the sea's level count as a little above.
constexpr double min_height_m = 1e-6;

template <class Instrument>
void turn_upside_down(Instrument& instrument) {
  instrument.position_m.z = std::min(-instrument.position_m.z, -min_height_m);
  instrument.direction.z = -instrument.direction.z;
}

/// The optical depth by which the clearest of other airs is clearer than the scene's, straight up
/// to a height, in the laser's light.
double clearer_by(const Model& model, double height_m) {
  const auto depth = [&](const medium::Air& air) {
    return medium::column_to(air, height_m).optical_depth.front();
  };
  double out = 0;
  for (std::int32_t e = 0; e < model.medium.environments.first_tangent; ++e)
    out =
        std::max(out, depth(*model.air) - depth(model.other_airs[static_cast<std::size_t>(e)].to));
  return out;
}

}  // namespace

Model model_of_air(const Model& model) {
  Model out = model;
  turn_upside_down(out.scene.source);
  double highest = out.scene.source.position_m.z;  // a depth with a minus
  for (scene::Telescope& t : out.scene.telescope) {
    turn_upside_down(t);
    highest = std::min(highest, t.position_m.z);
  }
  constexpr double ample_m = 1;  // for lenses' rims
  out.scene.bottom.reset();
  // Light that is weak in the scene's air may be strong in a clearer one.
  out.scene.simulation.tools.weight_threshold *= std::exp(-clearer_by(model, -highest));
  out.medium =
      medium::upside_down(*model.air, model.other_airs, model.medium, -highest, -highest + ample_m);
  out.paths = free_paths(out.medium, out.scene.simulation);
  out.averaged = averaged_phases(out.scene, out.medium);
  return out;
}

}  // namespace photic::estimator
