// What the sea bed makes of light: one law for photons and for both kinds of walks.
#include "surface/lambert.hpp"

#include <gtest/gtest.h>

#include "core/constants.hpp"
#include "estimator/bidirectional/depart.hpp"
#include "support/chi_squared.hpp"
#include "support/random.hpp"
#include "transport/collide.hpp"
#include "transport/flight.hpp"
#include "transport/scatter.hpp"
#include "transport/touched.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

constexpr std::size_t angles = 257;

/// A smooth albedo.
double albedo_at(double cosine) { return 0.2 + 0.5 * (1 - cosine) * (1 - cosine); }
/// A straight line over a step of s = sqrt(1 - cos) is off by an eighth of its square times the
/// second derivative, 6 s^2.
constexpr double straight_lines = 6.0 / 8 / ((angles - 1) * (angles - 1));
/// At even steps of sqrt(1 - cos) for the first line; nine and eight tenths of it for others.
std::vector<double> albedos() {
  std::vector<double> out;
  for (const double share : {1.0, 0.9, 0.8}) {
    for (std::size_t k = 0; k < angles; ++k) {
      const double s = static_cast<double>(k) / (angles - 1);
      out.push_back(share * albedo_at(1 - s * s));
    }
  }
  return out;
}

/// Cells of equal probability in the squared sine and in the azimuth.
struct Counts {
  std::vector<double> by_sine = std::vector<double>(20), by_azimuth = std::vector<double>(12);
  double samples = 0;

  void add(const V& direction) {
    ASSERT_GT(direction.z, 0);
    const double squared = 1 - direction.z * direction.z;
    by_sine[std::min<std::size_t>(19, static_cast<std::size_t>(20 * squared))] += 1;
    const double turns = std::atan2(direction.y, direction.x) / (2 * pi) + 0.5;
    by_azimuth[std::min<std::size_t>(11, static_cast<std::size_t>(12 * turns))] += 1;
    samples += 1;
  }
  void judge() const {
    test::expect_chi_squared(by_sine, std::vector<double>(20, 1.0 / 20), samples, 1e-3, "sine");
    test::expect_chi_squared(by_azimuth, std::vector<double>(12, 1.0 / 12), samples, 1e-3,
                             "azimuth");
  }
};

Photon<double> photon_on_bed(const Sea& sea, Random& random) {
  Photon<double> photon;
  photon.direction = random.direction();
  if (photon.direction.z > 0) photon.direction.z = -photon.direction.z;
  photon.position = {0, 0, -30};
  photon.weight = 0.7;
  photon.analog_weight = 0.6;
  photon.layer = sea.layers();
  return photon;
}

// Seen red: with the table of the line before.
TEST(SeaBed, KnowsItsAlbedoAtEveryAngle) {
  const Sea sea = make_sea(30, albedos());
  const auto view = sea.view();
  for (double cosine = 0; cosine <= 1; cosine += 1.0 / 64)
    for (const std::int32_t line : {0, 1, 2})
      EXPECT_NEAR(surface::bed_albedo<double>(view, line, 3, cosine),
                  (1 - 0.1 * line) * albedo_at(cosine), straight_lines);
  const Sea constant = make_sea(30, {0.1, 0.2, 0.3});
  EXPECT_EQ(surface::bed_albedo<double>(constant.view(), 2, 3, 0.4), 0.3);
}

// Seen red: with even directions for even sines squared.
TEST(SeaBed, SendsPhotonsOutAsLambertSays) {
  Random random(77);
  const Sea sea = make_sea(30, albedos());
  const auto view = sea.view();
  Counts counts;
  for (int i = 0; i < 20000; ++i) {
    Photon<double> photon = photon_on_bed(sea, random);
    const V old = photon.direction;
    const auto branch = collide<double>(view, photon, 0, 0.3, random.uniform(), random.uniform());
    ASSERT_NEAR(photon.weight, 0.7 * albedo_at(-old.z), straight_lines) << "nothing is converted";
    ASSERT_EQ(photon.order, 1);
    const Targets<double, 1> none{};
    const V fresh = turned(deflect<double>(view, photon.layer, old, branch.phase, branch.lobe, none,
                                           0.0, {random.uniform(), random.uniform(), 0.5, 0.5}));
    counts.add(fresh);
    ASSERT_NEAR(scattered_density<double>(view, photon.layer, branch.phase, old, fresh),
                fresh.z / pi, 1e-15);
  }
  counts.judge();
}

