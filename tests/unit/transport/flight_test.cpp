// Free flight through the layers.
#include "transport/flight.hpp"

#include <gtest/gtest.h>

#include "support/mean.hpp"
#include "support/random.hpp"
#include "support/z_test.hpp"
#include "transport/cross.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

Photon<double> photon_from(const Sea& sea, double depth, const V& direction,
                           std::int32_t line = 0) {
  Photon<double> photon;
  photon.position = {0.3, -0.2, -depth};
  photon.direction = direction;
  photon.line = line;
  photon.layer = sea.layer_at(depth);
  photon.path = 7;
  return photon;
}

// Wherever a flight ends, the walk's optical depth of its way is -ln(u), or less where surface or
// bed stood in the way. The path grows by the way times the line's group index; the weight takes
// what c absorbs beyond the walk's coefficient, and their ratio at a collision. Seen red: with the
// phase for the group index; with the first layer's coefficient in the last; with the layers
// searched downwards only; with the flight to the surface not ended there; without the ratio at a
// collision; with the weight's exponent turned round.
TEST(Fly, GoesAsFarAsItsOpticalDepth) {
  Random random(61);
  int surface = 0, bed = 0, level = 0, crossed = 0;
  for (const double bottom : {25.0, std::numeric_limits<double>::infinity()}) {
    const auto sea = make_sea(bottom);
    const auto walk = walk_coefficients(sea);
    for (int i = 0; i < 50000; ++i) {
      V direction = random.direction();
      if (i % 10 == 0) direction = {0.6, -0.8, 0};
      const auto before = photon_from(sea, random.between(0, 25), direction, random.below(3));
      auto photon = before;
      const double u = random.uniform();
      const auto end = fly(sea.view(), photon, minus_log(u));
      const V way = photon.position - before.position;
      const double walk_tau =
          integral_between(sea, walk, photon.line, before.position, photon.position);
      const double tau = optical_depth_between(sea, photon.line, before.position, photon.position);
      const auto cell = static_cast<std::size_t>(photon.line * 3 + photon.layer);
      const bool collides = !end.surface && !end.sea_bed;
      ASSERT_LT(length(way - length(way) * direction), 1e-9 * (1 + length(way)));
      ASSERT_NEAR(photon.path,
                  7 + length(way) * sea.line[static_cast<std::size_t>(photon.line)].group_index,
                  1e-9 * photon.path);
      ASSERT_EQ(photon.direction, direction);
      ASSERT_NEAR(
          photon.weight / (std::exp(walk_tau - tau) * (collides ? sea.c[cell] / walk[cell] : 1)), 1,
          1e-8 * (1 + tau));
      ASSERT_EQ(photon.analog_weight, photon.weight);
      ASSERT_FALSE(end.surface && end.sea_bed);
      if (collides) {
        ASSERT_NEAR(walk_tau, -std::log(u), 1e-8 * (1 + walk_tau)) << direction.z;
        ASSERT_EQ(photon.layer, sea.layer_at(-photon.position.z));
        ASSERT_LT(photon.position.z, 0);
        ASSERT_GT(photon.position.z, -bottom);
      } else {
        ASSERT_LE(walk_tau, -std::log(u) * (1 + 1e-12));
        ASSERT_EQ(-photon.position.z, end.surface ? 0 : bottom);
        ASSERT_EQ(photon.layer, end.surface ? 0 : 2);
      }
      surface += end.surface;
      bed += end.sea_bed;
      level += direction.z == 0;
      crossed += photon.layer != before.layer;
    }
  }
  EXPECT_GT(surface, 1000);
  EXPECT_GT(bed, 1000);
  EXPECT_GT(level, 1000);
  EXPECT_GT(crossed, 5000);
}

struct Flight {
  const char* what;
  V direction;
  double depth;
};

const std::vector<Flight> flights{{"straight down", {0, 0, -1}, 1},
                                  {"slanted down", {0.8, 0, -0.6}, 8},
                                  {"straight up", {0, 0, 1}, 20},
                                  {"slanted up", {0, -0.6, 0.8}, 14},
                                  {"level", {0, 1, 0}, 8},
                                  {"nearly level", {0, 1, -1e-12}, 8},
                                  {"up, in the first layer", {0.6, 0, 0.8}, 2}};

