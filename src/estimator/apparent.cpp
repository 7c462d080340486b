#include "estimator/apparent.hpp"

#include <cmath>

#include "medium/bent_axis.hpp"
#include "medium/outside_column.hpp"

namespace photic::estimator {
namespace {

/// Moves one instrument in the air; returns the factor of its angles.
template <class Instrument>
double put_where_it_seems(const medium::Air& air, Instrument& instrument,
                          geometry::ApparentPath& apparent_path) {
  Vec3<double>& at = instrument.position_m;
  if (geometry::stands_in_water(at)) {
    apparent_path.group_path.push_back(0);
    apparent_path.length.push_back(0);
    return 1;
  }
  const auto axis = normalised(instrument.direction);
  const double height = at.z;
  const auto bent = medium::bent_axis(air, height, -axis.z);
  const double sine = std::hypot(axis.x, axis.y);
  const Vec3<double> level =
      sine > 0 ? Vec3<double>{axis.x / sine, axis.y / sine, 0} : Vec3<double>{1, 0, 0};
  const Vec3<double> seen =
      std::sqrt(1 - bent.cosine * bent.cosine) * level - Vec3<double>{0, 0, bent.cosine};
  at = Vec3<double>{at.x, at.y, 0} + bent.aside_m * level - bent.apparent_distance_m * seen;
  instrument.direction = seen;
  apparent_path.group_path.push_back(bent.apparent_distance_m +
                                     medium::delay_of(air, 0).to(height) / bent.cosine -
                                     bent.group_path_m);
  apparent_path.length.push_back(bent.apparent_distance_m - bent.length_m);
  return bent.apparent_angle;
}

}  // namespace

geometry::ApparentPath put_where_they_seem(const medium::Air& air, scene::Scene& scene) {
  geometry::ApparentPath apparent_path;
  scene.source.half_divergence_mrad *= put_where_it_seems(air, scene.source, apparent_path);
  for (scene::Telescope& t : scene.telescope) {
    const double detector = t.effective_detector_diameter_m();
    t.detector_diameter_m = detector * put_where_it_seems(air, t, apparent_path);
    t.half_field_of_view_mrad.reset();
  }
  return apparent_path;
}

}  // namespace photic::estimator
