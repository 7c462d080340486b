#include "scene/scene.hpp"

#include <cmath>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace photic::scene {

double Telescope::effective_detector_diameter_m() const {
  if (detector_diameter_m) return *detector_diameter_m;
  expect(half_field_of_view_mrad.has_value(), "a telescope has a detector or a field of view");
  // The rim of the detector in the focal plane is the image of that angle; a shift moves the
  // detector and keeps its size.
  return 2.0 * focal_length_m * std::tan(1e-3 * *half_field_of_view_mrad);
}

double Telescope::effective_detector_shift_m() const {
  if (!focus_m) return detector_shift_m;
  // The thin lens, 1 / f = 1 / d + 1 / x: x - f = f^2 / (d - f) (docs/theory.md, eq. 31).
  return focal_length_m * (focal_length_m / (*focus_m - focal_length_m));
}

double Telescope::detector_distance_m() const {
  return focal_length_m + effective_detector_shift_m();
}

const Gates::Interval& Gates::interval() const {
  const auto& given = depth_m ? depth_m : range_m ? range_m : time_ns;
  expect(given.has_value(), "gates are given by depth, range or time");
  return *given;
}

double Gates::Interval::steps() const {
  // A gate narrower than a millionth of a step is rounding of (max - min) / step, not a gate.
  return std::ceil((max - min) / step - 1e-6);
}

double Source::half_divergence() const {
  return fills_cone() ? half_angle_deg * radian_per_degree : half_divergence_mrad * 1e-3;
}

double Source::half_divergence_of_all() const {
  const double angle = half_divergence();
  return profile == SourceProfile::gaussian ? gaussian_cut * angle : angle;
}

double Source::radius_of_all() const {
  const double radius = diameter_m / 2, angle = half_divergence();
  if (profile == SourceProfile::disc) return radius;
  return angle == 0 ? gaussian_cut * radius
                    : radius * (std::tan(half_divergence_of_all()) / std::tan(angle));
}

bool Gates::are_given() const { return depth_m || range_m || time_ns; }

std::int64_t Gates::count() const {
  return are_given() ? static_cast<std::int64_t>(interval().steps()) : 0;
}

bool Tools::any() const {
  Tools others = *this;
  if (at_threshold == AtThreshold::roulette) others.weight_threshold = Tools{}.weight_threshold;
  return others != Tools{};
}

Scene scene_alone(const Scene& scene) {
  // By members: a copy of the whole would copy a thousand environments for each of them.
  return {.title = scene.title,
          .sensitivity = {},
          .source = scene.source,
          .telescope = scene.telescope,
          .channel = scene.channel,
          .tally = scene.tally,
          .optics = scene.optics,
          .sea = scene.sea,
          .bottom = scene.bottom,
          .oil = scene.oil,
          .atmosphere = scene.atmosphere,
          .gates = scene.gates,
          .simulation = scene.simulation,
          .environment = {}};
}

Scene scene_in(const Scene& scene, const Environment& environment) {
  Scene there = scene_alone(scene);
  there.optics = environment.optics;
  there.sea = environment.sea;
  there.bottom = environment.bottom;
  there.oil = environment.oil;
  there.atmosphere = environment.atmosphere;
  return there;
}

double Scene::height_of(const Vec3<double>& position) const {
  if (!is_of_spherical_air()) return position.z;
  const double radius = atmosphere->planet_radius_m();
  const double from_centre = std::hypot(position.x, position.y, position.z + radius);
  const double aside = position.x * position.x + position.y * position.y;
  return (aside + position.z * (position.z + 2 * radius)) / (from_centre + radius);
}

}  // namespace photic::scene