/// The share of light that has not collided after s metres of a flight.
double transmitted(const Sea& sea, const Flight& flight, double s) {
  const V start{0.3, -0.2, -flight.depth};
  return std::exp(-optical_depth_between(sea, 0, start, start + s * flight.direction));
}

/// The length of a flight to the surface or the bed; endless if level.
double longest_way(const Flight& flight, double bottom) {
  if (flight.direction.z > 0) return flight.depth / flight.direction.z;
  return flight.direction.z < -1e-9 ? (bottom - flight.depth) / -flight.direction.z : 1e3;
}

// The law of free paths in three layers: times their weight, flights end within each metre with the
// chance exp(-optical depth) says, and the rest of the light arrives at the surface or on the bed.
// z-tests, 1 % for the family. Seen red: with the free path doubled; with the layers' edges
// ignored; with the weight left alone.
TEST(Fly, HasTheFreePathsOfThreeLayers) {
  constexpr int samples = 200000;
  constexpr double bottom = 25;
  const auto sea = make_sea(bottom);
  Random random(62);
  test::ZFamily family(0.01);
  for (const Flight& flight : flights) {
    const double longest = longest_way(flight, bottom);
    const auto cells = static_cast<std::size_t>(std::min(15.0, std::ceil(longest)));
    std::vector<test::Mean> ended(cells);
    test::Mean arrived;
    for (int i = 0; i < samples; ++i) {
      auto photon = photon_from(sea, flight.depth, flight.direction);
      const V start = photon.position;
      const auto end = fly(sea.view(), photon, minus_log(random.uniform()));
      const bool arrives = end.surface || end.sea_bed;
      const auto metre =
          arrives ? cells : static_cast<std::size_t>(length(photon.position - start));
      for (std::size_t k = 0; k < cells; ++k) ended[k].add(k == metre ? photon.weight : 0);
      arrived.add(arrives ? photon.weight : 0);
    }
    for (std::size_t k = 0; k < cells; ++k) {
      const double from = static_cast<double>(k);
      const double share =
          transmitted(sea, flight, from) - transmitted(sea, flight, std::min(from + 1, longest));
      family.add(ended[k].value(), share, ended[k].error(),
                 flight.what + (", metre " + std::to_string(k)));
    }
    if (longest < 1e3) {
      family.add(arrived.value(), transmitted(sea, flight, longest), arrived.error(),
                 flight.what + std::string(", arriving"));
    } else {
      EXPECT_EQ(arrived.sum, 0) << flight.what;
    }
  }
  family.judge();
}

TEST(Advance, MovesAcrossLayersAndReturnsWhereTheWaterEnds) {
  const auto sea = make_sea(25);
  const V slanted{0.6, 0, -0.8};
  const auto moved = [&](double from, const V& direction, double distance, bool& in_water) {
    auto photon = photon_from(sea, from, direction, 1);
    in_water = advance(sea.view(), photon, distance);
    EXPECT_NEAR(photon.path, 7 + distance * 1.3542, 1e-12);
    EXPECT_NEAR(photon.position.z, -from + distance * direction.z, 1e-12);
    EXPECT_EQ(photon.weight, 1);
    return photon.layer;
  };
  bool in_water = false;
  EXPECT_EQ(moved(1, slanted, 1, in_water), 0);
  EXPECT_TRUE(in_water);
  EXPECT_EQ(moved(1, slanted, 10, in_water), 1);
  EXPECT_EQ(moved(1, slanted, 20, in_water), 2);
  EXPECT_TRUE(in_water);
  EXPECT_EQ(moved(20, -slanted, 20, in_water), 0);
  EXPECT_TRUE(in_water);
  moved(20, -slanted, 26, in_water);
  EXPECT_FALSE(in_water);  // above the surface
  moved(20, slanted, 10, in_water);
  EXPECT_FALSE(in_water);  // in the bed
}

