// Free flight through the layers.
#include "transport/flight.hpp"

#include <gtest/gtest.h>

#include "support/chi_squared.hpp"
#include "support/random.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

Photon<double> photon_from(const medium::Medium& sea, double depth, const V& direction, std::int32_t line = 0) {
  Photon<double> photon;
  photon.position = {0.3, -0.2, -depth};
  photon.direction = direction;
  photon.line = line;
  photon.layer = sea.layer_at(depth);
  photon.path = 7;
  return photon;
}

// Wherever a flight ends, the optical depth of its way is -ln(u), or less where surface or bed stood in the way; the path
// grows by the way times the line's group index. Seen red: with the phase for the group index; with the first layer's c in
// the last; with the layers searched downwards only; with the flight to the surface not ended there.
TEST(Fly, GoesAsFarAsItsOpticalDepth) {
  Random random(61);
  int surface = 0, bed = 0, level = 0, crossed = 0;
  for (const double bottom : {25.0, std::numeric_limits<double>::infinity()}) {
    const auto sea = make_sea(bottom);
    for (int i = 0; i < 50000; ++i) {
      V direction = random.direction();
      if (i % 10 == 0) direction = {0.6, -0.8, 0};
      const auto before = photon_from(sea, random.between(0, 25), direction, random.below(3));
      auto photon = before;
      const double u = random.uniform();
      const auto end = fly(sea.view(), photon, u);
      const V way = photon.position - before.position;
      const double tau = optical_depth_between(sea, photon.line, before.position, photon.position);
      const double group_index = sea.line[static_cast<std::size_t>(photon.line)].group_index;
      ASSERT_LT(length(way - length(way) * direction), 1e-9 * (1 + length(way)));
      ASSERT_NEAR(photon.path, 7 + length(way) * group_index, 1e-9 * photon.path);
      ASSERT_EQ(photon.direction, direction);
      ASSERT_EQ(photon.weight, 1);
      ASSERT_FALSE(end.surface && end.sea_bed);
      if (end.surface || end.sea_bed) {
        ASSERT_LE(tau, -std::log(u) * (1 + 1e-12));
        ASSERT_EQ(-photon.position.z, end.surface ? 0 : bottom);
        ASSERT_EQ(photon.layer, end.surface ? 0 : 2);
      } else {
        ASSERT_NEAR(tau, -std::log(u), 1e-8 * (1 + tau)) << direction.z;
        ASSERT_EQ(photon.layer, sea.layer_at(-photon.position.z));
        ASSERT_LT(photon.position.z, 0);
        ASSERT_GT(photon.position.z, -bottom);
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

const std::vector<Flight> flights{{"straight down", {0, 0, -1}, 1},  {"slanted down", {0.8, 0, -0.6}, 8},
                                  {"straight up", {0, 0, 1}, 20},    {"slanted up", {0, -0.6, 0.8}, 14},
                                  {"level", {0, 1, 0}, 8},           {"nearly level", {0, 1, -1e-12}, 8},
                                  {"up, within the first layer", {0.6, 0, 0.8}, 2}};

/// The optical depth of the first s metres of a flight.
double depth_of_way(const medium::Medium& sea, const Flight& flight, double s) {
  const V start{0, 0, -flight.depth};
  return optical_depth_between(sea, 0, start, start + s * flight.direction);
}

/// The length of a flight to the surface or the bed; as good as endless if level.
double longest_way(const Flight& flight, double bottom) {
  if (flight.direction.z > 0) return flight.depth / flight.direction.z;
  return std::min(100.0, (bottom - flight.depth) / std::max(1e-9, -flight.direction.z));
}

/// The way on which a share 1 - transmitted of the light has collided.
double way_to(const medium::Medium& sea, const Flight& flight, double transmitted, double longest) {
  double low = 0, high = longest;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (std::exp(-depth_of_way(sea, flight, middle)) > transmitted ? low : high) = middle;
  }
  return low;
}

// The law of free paths in three layers: exp(-optical depth), and the rest arrives at the surface or on the bed. In 40 cells
// of equal probability. At 1 % for the family (Bonferroni). Seen red: with u for 1 - u's logarithm doubled; with the layers'
// edges ignored.
TEST(Fly, HasTheFreePathsOfThreeLayers) {
  constexpr int samples = 200000;
  constexpr double bottom = 25;
  constexpr std::size_t cells = 40;
  const auto sea = make_sea(bottom);
  Random random(62);
  for (const Flight& flight : flights) {
    const double longest = longest_way(flight, bottom);
    const double arriving = flight.direction.z > -1e-9 && flight.direction.z <= 0
                                ? 0
                                : std::exp(-depth_of_way(sea, flight, longest * (1 - 1e-15)));
    std::vector<double> edges;
    for (std::size_t k = 1; k < cells; ++k) {
      edges.push_back(way_to(sea, flight, 1 - (1 - arriving) * static_cast<double>(k) / cells, longest));
    }
    std::vector<double> count(cells, 0.0);
    for (int i = 0; i < samples; ++i) {
      auto photon = photon_from(sea, flight.depth, flight.direction);
      const V start = photon.position;
      const auto end = fly(sea.view(), photon, random.uniform());
      if (end.surface || end.sea_bed) continue;
      const double way = length(photon.position - start);
      count[static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), way) - edges.begin())] += 1;
    }
    const std::vector<double> probability(cells, (1 - arriving) / cells);
    test::expect_chi_squared(count, probability, samples, 0.01 / static_cast<double>(flights.size()), flight.what);
  }
}

// Seen red: with the reflectance of the other side (no total reflection); with the direction left as it is; with the weight
// times the transmittance.
TEST(ReflectDown, KeepsTheReflectedShare) {
  const auto sea = make_sea(25);
  const double n = 1.3415;
  for (const double degrees : {0.0, 20.0, 40.0, 48.0, 48.3, 60.0, 89.0}) {
    const double angle = degrees * radian_per_degree;
    auto photon = photon_from(sea, 0, {std::sin(angle), 0, std::cos(angle)});
    photon.weight = 0.8;
    photon.analog_weight = 0.5;
    const double leaving = reflect_down(sea.view(), photon);
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
  EXPECT_NEAR(1 - reflect_down(sea.view(), straight), std::pow((n - 1) / (n + 1), 2), 1e-15);
}

}  // namespace
}  // namespace photic::transport
