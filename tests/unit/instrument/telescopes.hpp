// Telescopes for tests.
#pragma once

#include "instrument/lens.hpp"
#include "support/random.hpp"

namespace photic::instrument {

/// The paper's Table 1: a lens of 40 cm and 2 m focal length, a detector of 4 cm in its focus, 12 m
/// above the sea.
inline scene::Telescope table_1() {
  scene::Telescope t;
  t.position_m = {0, 0, 12};
  t.direction = {0, 0, -1};
  t.diameter_m = 0.40;
  t.focal_length_m = 2.0;
  t.detector_diameter_m = 0.04;
  return t;
}

inline scene::Telescope table_1_shifted(double detector_shift_m) {
  auto t = table_1();
  t.detector_shift_m = detector_shift_m;
  return t;
}

/// Any telescope in the air: small or large, wide or narrow, sharp or defocused, tilted by up to 70
/// degrees.
inline scene::Telescope random_telescope(test::Random& random) {
  scene::Telescope t;
  t.position_m = {random.between(-5, 5), random.between(-5, 5), random.scale(0.1, 1000)};
  const double tilt = random.between(0, 70) * radian_per_degree;
  const double azimuth = random.between(0, 2 * pi);
  t.direction = {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                 -std::cos(tilt)};
  t.diameter_m = random.scale(0.01, 2);
  t.obstruction_diameter_m = random.chance(0.5) ? 0.0 : t.diameter_m * random.between(0, 0.8);
  t.focal_length_m = random.scale(0.05, 10);
  t.detector_diameter_m = t.focal_length_m * random.scale(1e-3, 1.0);
  t.detector_shift_m = t.focal_length_m * (random.chance(0.3) ? 0.0 : random.between(-0.2, 0.2));
  return t;
}

/// One of them as it is walked with, and what it is made of; half of them upright.
inline Telescope<double> random_telescope(test::Random& random, scene::Telescope& scene) {
  scene = random_telescope(random);
  if (random.chance(0.5)) scene.direction = {0, 0, -1};
  return make_telescope<double>(scene);
}

/// How far the ray from a point of the detector through one of the lens leads aside out in the
/// world, per length along the axis: the way back of the light that falls there.
template <class T>
PlanePoint<T> outward_slope(const Telescope<T>& telescope, const PlanePoint<T>& p,
                            const PlanePoint<T>& on_detector) {
  const T per_distance = T(1) / telescope.detector_distance;
  return {-(on_detector.x * per_distance + p.x * telescope.per_sharp_range),
          -(on_detector.y * per_distance + p.y * telescope.per_sharp_range)};
}
}  // namespace photic::instrument