// Seen red: with the reflectance of the other side (no total reflection); with the direction left
// as it is; with the weight times the transmittance.
TEST(ReflectDown, KeepsTheReflectedShare) {
  const auto sea = make_sea(25);
  const double n = 1.3415;
  for (const double degrees : {0.0, 20.0, 40.0, 48.0, 48.3, 60.0, 89.0}) {
    const double angle = degrees * radian_per_degree;
    auto photon = photon_from(sea, 0, {std::sin(angle), 0, std::cos(angle)});
    photon.weight = 0.8;
    photon.analog_weight = 0.5;
    const double leaving = reflect_down(sea.view(), photon).into_air;
    EXPECT_NEAR(leaving + photon.weight, 0.8, 1e-15) << degrees;
    EXPECT_NEAR(photon.analog_weight / photon.weight, 0.5 / 0.8, 1e-12);
    EXPECT_EQ(photon.direction, (V{std::sin(angle), 0, -std::cos(angle)}));
    EXPECT_EQ(photon.path, 7);
    if (std::sin(angle) * n > 1) {
      EXPECT_EQ(leaving, 0) << degrees;
    } else {
      EXPECT_GT(leaving, 0.3) << degrees;
    }
  }
  auto straight = photon_from(sea, 0, {0, 0, 1});
  EXPECT_NEAR(1 - reflect_down(sea.view(), straight).into_air, std::pow((n - 1) / (n + 1), 2),
              1e-15);
}

// Both parts of the way have the walk's optical depth of the whole free path, or less where the bed
// stood in the way; the second leads on along the mirrored line, with what is reflected. Seen red:
// with more than what is left of the free path; with the direction left as it is; without the bed
// that the second part ends at.
TEST(FlyOn, GoesOnAlongTheMirroredLine) {
  Random random(63);
  int reflected = 0, bed = 0, others = 0;
  for (const double bottom : {25.0, std::numeric_limits<double>::infinity()}) {
    const auto sea = make_sea(bottom);
    const auto walk = walk_coefficients(sea);
    for (int i = 0; i < 50000; ++i) {
      const V direction = random.direction();
      const auto before = photon_from(sea, random.between(0, 4), direction, random.below(3));
      auto photon = before;
      const double u = random.uniform() * random.uniform();
      auto end = fly(sea.view(), photon, minus_log(u));
      const bool at_surface = end.surface;
      const auto there = photon;
      fly_on(sea.view(), photon, end,
             [&](bool, Photon<double>& down) { reflect_down(sea.view(), down); });
      ASSERT_FALSE(end.surface);
      if (!at_surface) {
        ASSERT_EQ(photon.position, there.position);
        ASSERT_EQ(photon.weight, there.weight);
        ++others;
        continue;
      }
      ++reflected;
      bed += end.sea_bed ? 1 : 0;
      const V crossing = before.position - (before.position.z / direction.z) * direction;
      const V way = photon.position - crossing;
      const V mirrored{direction.x, direction.y, -direction.z};
      ASSERT_LT(length(way - length(way) * mirrored), 1e-9 * (1 + length(way)));
      ASSERT_EQ(photon.direction, mirrored);
      const double both = length(crossing - before.position) + length(way);
      const auto line = static_cast<std::size_t>(photon.line);
      ASSERT_NEAR(photon.path, 7 + both * sea.line[line].group_index, 1e-9 * photon.path);
      ASSERT_NEAR(end.length, both, 1e-9 * (1 + both));
      const double walk_tau =
          integral_between(sea, walk, photon.line, before.position, {crossing.x, crossing.y, 0}) +
          integral_between(sea, walk, photon.line, {crossing.x, crossing.y, 0}, photon.position);
      const double tau =
          optical_depth_between(sea, photon.line, before.position, {crossing.x, crossing.y, 0}) +
          optical_depth_between(sea, photon.line, {crossing.x, crossing.y, 0}, photon.position);
      const auto cell = line * 3 + static_cast<std::size_t>(photon.layer);
      const double gain = end.sea_bed ? 1 : sea.c[cell] / walk[cell];
      const double reflectance =
          optics::refract(sea.line[line].refractive_index, 1.0, direction.z).reflectance;
      ASSERT_NEAR(photon.weight / (reflectance * std::exp(walk_tau - tau) * gain), 1,
                  1e-8 * (1 + tau));
      if (end.sea_bed) {
        ASSERT_LE(walk_tau, -std::log(u) * (1 + 1e-12));
      } else {
        ASSERT_NEAR(walk_tau, -std::log(u), 1e-8 * (1 + walk_tau));
      }
    }
  }
  EXPECT_GT(reflected, 20000);
  EXPECT_GT(others, 20000);
  EXPECT_GT(bed, 50);
}

}  // namespace
}  // namespace photic::transport
