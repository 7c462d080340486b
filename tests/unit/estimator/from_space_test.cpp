// Times of light to and from instruments in space, in float: each against lengths of straight ways
// in double. 0.01 ns are 3 mm of path.
#include <gtest/gtest.h>

#include "estimator/bidirectional/birth.hpp"
#include "estimator/origin.hpp"
#include "support/random.hpp"
#include "transport/connect_ray.hpp"
#include "transport/cross.hpp"
#include "unit/transport/enter_water.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

constexpr double height = 705e3;
constexpr double path_tolerance = 1e-3;   // [m]
constexpr double place_tolerance = 2e-3;  // [m]
constexpr int samples = 2000;

/// A lidar that looks down, or aside by 30 degrees.
struct Lidar {
  scene::Source source;
  scene::Telescope telescope;

  Lidar(double half_divergence_mrad, bool tilted) {
    source.wavelength_nm = 532;
    source.position_m = {1000, -2000, height};
    source.direction = tilted ? V{0.3, -0.4, -std::sqrt(0.75)} : V{0, 0, -1};
    source.diameter_m = 0.8;
    source.half_divergence_mrad = half_divergence_mrad;
    telescope.position_m = source.position_m + V{1.5, 0.5, 0.25};
    telescope.direction = source.direction;
    telescope.diameter_m = 2;
    telescope.focal_length_m = 4;
    telescope.detector_diameter_m = 0.01;
    const V origin = estimator::origin_of(source, medium::MediumKind::water);
    source = estimator::from_origin(source, origin);
    telescope = estimator::from_origin(telescope, origin);
  }
};

class FromSpace : public testing::TestWithParam<bool> {};

/// A uniform that a float can hold.
double uniform(Random& random) { return double(float(random.uniform())); }

/// An instrument's cone in the precision of a walk, which may be free.
template <class T, class Instrument>
estimator::EntryCone<T> cone_of(const Instrument& instrument, const medium::Medium& sea,
                                bool free) {
  return estimator::cone_cast<T>(free ? estimator::entry_cone(instrument, sea, 50)
                                      : estimator::cone_of_own_rays(instrument, sea));
}
/// A ray of it, and the same in double.
struct Rays {
  estimator::EntryRay<float> in_float;
  estimator::EntryRay<double> exact;
};
template <class Instrument>
Rays rays_of(const Instrument& instrument, const Sea& sea, bool free, Random& random) {
  const double u = uniform(random), v = uniform(random);
  const double n = sea.line[0].refractive_index;
  const auto n_float = float(n);
  return {draw_entry(cone_of<float>(instrument, sea, free), n_float, n_float, float(u), float(v)),
          draw_entry(cone_of<double>(instrument, sea, free), n, n, u, v)};
}

// Seen red: with the light emitted on the disc; with off_axis from the difference of directions.
TEST_P(FromSpace, LaserLightGetsThereInTime) {
  const auto sea = make_sea(60);
  Random random(401);
  for (const double mrad : {0.0, 0.01, 0.5}) {
    const Lidar lidar(mrad, GetParam());
    const auto in_float = instrument::make_laser<float>(lidar.source);
    const auto laser = instrument::make_laser<double>(lidar.source);
    for (int i = 0; i < samples; ++i) {
      const double u = uniform(random), v = uniform(random);
      auto photon = emit(in_float, 0, float(u), float(v));
      ASSERT_TRUE(test::enter_water(sea.view(), {true, 0}, photon));
      // From the disc, in its plane, straight on.
      const double x = u * laser.one_minus_cos_divergence;
      const V aside = turned(laser.axis, 1.0, std::cos(2 * pi * v), std::sin(2 * pi * v));
      const double tangent = std::sqrt(x * (2 - x)) / (1 - x);
      const double from_centre =
          mrad > 0 ? laser.vertex_distance * tangent : laser.radius * std::sqrt(u);
      const V disc = lidar.source.position_m + from_centre * aside;
      const V direction = normalised(laser.axis + (mrad > 0 ? tangent : 0.0) * aside);
      const double length = disc.z / -direction.z;
      const V place = disc + length * direction;
      ASSERT_LT(photic::length(vec3_cast<double>(photon.position) - place), place_tolerance);
      ASSERT_NEAR(photon.path, length - laser.ahead, path_tolerance);
    }
  }
}

