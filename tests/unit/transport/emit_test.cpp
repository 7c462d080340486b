// The laser's light, from the disc into the water.
#include "transport/emit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/chi_squared.hpp"
#include "support/random.hpp"
#include "transport/cross.hpp"
#include "unit/transport/enter_water.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

constexpr int samples = 200000;

scene::Source laser(double half_divergence_mrad, const V& direction = {0, 0, -1}) {
  scene::Source source;
  source.wavelength_nm = 532;
  source.position_m = {1, -2, 12};
  source.direction = direction;
  source.diameter_m = 0.04;
  source.half_divergence_mrad = half_divergence_mrad;
  return source;
}

/// Counts in ten rings of equal measure times eight sectors about an axis.
class Rings {
 public:
  explicit Rings(const V& axis)
      : x_(normalised(cross(axis, std::abs(axis.z) < 0.9 ? V{0, 0, 1} : V{1, 0, 0}))),
        y_(cross(axis, x_)) {}
  void add(double share, const V& aside) {
    const double azimuth = std::atan2(dot(aside, y_), dot(aside, x_));
    const auto ring = std::min<std::size_t>(9, static_cast<std::size_t>(share * 10));
    const auto sector =
        std::min<std::size_t>(7, static_cast<std::size_t>((azimuth + pi) / (2 * pi) * 8));
    count[ring * 8 + sector] += 1;
  }
  std::vector<double> count = std::vector<double>(80, 0.0);

 private:
  V x_, y_;
};

const std::vector<V> axes{{0, 0, -1}, {0.3, 0.4, -0.8}, {3, -2, -0.1}};

// Directions uniform in solid angle within the half divergence; each at 0.1 %. Seen red: with the
// full for the half divergence; with the root of the uniform; with the azimuth over half a turn.
TEST(Emit, FillsTheConeUniformly) {
  Random random(81);
  for (const double mrad : {5.0, 800.0}) {
    for (const V& direction : axes) {
      const auto source = laser(mrad, direction);
      const auto disc = instrument::make_laser<double>(source);
      const V axis = normalised(direction);
      const double edge = std::cos(mrad * 1e-3);
      Rings rings(axis);
      for (int i = 0; i < samples; ++i) {
        const auto photon = emit(disc, 0, random.uniform(), random.uniform());
        ASSERT_NEAR(length(photon.direction), 1, 1e-15);
        const double share = one_minus_cos(axis, photon.direction) / (1 - edge);
        ASSERT_LE(share, 1 + 1e-9);
        rings.add(share, photon.direction);
      }
      test::expect_uniform(rings.count, samples, 0.001, "directions");
    }
  }
}

// Where the axis meets the sea, but for grazing light; on the disc in the water. Seen red: without
// the limit; with the height for the distance.
TEST(Emit, StartsWhereTheAxisMeetsTheSea) {
  const auto start = [](const V& position, const V& direction) {
    auto source = laser(5, direction);
    source.position_m = position;
    const auto disc = instrument::make_laser<double>(source);
    EXPECT_LT(length(source.position_m + disc.ahead * disc.axis - disc.start), 1e-9);
    return disc.start;
  };
  EXPECT_LT(length(start({1, -2, 12}, {0, 0, -1}) - V{1, -2, 0}), 1e-12);
  EXPECT_LT(length(start({1, -2, 12}, {3, 0, -4}) - V{10, -2, 0}), 1e-12);
  EXPECT_NEAR(start({1, -2, 12}, {1, 0, -1e-9}).x, 121, 1e-9);
  EXPECT_EQ(start({1, -2, -3}, {3, 0, -4}), (V{1, -2, -3}));
}

// Seen red: with the vertex at half its distance; with the diameter for the radius.
TEST(Emit, HasTheConesVertexBehindTheDisc) {
  EXPECT_NEAR(instrument::make_laser<double>(laser(5)).vertex_distance, 4.00,
              1e-3);  // Table 1: 0.02 m / tan 5 mrad
  Random random(82);
  for (const V& direction : axes) {
    for (const double mrad : {5.0, 800.0}) {
      const auto source = laser(mrad, direction);
      const auto disc = instrument::make_laser<double>(source);
      const V axis = normalised(direction);
      const double distance = 0.02 / std::tan(mrad * 1e-3);
      const V vertex = source.position_m - distance * axis;
      double widest = 0;
      for (int i = 0; i < 10000; ++i) {
        const auto photon = emit(disc, 0, random.uniform(), random.uniform());
        const V from_vertex = photon.position - vertex;
        ASSERT_LT(length(normalised(from_vertex) - photon.direction), 1e-12);
        const double from_disc = disc.ahead + photon.path;
        const V on_disc = photon.position - from_disc * photon.direction - source.position_m;
        ASSERT_NEAR(dot(on_disc, axis), 0, 1e-14 * (1 + from_disc));  // it has come so far
        widest = std::max(widest, length(on_disc));
        ASSERT_EQ(photon.weight, 1);
      }
      EXPECT_LE(widest, 0.02 * (1 + 1e-12));
      EXPECT_GT(widest, 0.0199);
    }
  }
}