// Towards a telescope, as often as in the water; what is drawn too often weighs less. Seen red:
// with the phase function's density for the bed's.
TEST(SeaBed, SendsPhotonsTowardsTargets) {
  Random random(79);
  const Sea sea = make_sea(30, albedos());
  const auto view = sea.view();
  constexpr int samples = 200000;
  constexpr double directed = 0.5;
  Targets<double, 1> targets{};
  targets.add(normalised(V{0.5, 0.2, 1}), 0.0, 1.0);
  const std::int32_t phase = sea.elastic_phase[1];
  double sum = 0, squares = 0, of_cosine = 0, squares_of_cosine = 0;
  int towards = 0;
  for (int i = 0; i < samples; ++i) {
    const V old = photon_on_bed(sea, random).direction;
    const V fresh = turned(
        deflect<double>(view, sea.layers(), old, phase, phase, targets, directed,
                        {random.uniform(), random.uniform(), random.uniform(), random.uniform()}));
    const double weight =
        true_over_drawn<double>(view, sea.layers(), old, fresh, phase, phase, targets, directed);
    ASSERT_LE(weight, 1 / (1 - directed) + 1e-12);
    if (fresh.z < 0) {
      ASSERT_EQ(weight, 0);
    }
    towards += one_minus_cos(targets.direction[0], fresh) < 0.1 ? 1 : 0;
    sum += weight, squares += weight * weight;
    of_cosine += weight * fresh.z, squares_of_cosine += weight * fresh.z * (weight * fresh.z);
  }
  const auto error = [](double s, double s2) {
    return std::sqrt((s2 / samples - s * s / samples / samples) / samples);
  };
  EXPECT_NEAR(sum / samples, 1, 4 * error(sum, squares));
  EXPECT_NEAR(of_cosine / samples, 2.0 / 3, 4 * error(of_cosine, squares_of_cosine));
  EXPECT_GT(towards, 0.3 * samples);
}

// A walk from a telescope draws the direction from which light comes, and takes its albedo. Seen
// red: with the angle on the telescope's side.
TEST(SeaBed, SendsWalksOutAsLambertSays) {
  Random random(78);
  const Sea sea = make_sea(30, albedos());
  const estimator::InverseConversion<double> inverse{0.3, 0.6, normalised(V{0.3, -0.2, -1}), 1,
                                                     0.4};
  for (const bool from_telescope : {false, true}) {
    Counts counts;
    for (int i = 0; i < 20000; ++i) {
      Photon<double> photon = photon_on_bed(sea, random);
      const V old = photon.direction;
      const auto departure = estimator::depart(
          sea.view(), photon, inverse,
          {random.uniform(), random.uniform(), random.uniform(), random.uniform()}, from_telescope);
      const double cosine = from_telescope ? photon.direction.z : -old.z;
      ASSERT_NEAR(photon.weight, 0.7 * albedo_at(cosine), straight_lines);
      ASSERT_NEAR(photon.analog_weight, 0.6 * albedo_at(cosine), straight_lines);
      ASSERT_NEAR(departure.p, photon.direction.z / pi, 1e-15);
      ASSERT_EQ(departure.chance, 1);
      ASSERT_EQ(departure.reverse_chance, 1);
      ASSERT_EQ(photon.layer, sea.layers() - 1) << "it goes on in the water";
      counts.add(photon.direction);
    }
    counts.judge();
  }
}

// Seen red: with the bed as the last layer.
TEST(SeaBed, EndsFlightsThatReachIt) {
  const Sea sea = make_sea(30, albedos()), black = make_sea(30);
  for (const Sea* each : {&sea, &black}) {
    const bool reflects = each == &sea;
    const auto view = each->view();
    Photon<double> photon = photon_at(*each, {0, 0, -20});
    photon.direction = normalised(V{0.3, 0, -1});
    const Photon<double> before = photon;
    const auto end = fly(view, photon, 100.0);
    EXPECT_DOUBLE_EQ(photon.position.z, -30);
    EXPECT_EQ(end.sea_bed, !reflects);
    EXPECT_FALSE(end.surface);
    EXPECT_EQ(photon.layer, reflects ? 3 : 2);
    EXPECT_EQ(touched_at<double>(view, photon.layer, 0),
              reflects ? static_cast<std::int32_t>(Touched::bed) : 0);
    const double length = 10 / -photon.direction.z;
    EXPECT_NEAR(photon.weight, before.weight * std::exp(-(0.1 - 0.07) * length), 1e-12);
    EXPECT_NEAR(photon.path, length * each->line[0].group_index, 1e-12);
    Photon<double> high = photon_at(*each, {0, 0, -20});
    fly(view, high, 0.01);
    EXPECT_EQ(high.layer, 2);
  }
}

}  // namespace
}  // namespace photic::transport
