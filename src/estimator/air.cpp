#include <algorithm>
#include <cmath>
#include <cstdint>

#include "estimator/model.hpp"
#include "estimator/origin.hpp"
#include "estimator/walk_attenuation.hpp"
#include "medium/outside_column.hpp"
#include "medium/upside_down.hpp"

namespace photic::estimator {
namespace {

/// Instruments at the sea's level count as a little above.
constexpr double min_height_m = 1e-6;

template <class Instrument>
void turn_upside_down(Instrument& instrument) {
  double& z = instrument.position_m.z;
  z = geometry::stands_in_water(instrument.position_m) ? -z : std::min(-z, -min_height_m);
  instrument.direction.z = -instrument.direction.z;
}

/// Has the instruments in the water stand outside the air as a medium, beyond a column of water.
void add_water(const Model& sea, Model& air) {
  const auto depth_m = heights_of(air.scene);
  air.columns = columns_to(sea.medium, depth_m);
  if (!sea.scene.has_environments() || !any_in_water(sea.scene)) return;
  air.medium.environments.excess_outside = medium::excess_depths(sea.medium, depth_m);
  air.medium.finish();
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

Model model_of_air(const Model& model, const std::stop_token& stop) {
  Model out = model;
  turn_upside_down(out.scene.source);
  for (scene::Telescope& t : out.scene.telescope) turn_upside_down(t);
  const double highest = std::max(0.0, std::ranges::max(heights_of(model.scene)));
  const bool from_everywhere =  // light that all of the air scatters comes in, or is tallied
      !model.scene.tally.empty() || std::ranges::any_of(model.scene.telescope, [](const auto& t) {
        return geometry::stands_in_water(t.position_m);
      });
  const double counts_to =
      std::max(from_everywhere ? model.air->height_m.back() : highest, min_height_m);
  constexpr double ample_m = 1;  // for lenses' rims
  out.scene.bottom.reset();
  // Light that is weak in the scene's air may be strong in a clearer one.
  out.scene.simulation.tools.weight_threshold *= std::exp(-clearer_by(model, counts_to));
  out.medium = medium::upside_down(*model.air, model.other_airs, model.medium, counts_to,
                                   highest + ample_m, stop);
  add_water(model, out);
  out.paths = free_paths(out.medium, out.scene.simulation);
  out.averaged = averaged_phases(out.scene, out.medium, stop);
  return out;
}

}  // namespace photic::estimator
