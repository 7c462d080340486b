// The ways to a telescope in the water: straight, or mirrored in the surface.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "transport/connect.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

scene::Telescope submerged(const V& position, const V& direction) {
  scene::Telescope t;
  t.position_m = position;
  t.direction = direction;
  t.diameter_m = 0.2;
  t.obstruction_diameter_m = 0.05;
  t.focal_length_m = 0.5;
  t.detector_diameter_m = 0.8;
  return t;
}

Connection<double> connect(const Sea& sea, const scene::Telescope& scene, const V& from,
                           std::int32_t line, bool mirrored) {
  return connect_in_water(sea.view(), instrument::make_telescope<double>(scene),
                          sea.layer_at(-scene.position_m.z), photon_at(sea, from, line), line,
                          route_of(mirrored));
}

/// Area of the open lens over distance squared, tilted: what the solid angle is from afar.
double far_solid_angle(double distance, double cosine) {
  return pi * (0.1 * 0.1 - 0.025 * 0.025) * cosine / (distance * distance);
}

// Seen red: with the optical depth of the photon's own layer all the way; with the phase for the
// group index.
TEST(ConnectInWater, DirectlyIsTheStraightLine) {
  Random random(51);
  const auto sea = make_sea(40);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const V from = random_place(random);
    const V at =
        i % 10 == 0 ? V{random.between(-10, 10), 3, from.z} : random_place(random);  // some level
    const V straight = normalised(at - from);
    const auto scene = submerged(at, normalised(0.5 * random.direction() - straight));
    const std::int32_t line = random.below(3);
    const auto way = connect(sea, scene, from, line, false);
    if (!(way.acceptance > 0)) continue;
    ++seen;
    const double distance = length(at - from);
    ASSERT_LT(length(way.direction - straight), 1e-14);
    ASSERT_NEAR(way.path, distance * sea.line[static_cast<std::size_t>(line)].group_index,
                1e-12 * way.path);
    ASSERT_NEAR(way.optical_depth, optical_depth_between(sea, line, from, at),
                1e-9 * way.optical_depth);
    const double cosine = -dot(straight, scene.direction);
    const double eta = instrument::make_telescope<double>(scene).overlap(
        1 / (distance * cosine), std::tan(std::acos(cosine)));
    if (distance < 1) continue;  // nearer see LensSolidAngle
    ASSERT_NEAR(way.acceptance / (far_solid_angle(distance, cosine) * eta), 1,
                distance > 10 ? 1e-4 : 0.02);
  }
  EXPECT_GT(seen, 5000);
}

// The mirrored way ends, unfolded, in the lens' mirror image above the surface. Seen red: with the
// mirror image's sign lost; with the optical depths subtracted; with the arriving ray not mirrored;
// without Fresnel's reflectance.
TEST(ConnectInWater, MirroredIsTheStraightLineToTheMirrorImage) {
  Random random(52);
  const auto sea = make_sea(40);
  int total = 0, partial = 0;
  for (int i = 0; i < 20000; ++i) {
    const V from = random_place(random);
    const V at = random_place(random);
    const V image{at.x, at.y, -at.z};
    const V straight = normalised(image - from);
    const V arriving{straight.x, straight.y, -straight.z};
    const auto scene = submerged(at, normalised(0.5 * random.direction() - arriving));
    const std::int32_t line = random.below(3);
    const auto way = connect(sea, scene, from, line, true);
    if (!(way.acceptance > 0)) continue;
    const medium::Line& light = sea.line[static_cast<std::size_t>(line)];
    const double distance = length(image - from);
    const V surface = from + (-from.z / straight.z) * straight;
    ASSERT_LT(length(way.direction - straight), 1e-14);
    ASSERT_NEAR(way.path, distance * light.group_index, 1e-12 * way.path);
    ASSERT_NEAR(way.optical_depth,
                optical_depth_between(sea, line, from, surface) +
                    optical_depth_between(sea, line, surface, at),
                1e-9 * way.optical_depth);
    const double cosine = -dot(arriving, scene.direction);
    const double eta = instrument::make_telescope<double>(scene).overlap(
        1 / (distance * cosine), std::tan(std::acos(cosine)));
    const double critical = std::asin(1 / light.refractive_index);
    const bool beyond = std::acos(straight.z) > critical;
    const double reflectance =
        beyond ? 1 : optics::refract(light.refractive_index, 1.0, straight.z).reflectance;
    (beyond ? total : partial) += 1;
    if (distance < 1) continue;
    ASSERT_NEAR(way.acceptance / (far_solid_angle(distance, cosine) * eta * reflectance), 1,
                distance > 10 ? 1e-4 : 0.02);
  }
  EXPECT_GT(total, 1000);
  EXPECT_GT(partial, 1000);
}