// Seen red: with the radius proportional to the uniform.
TEST(Emit, FillsTheDiscOfACollimatedLaserUniformly) {
  Random random(83);
  for (const V& direction : axes) {
    const auto source = laser(0, direction);
    const auto disc = instrument::make_laser<double>(source);
    const V axis = normalised(direction);
    Rings rings(axis);
    for (int i = 0; i < samples; ++i) {
      const auto photon = emit(disc, 0, random.uniform(), random.uniform());
      ASSERT_EQ(photon.direction, disc.axis);
      ASSERT_EQ(photon.path, 0);
      const V on_disc = photon.position - disc.ahead * axis - source.position_m;
      ASSERT_NEAR(dot(on_disc, axis), 0, 1e-14);
      rings.add(dot(on_disc, on_disc) / (0.02 * 0.02), on_disc);
    }
    test::expect_uniform(rings.count, samples, 0.001, "positions");
  }
}

/// The counts of a Gaussian's light in rings between these angles, over that of 1/e2, times eight
/// sectors; each at 0.1 %. The last ring ends at the cut, three times that angle.
void expect_gaussian(const std::vector<double>& off_axis, const std::vector<V>& aside,
                     const char* what) {
  const std::vector<double> rims{0, 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.5, 1.8, 3.0001};
  std::vector<double> count((rims.size() - 1) * 8), probability;
  for (std::size_t i = 0; i < off_axis.size(); ++i) {
    const auto ring = std::ranges::upper_bound(rims, off_axis[i]) - rims.begin() - 1;
    const auto sector =
        std::min(7, static_cast<int>((std::atan2(aside[i].y, aside[i].x) + pi) / (2 * pi) * 8));
    ASSERT_LT(off_axis[i], 3.0001);
    count[static_cast<std::size_t>(ring * 8 + sector)] += 1;
  }
  const auto beyond = [](double k) { return std::exp(-2 * k * k); };
  for (std::size_t k = 0; k + 1 < rims.size(); ++k)
    for (int sector = 0; sector < 8; ++sector)
      probability.push_back((beyond(rims[k]) - (k + 2 < rims.size() ? beyond(rims[k + 1]) : 0)) /
                            8);
  test::expect_chi_squared(count, probability, static_cast<double>(off_axis.size()), 0.001, what);
}

// The same of rays and of their places on the disc. Seen red: with an even disc; with the half
// divergence at 1/e of the peak.
TEST(Emit, FillsAGaussianBeam) {
  Random random(84);
  for (const double mrad : {5.0, 0.0}) {
    auto source = laser(mrad);
    source.profile = scene::SourceProfile::gaussian;
    const auto beam = instrument::make_laser<double>(source);
    std::vector<double> angles, radii;
    std::vector<V> directions, places;
    for (int i = 0; i < samples; ++i) {
      const auto photon = emit(beam, 0, random.uniform(), random.uniform());
      const V on_disc =
          photon.position - (beam.ahead + photon.path) * photon.direction - source.position_m;
      ASSERT_NEAR(on_disc.z, 0, 1e-12);
      radii.push_back(length(on_disc) / 0.02);
      places.push_back(on_disc);
      angles.push_back(std::hypot(photon.direction.x, photon.direction.y) / (mrad * 1e-3));
      directions.push_back(photon.direction);
    }
    expect_gaussian(radii, places, "places on the disc");
    if (mrad > 0) expect_gaussian(angles, directions, "directions");
  }
}

// Seen red: with n on the wrong side; with the path times the index; without the loss.
TEST(EnterWater, ObeysSnellAndFresnel) {
  const auto sea = make_sea(40);
  for (const double degrees : {0.0, 10.0, 30.0, 60.0, 85.0}) {
    const double air = degrees * radian_per_degree;
    const double water = std::asin(std::sin(air) / 1.3415);
    Photon<double> photon;
    photon.position = {1, 2, 12};
    photon.direction = {0, std::sin(air), -std::cos(air)};
    ASSERT_TRUE(test::enter_water(sea.view(), {true, 0}, photon));
    EXPECT_EQ(photon.position.z, 0);
    EXPECT_EQ(photon.position.x, 1);
    EXPECT_NEAR(photon.position.y, 2 + 12 * std::tan(air), 1e-12);
    EXPECT_NEAR(photon.direction.y, std::sin(water), 1e-15);
    EXPECT_NEAR(photon.direction.z, -std::cos(water), 1e-15);
    EXPECT_NEAR(photon.path, 12 / std::cos(air), 1e-12);
    const double s = degrees > 0 ? std::sin(air - water) / std::sin(air + water) : 0.3415 / 2.3415;
    const double p = degrees > 0 ? std::tan(air - water) / std::tan(air + water) : 0.3415 / 2.3415;
    EXPECT_NEAR(photon.weight, 1 - (s * s + p * p) / 2, 1e-12) << degrees;
  }
}

TEST(EnterWater, LeavesLightThatFliesAwayAsItIs) {
  const auto sea = make_sea(40);
  for (const V& direction : {V{1, 0, 0}, V{0, 0, 1}, normalised(V{1, 1, 0.1})}) {
    Photon<double> photon;
    photon.position = {1, 2, 12};
    photon.direction = direction;
    EXPECT_FALSE(test::enter_water(sea.view(), {true, 0}, photon));
    EXPECT_EQ(photon.position, (V{1, 2, 12}));
    EXPECT_EQ(photon.direction, direction);
    EXPECT_EQ(photon.weight, 1);
    EXPECT_EQ(photon.path, 0);
  }
}

}  // namespace
}  // namespace photic::transport
