// The ways from a point in the water to a telescope, against rays traced forward.
#include "transport/connect.hpp"

#include <gtest/gtest.h>

#include "transport/cross.hpp"
#include "transport/emit.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/connect_if_seen.hpp"
#include "unit/transport/enter_water.hpp"
#include "unit/transport/refracted_rays.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

/// A wide telescope that sees points far aside.
scene::Telescope wide_telescope(const V& position, const V& direction) {
  scene::Telescope t;
  t.position_m = position;
  t.direction = direction;
  t.diameter_m = 0.2;
  t.obstruction_diameter_m = 0.05;
  t.focal_length_m = 0.5;
  t.detector_diameter_m = 1.6;
  return t;
}

/// The share of light that crosses the surface, measured by light on its way down.
double transmittance_downward(const Sea& sea, std::int32_t line, const V& rising_in_air) {
  Photon<double> photon;
  photon.line = line;
  photon.position = {0, 0, 1};
  photon.direction = -rising_in_air;
  test::enter_water(sea.view(), {true, 0}, photon);
  return photon.weight;
}

// The light leaves the point in the way's direction, is refracted by Snell's law and must arrive at
// the lens; what the way says of it must hold. The transmittance is that of light going the other
// way (reciprocity). Seen red: without n^2; with the phase for the group index; with the c or the n
// of the photon's line for the emitted line's; with the optical depth straight up; with the area of
// the lens' obstruction added; without the cosine off the axis; without Fresnel's losses.
TEST(ConnectThroughSurface, IsTheWayOfALightRay) {
  Random random(41);
  const auto sea = make_sea(60);
  int seen = 0;
  for (int i = 0; i < 5000; ++i) {
    const double tilt = random.between(0, 50) * radian_per_degree;
    const auto scene =
        wide_telescope({random.between(-3, 3), random.between(-3, 3), random.scale(1, 100)},
                       {std::sin(tilt), 0, -std::cos(tilt)});
    const auto telescope = instrument::make_telescope<double>(scene);
    const double spread = 1.5 * scene.position_m.z;
    const auto photon = photon_at(
        sea,
        {random.between(-spread, spread), random.between(-spread, spread), -random.scale(0.01, 50)},
        random.below(3));
    const std::int32_t line = random.below(3);
    const auto way = connect_if_seen(sea, telescope, photon, line);
    if (!(way.acceptance > 0)) continue;
    ++seen;
    const medium::Line& light = sea.line[static_cast<std::size_t>(line)];
    const double n = light.refractive_index;

    ASSERT_NEAR(length(way.direction), 1, 1e-13);
    const double in_water = -photon.position.z / way.direction.z;
    const V surface = photon.position + in_water * way.direction;
    V air{n * way.direction.x, n * way.direction.y, 0};
    air.z = std::sqrt(1 - dot(air, air));
    const double in_air = scene.position_m.z / air.z;
    ASSERT_LT(length(surface + in_air * air - scene.position_m), 1e-9 * (in_air + in_water));
    const double longer = in_air - length(scene.position_m);
    ASSERT_NEAR(way.path, longer + in_water * light.group_index, 1e-9 * (in_air + in_water));
    ASSERT_NEAR(way.optical_depth,
                optical_depth_between(sea, line, photon.position, {surface.x, surface.y, 0}),
                1e-9 * way.optical_depth);

    const double cos_off_axis = -dot(air, normalised(scene.direction));
    const double apparent = in_air + in_water / n;
    const double eta =
        telescope.overlap(1 / (apparent * cos_off_axis), std::tan(std::acos(cos_off_axis)));
    const double area = pi * (0.1 * 0.1 - 0.025 * 0.025);
    const double factor =
        solid_angle_per_area(n, -photon.position.z, scene.position_m.z, std::acos(air.z));
    const double transmitted = transmittance_downward(sea, line, air);
    ASSERT_NEAR(way.acceptance / (factor * area * cos_off_axis * eta * transmitted), 1, 1e-5)
        << std::acos(air.z);
  }
  EXPECT_GT(seen, 1000);
}

TEST(ConnectThroughSurface, OfAPointBelowTheLidarIsTheLidarEquations) {
  const auto sea = make_sea(60);
  const auto telescope = instrument::make_telescope<double>(instrument::table_1());
  const auto way = connect_if_seen(sea, telescope, photon_at(sea, {0, 0, -20}), 0);
  const double n = 1.3415;
  const double loss = std::pow((n - 1) / (n + 1), 2);
  EXPECT_EQ(way.direction, (V{0, 0, 1}));
  EXPECT_NEAR(way.acceptance / ((1 - loss) * pi * 0.04 / std::pow(n * 12 + 20, 2)), 1, 1e-12);
  EXPECT_NEAR(way.path, 1.3638 * 20, 1e-12);
  EXPECT_NEAR(way.optical_depth, 0.2 * 5 + 0.5 * 7 + 0.1 * 8, 1e-12);
}

TEST(ConnectThroughSurface, OutsideTheFieldOfViewNothingIsSeen) {
  const auto sea = make_sea(60);
  const auto telescope = instrument::make_telescope<double>(instrument::table_1());
  EXPECT_EQ(connect_if_seen(sea, telescope, photon_at(sea, {15, 0, -20}), 0).acceptance, 0);
}

TEST(ConnectThroughSurface, BehindTheLensNothingIsSeen) {
  const auto sea = make_sea(60);
  const auto telescope = instrument::make_telescope<double>(wide_telescope({0, 0, 12}, {0, 0, 1}));
  EXPECT_EQ(connect_if_seen(sea, telescope, photon_at(sea, {1, 0, -20}), 0).acceptance, 0);
}

}  // namespace
}  // namespace photic::transport