// n = 1.3337 has its critical angle at 48.57 degrees.
TEST(ConnectInWater, MirroredIsTotalBeyondTheCriticalAngle) {
  Sea sea;
  sea.line = {{medium::Process::elastic, 532, 1.3337, 1.36}};
  sea.top = {0, 100};
  sea.c = {0.1};
  sea.albedo = {0.5};
  sea.conversion = {0};
  sea.absorption = {0.5};
  sea.elastic_phase = {
      sea.add_phase(std::make_shared<const optics::PhaseTable>(optics::isotropic()))};
  sea.conversion_phase = {0};
  sea.finish();
  const auto acceptance = [&](double degrees) {
    const double angle = degrees * radian_per_degree;
    const V at{20 * std::tan(angle), 0, -10};
    const V arriving{std::sin(angle), 0, -std::cos(angle)};
    return connect(sea, submerged(at, -arriving), {0, 0, -10}, 0, true).acceptance /
           far_solid_angle(20 / std::cos(angle), 1);
  };
  EXPECT_NEAR(acceptance(48.6), 1, 1e-4);
  EXPECT_NEAR(acceptance(75), 1, 1e-4);
  EXPECT_LT(acceptance(48.4), 0.85);
  EXPECT_NEAR(acceptance(0), std::pow(0.3337 / 2.3337, 2), 1e-5);
}

TEST(ConnectInWater, FromTheLensItselfSeesNothing) {
  const auto sea = make_sea(40);
  const auto way = connect(sea, submerged({1, 2, -3}, {0, 0, -1}), {1, 2, -3}, 0, false);
  EXPECT_EQ(way.acceptance, 0);
}

// Seen red: with the far formula from 5 radii on.
TEST(LensSolidAngle, NearTheLensIsThatOfTheOpenRing) {
  const auto t = instrument::make_telescope<double>(submerged({0, 0, -3}, {0, 0, -1}));
  const auto cap = [](double r, double h) { return 2 * pi * (1 - h / std::hypot(h, r)); };
  for (const double z : {1e-4, 0.01, 0.1, 1.0, 9.0}) {
    EXPECT_NEAR(lens_solid_angle(t, z, 1.0) / (cap(0.1, z) - cap(0.025, z)), 1, 1e-9) << z;
  }
  EXPECT_NEAR(lens_solid_angle(t, 20.0, 0.7) / far_solid_angle(20, 0.7), 1, 1e-15);
}

// At a hundred radii the two formulas differ by less than the promised 1e-4.
TEST(LensSolidAngle, HasNoStepAtTheFarFormula) {
  const auto t = instrument::make_telescope<double>(submerged({0, 0, -3}, {0, 0, -1}));
  for (const double cosine : {1.0, 0.7, 0.1}) {
    const double near = lens_solid_angle(t, 9.999999, cosine);
    const double far = lens_solid_angle(t, 10.000001, cosine);
    EXPECT_NEAR(near / far, 1, 2e-4) << cosine;
  }
}

TEST(LensSolidAngle, NeverExceedsTheHemisphere) {
  Random random(53);
  auto scene = submerged({0, 0, -3}, {0, 0, -1});
  scene.obstruction_diameter_m = 0;
  const auto t = instrument::make_telescope<double>(scene);
  for (int i = 0; i < 100000; ++i) {
    ASSERT_LE(lens_solid_angle(t, random.scale(1e-9, 100), random.uniform()), 2 * pi * (1 + 1e-14));
  }
}

}  // namespace
}  // namespace photic::transport
