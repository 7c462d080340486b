// Ways by a rough surface from a point in the water to a lens: means over points and over the lens
// against numbers of other programs, and lanes against scalars.
#include "transport/connect_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/mean.hpp"
#include "transport/aim.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

/// Of index 1.34.
Sea water() {
  Sea sea = make_sea(100);
  sea.line.front().refractive_index = 1.34;
  sea.finish();
  return sea;
}
surface::WavesView waves_of(double upwind_deviation, double crosswind_deviation,
                            double from_degrees = 0) {
  surface::WavesView w;
  w.one_dimensional = upwind_deviation * crosswind_deviation == 0;
  w.upwind_deviation = upwind_deviation;
  w.crosswind_deviation = crosswind_deviation;
  w.upwind_x = std::cos(from_degrees * radian_per_degree);
  w.upwind_y = std::sin(from_degrees * radian_per_degree);
  return w;
}
void rough(medium::MediumView& sea, const surface::WavesView& waves) {
  sea.surface = {.one_direction_each = false, .leads_anywhere = !waves.one_dimensional};
  sea.waves = waves;
}
scene::Telescope telescope_at(const Vec3<double>& position, double dz, double radius) {
  scene::Telescope t;
  t.position_m = position;
  t.direction = {0, 0, dz};
  t.diameter_m = 2 * radius;
  t.focal_length_m = 1;
  t.half_field_of_view_mrad = 1500;  // sees all that comes in
  return t;
}

/// The share of light that a point sends out evenly which comes into a lens by the surface.
test::Mean share_received(const geometry::Slabs& sea, const scene::Telescope& t,
                          const geometry::Region<double>& region, const Photon<double>& photon,
                          int samples) {
  const auto telescope = instrument::make_telescope<double>(t);
  Random random(1);
  test::Mean mean;
  for (int i = 0; i < samples; ++i) {
    const auto lens = lens_point(telescope, random.uniform(), random.uniform());
    const auto way = connect_by_waves(sea, telescope, region, photon, 0, lens,
                                      {random.uniform(), random.uniform(), random.uniform()}, true);
    mean.add(way.acceptance / (4 * pi));
  }
  return mean;
}