// Seen red: with the difference of both lengths for longer_by(), in either.
TEST_P(FromSpace, LightGetsBackInTime) {
  const Lidar lidar(0.5, GetParam());
  const auto sea = make_sea(60);
  const auto in_float = instrument::make_telescope<float>(lidar.telescope);
  const auto telescope = instrument::make_telescope<double>(lidar.telescope);
  Random random(402);
  int seen = 0;
  for (int i = 0; i < samples; ++i) {
    Photon<float> photon;
    photon.position = {float(random.between(-400, 400)), float(random.between(-400, 400)),
                       float(-random.scale(0.01, 50))};
    photon.layer = sea.layer_at(-photon.position.z);
    const std::int32_t line = random.below(3);
    const auto expected = [&](const V& to) {
      const V from = vec3_cast<double>(photon.position);
      const auto way = geometry::sightline_through_surface(sea.view(), from, line, to, true);
      const V surface = from + way.length_water * way.direction;
      return length(to - surface) - length(telescope.position) +
             way.length_water * sea.line[static_cast<std::size_t>(line)].group_index;
    };
    const auto whole = connect_through_surface(sea.view(), in_float, photon, line, true);
    const instrument::PlanePoint<float> lens =
        lens_point(in_float, float(random.uniform()), float(random.uniform()));
    const auto ray = connect_ray(sea.view(), in_float, {true, 0}, photon, line, lens,
                                 geometry::Route::direct, true);
    if (!(whole.acceptance > 0 && ray.acceptance > 0)) continue;
    ++seen;
    ASSERT_NEAR(whole.path, expected(telescope.position), path_tolerance);
    const instrument::PlanePoint<double> point{lens.x, lens.y};
    ASSERT_NEAR(ray.path, expected(in_space(telescope, point)), path_tolerance);
  }
  EXPECT_GT(seen, samples / 2);
}

TEST_P(FromSpace, WalksFromTheLaserAreTimed) {
  const auto sea = make_sea(60);
  Random random(404);
  const Lidar lidar(0.5, GetParam());
  const auto in_float = instrument::make_laser<float>(lidar.source);
  const auto laser = instrument::make_laser<double>(lidar.source);
  int emitted = 0;
  for (int i = 0; i < samples / 10; ++i) {
    const bool free = i % 2 == 0;
    const auto cone = cone_of<float>(lidar.source, sea, free);
    const auto [ray, exact] = rays_of(lidar.source, sea, free, random);
    const auto walk = estimator::birth_at_laser<float>(sea.view(), in_float, {true, 0}, cone, ray);
    emitted += walk.own;
    const V direction = exact.outside;
    const V vertex = lidar.source.position_m - laser.vertex_distance * laser.axis;
    const V place = vertex + (vertex.z / -direction.z) * direction;
    const double length =
        vertex.z / -direction.z - laser.vertex_distance / dot(direction, laser.axis);
    ASSERT_LT(photic::length(vec3_cast<double>(walk.photon.position) - place), place_tolerance);
    ASSERT_NEAR(walk.photon.path, length - laser.ahead, path_tolerance);
  }
  EXPECT_GT(emitted, samples / 20);
}

// Seen red: with the path that come_down() gives.
TEST_P(FromSpace, WalksFromTelescopesAreTimed) {
  const Lidar lidar(0.5, GetParam());
  const auto sea = make_sea(60);
  const auto in_float = instrument::make_telescope<float>(lidar.telescope);
  const auto telescope = instrument::make_telescope<double>(lidar.telescope);
  Random random(403);
  for (int i = 0; i < samples / 10; ++i) {
    const auto lens = lens_point(in_float, float(random.uniform()), float(random.uniform()));
    const bool free = i % 2 == 0;
    const auto cone = cone_of<float>(lidar.telescope, sea, free);
    const auto [ray, exact] = rays_of(lidar.telescope, sea, free, random);
    const auto walk =
        estimator::birth_at_telescope<float>(sea.view(), in_float, {true, 0}, cone, ray, 0, lens);
    const V from = in_space(telescope, instrument::PlanePoint<double>{lens.x, lens.y});
    const V place = from + (from.z / -exact.outside.z) * exact.outside;
    const V here = vec3_cast<double>(walk.photon.position);
    ASSERT_LT(length(here - place), place_tolerance);
    ASSERT_NEAR(walk.photon.path, length(from - here) - length(telescope.position), path_tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Lidars, FromSpace, testing::Bool(), [](const auto& tilted) {
  return tilted.param ? "LooksAside" : "LooksDown";
});

}  // namespace
}  // namespace photic::transport
