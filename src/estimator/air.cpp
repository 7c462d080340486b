#include <algorithm>

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
  out.medium =
      medium::upside_down(*model.air, model.other_airs, model.medium, -highest, -highest + ample_m);
  out.paths = free_paths(out.medium, out.scene.simulation);
  out.averaged = averaged_phases(out.scene, out.medium);
  return out;
}

}  // namespace photic::estimator