// Waves of one direction, from a point 6 m deep to a lens of 1.5 m, 12 m above. Seen red: without
// the slope's change across the waves; with an eighth of a step less in the search.
TEST(WaysByWaves, OfOneDirectionBringWhatFacetsSend) {
  const Sea sea = water();
  for (const auto& waves : {waves_of(0.2, 0), waves_of(0, 0.2, -90)}) {
    auto slabs = sea.view();
    rough(slabs, waves);
    const auto mean = share_received(slabs, telescope_at({0, 0, 12}, -1, 1.5), {true, 0},
                                     photon_at(sea, {0.3, -0.4, -6}), 400'000);
    EXPECT_NEAR(mean.value(), 1.11928e-3, 4 * mean.error() + 1.4e-7 * 4);
    EXPECT_LT(mean.error(), 3e-6);
  }
}

// By reflection from below: from 6 m deep to a disc of 1 m, 5 m deep and 3 m aside.
TEST(WaysByWaves, ReflectedBringWhatFacetsSend) {
  const Sea sea = water();
  auto slabs = sea.view();
  rough(slabs, waves_of(0.18, 0.12));
  const auto mean = share_received(slabs, telescope_at({3, 0, -5}, 1, 1),
                                   region_at(sea, {3, 0, -5}), photon_at(sea, {0, 0, -6}), 400'000);
  EXPECT_NEAR(mean.value(), 3.8476e-5, 4 * mean.error() + 4 * 4e-9);
  EXPECT_LT(mean.error(), 1e-7);
}

// Almost flat facets lead light as a level surface does.
TEST(WaysByWaves, OfAlmostFlatWavesAreThoseOfTheFlatSurface) {
  const Sea sea = water();
  const auto photon = photon_at(sea, {0.3, -0.4, -6});
  const auto t = telescope_at({0, 0, 12}, -1, 0.5);
  const auto telescope = instrument::make_telescope<double>(t);
  Random random(2);
  test::Mean flat;
  for (int i = 0; i < 20'000; ++i) {
    const auto lens = lens_point(telescope, random.uniform(), random.uniform());
    const auto way = connect_ray(sea.view(), telescope, {true, 0}, photon, 0, lens,
                                 geometry::Route::direct, true);
    flat.add(way.acceptance / (4 * pi));
  }
  for (const auto& waves : {waves_of(2e-3, 2e-3), waves_of(2e-3, 0), waves_of(3e-3, 1e-3, 40)}) {
    auto slabs = sea.view();
    rough(slabs, waves);
    const auto mean = share_received(slabs, t, {true, 0}, photon, 100'000);
    EXPECT_NEAR(mean.value(), flat.value(),
                4 * std::hypot(mean.error(), flat.error()) + 2e-5 * flat.value());
  }
}

// Whitecaps alone: a point below them lights them by its solid angle, and each sends what passes
// evenly into the air.
TEST(WaysByWaves, ByWhitecapsAreLambertian) {
  Sea sea = water();
  sea.waves.slopes = {.upwind_variance = 1e-4, .crosswind_variance = 1e-4};
  sea.waves.whitecap_fraction = 1;
  sea.waves.whitecap_reflectance.assign(sea.line.size(), 0.22);
  sea.finish();
  // All of the sea is in view of a small lens straight above, far away.
  const double height = 1000, radius = 0.5;
  const auto mean = share_received(sea.view(), telescope_at({0, 0, height}, -1, radius), {true, 0},
                                   photon_at(sea, {0, 0, -2}), 400'000);
  const double area = pi * radius * radius;
  double aside = 0;  // cos^4 of the way to the lens, over the cosines of the way up
  constexpr int steps = 100'000;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps, off = 2 / height;
    aside += 1 / std::pow(1 + off * off * (1 / (cosine * cosine) - 1), 2) / steps;
  }
  const double expected = 0.5 * (1 - 0.22) / (1.34 * 1.34) * area / (pi * height * height) * aside;
  EXPECT_NEAR(mean.value(), expected, 4 * mean.error());
  EXPECT_LT(mean.error(), 0.005 * expected);
}

// Each lane is the scalar to the bit, by waves of both kinds, to lenses in the air and in the
// water.
TEST(LanesOf, WaysByWaves) {
  Sea sea = water();
  sea.waves.whitecap_fraction = 0.1;
  sea.waves.whitecap_reflectance.assign(sea.line.size(), 0.22);
  sea.waves.slopes = {.upwind_variance = 0.02, .crosswind_variance = 0.01};
  sea.finish();
  Random random(3);
  for (int g = 0; g < groups; ++g) {
    auto slabs = sea.view();
    if (random.chance(0.5)) {
      const auto fraction = slabs.waves.whitecap_fraction;
      const auto reflectance = slabs.waves.whitecap_reflectance;
      rough(slabs, waves_of(0.2, 0, random.between(0, 360)));
      if (random.chance(0.5)) {
        slabs.waves.whitecap_fraction = fraction;
        slabs.waves.whitecap_reflectance = reflectance;
      }
    }
    const bool in_air = random.chance(0.6);
    scene::Telescope t = telescope_at({random.between(-2, 2), 0, in_air ? 12.0 : -3.0},
                                      in_air ? -1 : 1, random.between(0.1, 1));
    t.direction.x = random.between(-0.3, 0.3);
    t.half_field_of_view_mrad = random.between(100, 1000);
    const auto scalar = instrument::make_telescope<double>(t);
    const auto wide = instrument::make_telescope<Lanes4>(t);
    const auto region = region_at(sea, t.position_m);
    const auto photons = four([&] { return random_photon(sea, random); });
    const auto u1 = uniforms4(random), u2 = uniforms4(random), u3 = uniforms4(random);
    const auto lens = lens_point(scalar, random.uniform(), random.uniform());
    const auto packed = connect_by_waves<Lanes4>(
        slabs, wide, {region.outside, Index4(region.layer)}, pack(photons), Index4(0),
        {Lanes4(lens.x), Lanes4(lens.y)}, {pack(u1), pack(u2), pack(u3)}, Mask4(true));
    const auto from_surface =
        connect_from_surface<Lanes4>(slabs, wide, {region.outside, Index4(region.layer)},
                                     pack(photons), Mask4(false), {Lanes4(lens.x), Lanes4(lens.y)});
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto one =
          connect_by_waves(slabs, scalar, region, photons[i], 0, lens, {u1[i], u2[i], u3[i]}, true);
      expect_same(packed.acceptance[i], one.acceptance, "acceptance");
      // Directed sampling sends light where the local estimate will look for it.
      const auto aimed =
          aim_by_waves(slabs, scalar, region, photons[i].position, 0, lens, {u1[i], u2[i], u3[i]});
      if (one.acceptance > 0) {
        EXPECT_TRUE(aimed.in_front);
        expect_same(aimed.direction.x, one.direction.x, "aimed x");
        expect_same(aimed.direction.y, one.direction.y, "aimed y");
      }
      EXPECT_NEAR(dot(aimed.direction, aimed.direction), 1, 1e-12);
      const auto straight = connect_from_surface(slabs, scalar, region, photons[i], false, lens);
      expect_same(from_surface.acceptance[i], straight.acceptance, "from the surface");
      if (one.acceptance > 0) {
        expect_same(packed.direction, i, one.direction, "direction");
        expect_same(packed.path[i], one.path, "path");
        expect_same(packed.optical_depth[i], one.optical_depth, "optical depth");
      }
    }
  }
}

}  // namespace
}  // namespace photic::transport
