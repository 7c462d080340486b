// Directions to telescopes for what aims at them.
#include "transport/aim.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "transport/connect.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

Aim<double> aim_from(const Sea& sea, const scene::Telescope& scene, const V& from) {
  const auto telescope = instrument::make_telescope<double>(scene);
  return aim(sea.view(), telescope, {true, 0}, from, 0, telescope.position, geometry::Route::direct,
             may_see(sea.view(), telescope, from, 0));
}

// The refracted way, not the straight one. Seen red: with the direction in the air.
TEST(Aim, ThroughTheSurfaceIsTheRefractedWay) {
  const auto sea = make_sea(60);
  const double n = sea.line.front().refractive_index;
  for (const double aside : {0.0, 0.05, 1.0, 5.0, 15.0}) {
    const auto way = aim_from(sea, instrument::table_1(), {aside, 0, -20});
    EXPECT_TRUE(way.in_front);
    const double squared = aside * aside;
    const double tangent =
        aside * geometry::crossing(n, 20.0, 12.0, squared,
                                   geometry::crossing_start(1 / n, 20.0, 12.0, squared));
    EXPECT_NEAR(-way.direction.x, std::sin(std::atan(tangent)) / n, aside > 1 ? 0.02 : 1e-12);
    EXPECT_NEAR(length(way.direction), 1, 1e-12);
  }
}

TEST(Aim, BehindTheLensIsNotInFront) {
  const auto sea = make_sea(60);
  auto up = instrument::table_1();
  up.direction = {0, 0, 1};
  EXPECT_FALSE(aim_from(sea, up, {1, 0, -20}).in_front);
}

// Seen red: with the mirrored way looked at as it leaves, not as it arrives.
TEST(Aim, InTheWaterIsStraightOrMirrored) {
  const auto sea = make_sea(60);
  auto scene = instrument::table_1();
  scene.position_m = {0, 0, -3};
  scene.direction = {0, 0, 1};
  const auto telescope = instrument::make_telescope<double>(scene);
  const auto from = [&](const V& place, bool mirrored) {
    return aim(sea.view(), telescope, {false, 0}, place, 0, telescope.position, route_of(mirrored),
               true);
  };
  const V beside{4, 0, -3};
  EXPECT_FALSE(from(beside, false).in_front);
  const auto mirrored = from(beside, true);
  EXPECT_TRUE(mirrored.in_front);
  EXPECT_NEAR(mirrored.direction.x, -4 / std::hypot(4, 6), 1e-12);
  EXPECT_NEAR(mirrored.direction.z, 6 / std::hypot(4, 6), 1e-12);
  EXPECT_FALSE(from(telescope.position, false).in_front);
}

TEST(Aim, OfLanesIsThatOfEach) {
  Random random(31);
  const auto sea = make_sea(40);
  for (int g = 0; g < groups; ++g) {
    auto scene = instrument::random_telescope(random);
    const bool submerged = random.chance(0.4), mirrored = random.chance(0.5);
    if (submerged) scene.position_m.z = -random.between(0.1, 20);
    const auto telescope = instrument::make_telescope<double>(scene);
    const auto telescope4 = instrument::make_telescope<Lanes4>(scene);
    const auto photon = four([&] { return random_photon(sea, random); });
    const auto packed = pack(photon);
    const auto aim4 = aim(sea.view(), telescope4, {!submerged, {}}, packed.position, packed.line,
                          telescope4.position, route_of(mirrored),
                          may_see(sea.view(), telescope4, packed.position, packed.line));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& one = photon[i];
      const auto way =
          aim(sea.view(), telescope, {!submerged, {}}, one.position, one.line, telescope.position,
              route_of(mirrored), may_see(sea.view(), telescope, one.position, one.line));
      expect_same(aim4.direction, i, way.direction, "direction");
      expect_same(aim4.in_front[i], way.in_front, "in front");
    }
  }
}

}  // namespace
}  // namespace photic::transport
