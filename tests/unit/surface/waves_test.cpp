// Facets of a rough surface, and whitecaps: what light makes of them, against quadratures that were
// done elsewhere, and against each other.
#include "surface/waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/constants.hpp"
#include "support/random.hpp"
#include "transport/meet_waves.hpp"

namespace photic::surface {
namespace {

constexpr double n = 1.34;

/// Slopes along x of one deviation, along y of another.
WavesView waves_of(double upwind_variance, double crosswind_variance) {
  WavesView w;
  w.upwind_deviation = std::sqrt(upwind_variance);
  w.crosswind_deviation = std::sqrt(crosswind_variance);
  return w;
}
const WavesView five_m_s = waves_of(0.0158, 0.0126);

/// Cox & Munk's of 10 m/s, the wind from 70 degrees.
WavesView skewed() {
  WavesView w = waves_of(0.0316, 0.0222);
  w.upwind_x = std::cos(70 * radian_per_degree), w.upwind_y = std::sin(70 * radian_per_degree);
  w.series = {.c21 = -0.076, .c03 = -0.29, .c40 = 0.4, .c22 = 0.12, .c04 = 0.23};
  return w;
}

Vec3<double> down(double degrees, double azimuth = 0) {
  const double t = degrees * radian_per_degree, a = azimuth * radian_per_degree;
  return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), -std::cos(t)};
}
Vec3<double> up(double degrees, double azimuth = 0) {
  const Vec3<double> d = down(degrees, azimuth);
  return {d.x, d.y, -d.z};
}

/// Mean of f(facet, visibility) over slopes where light sees them, by a sum over 8 deviations.
template <class F>
double mean_over_facets(const WavesView& waves, const Vec3<double>& direction, F f) {
  constexpr int steps = 1400;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const auto at = [&](int j) { return 16 * ((j + 0.5) / steps - 0.5); };
      const Slope<double> slope{at(i) * waves.upwind_deviation, at(k) * waves.crosswind_deviation};
      const auto facet = facet_of(waves, slope);
      const double v = visibility(direction, facet);
      if (v > 0) sum += slope_density(waves, slope) * v * f(facet);
    }
  const double step = 16.0 / steps;
  return sum * step * step * waves.upwind_deviation * waves.crosswind_deviation;
}

struct Row {
  double degrees, from_above, wrong_side, from_below;
};
// Of light along the wind, reflected by single facets (mean over slopes, 1401 x 1401 points).
TEST(Facets, ReflectWhatQuadraturesSay) {
  for (const Row& row : {Row{0, .02113, 0, .02118},
                         {30, .02278, 1.2e-7, .03902},
                         {45, .03078, 3.9e-5, .38449},
                         {60, .06599, 2.2e-3, .95125},
                         {70, .13515, 1.3e-2, .99923},
                         {80, .27509, 3.3e-2, 1.02598}}) {
    const auto above = down(row.degrees), below = up(row.degrees);
    EXPECT_NEAR(mean_over_facets(
                    five_m_s, above,
                    [&](const auto& f) { return meet_facet({}, 1.0, n, above, f).reflectance; }),
                row.from_above, 1.1e-5)
        << row.degrees;
    EXPECT_NEAR(mean_over_facets(
                    five_m_s, below,
                    [&](const auto& f) { return meet_facet({}, n, 1.0, below, f).reflectance; }),
                row.from_below, 1.1e-5)
        << row.degrees;
    EXPECT_NEAR(mean_over_facets(five_m_s, above,
                                 [&](const auto& f) {
                                   const auto at = meet_facet({}, 1.0, n, above, f);
                                   return at.reflected.z < 0 ? at.reflectance : 0.0;
                                 }),
                row.wrong_side, 0.05 * row.wrong_side + 1e-9)
        << row.degrees;
  }
}

// Light meets 1 + Smith's function times the facets that there are.
TEST(Facets, AreMetAsOftenAsSmithSays) {
  const WavesView ten = waves_of(0.0316, 0.0222);
  for (const auto& [degrees, five, stronger] : {std::tuple(60.0, 9.5e-8, 4.8e-5),
                                                {65.0, 6.7e-6, 5.2e-4},
                                                {70.0, 1.9e-4, 3.7e-3},
                                                {75.0, 2.8e-3, 0.019},
                                                {80.0, 0.026, 0.085}}) {
    EXPECT_NEAR(smith(five_m_s, down(degrees)), five, 0.03 * five + 3e-8) << degrees;
    EXPECT_NEAR(smith(ten, up(degrees)), stronger, 0.03 * stronger) << degrees;
    EXPECT_NEAR(mean_over_facets(five_m_s, down(degrees, 30), [](const auto&) { return 1.0; }),
                1 + smith(five_m_s, down(degrees, 30)), 2e-7)
        << degrees;
  }
}

// A facet sends light where the laws of reflection and of refraction say, by Fresnel's share.
TEST(Facets, ObeySnell) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const auto in = down(60 * random.uniform(), 360 * random.uniform());
    const auto facet =
        facet_of(skewed(), Slope<double>{random.uniform() - 0.5, random.uniform() - 0.5});
    if (dot(in, facet.normal) >= 0) continue;
    const auto at = meet_facet({}, 1.0, n, in, facet);
    EXPECT_NEAR(length(at.transmitted), 1, 1e-12);
    const auto tangential = cross(n * at.transmitted - in, facet.normal);
    EXPECT_NEAR(length(tangential), 0, 1e-12);
    EXPECT_LT(dot(at.transmitted, facet.normal), 0);
    EXPECT_NEAR(length(cross(at.reflected - in, facet.normal)), 0, 1e-12);
    EXPECT_NEAR(dot(at.reflected, facet.normal), -dot(in, facet.normal), 1e-12);
  }
}

// Facets steep towards the wind: 70 degrees is where it comes from, and a facet that rises that way
// leans away from it.
TEST(Facets, RiseTowardsTheWind) {
  const auto facet = facet_of(skewed(), Slope<double>{0.2, 0});
  EXPECT_LT(facet.normal.y, -0.1);
  const auto back = slope_across(skewed(), -facet.normal);
  EXPECT_NEAR(back.upwind, 0.2, 1e-12);
  EXPECT_NEAR(back.crosswind, 0, 1e-12);
}

/// Integral of density(k2) f(k2) over all directions of a side, by Simpson-like sums in angle.
template <class Density>
double integral(Density density, double side) {
  constexpr int steps = 800;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double t = pi / 2 * (i + 0.5) / steps, a = 2 * pi * (k + 0.5) / steps;
      const Vec3<double> d{std::sin(t) * std::cos(a), std::sin(t) * std::sin(a),
                           side * std::cos(t)};
      sum += density(d) * std::sin(t) * (1 + d.x + 2 * d.y * d.y);
    }
  return sum * (pi / 2 / steps) * (2 * pi / steps);
}

// The densities of directions are those of facets that are drawn: the same means. Seen red: with
// the cosine of the arriving light in place of the leaving one's.
TEST(Facets, DensityOfDirectionsIsThatOfDrawnFacets) {
  const WavesView waves = skewed();
  const auto weight = [](const Vec3<double>& d) { return 1 + d.x + 2 * d.y * d.y; };
  for (const auto& in : {down(20, 10), down(50, 200), up(15, 80), up(40, 300)}) {
    const bool above = in.z < 0;
    const double n1 = above ? 1 : n, n2 = above ? n : 1;
    const double through = integral(
        [&](const auto& d) {
          const auto by = transmitting(waves, {}, n1, n2, in, d);
          return by.per_density * slope_density(waves, by.slope);
        },
        above ? -1 : 1);
    const double drawn_through = mean_over_facets(waves, in, [&](const auto& f) {
      const auto at = meet_facet({}, n1, n2, in, f);
      const bool right = (at.transmitted.z < 0) == above;
      return right ? (1 - at.reflectance) * weight(at.transmitted) : 0.0;
    });
    EXPECT_NEAR(through, drawn_through, 2e-4 * drawn_through);
    const double back = integral(
        [&](const auto& d) {
          const auto by = reflecting(waves, {}, n1, n2, in, d);
          return by.per_density * slope_density(waves, by.slope);
        },
        above ? 1 : -1);
    const double drawn_back = mean_over_facets(waves, in, [&](const auto& f) {
      const auto at = meet_facet({}, n1, n2, in, f);
      const bool right = (at.reflected.z > 0) == above;
      return right ? at.reflectance * weight(at.reflected) : 0.0;
    });
    EXPECT_NEAR(back, drawn_back, 5e-4 * drawn_back);
  }
}

/// With whitecaps on a tenth of it.
RoughSurface<double> foamy(const WavesView& waves) {
  static WavesView with;
  with = waves;
  with.whitecap_fraction = 0.1;
  return {with, n, {0.1, 0.22, 1 - (1 - 0.22) / (n * n)}};
}

// Light that goes the same way back meets the same surface: rho12 / (n2^2 |cos 2|) is rho21 / (n1^2
// |cos 1|), facets and whitecaps alike. From below a whitecap reflects 0.566.
TEST(RoughSurface, IsReciprocal) {
  const auto surface = foamy(skewed());
  EXPECT_NEAR(foamy(skewed()).white.from_below, 0.566, 5e-4);
  test::Random random(1);
  int lit = 0;
  for (int i = 0; i < 500; ++i) {
    const auto air = down(80 * random.uniform(), 360 * random.uniform());
    const auto other_outside = up(80 * random.uniform(), 360 * random.uniform());
    const auto water = down(45 * random.uniform(), 360 * random.uniform());
    const double in = surface.density(true, false, air, water) / (n * n * -water.z);
    const double out = surface.density(false, false, -water, -air) / -air.z;
    EXPECT_NEAR(in, out, 1e-12 * in);
    const double there = surface.density(true, true, air, other_outside) / other_outside.z;
    const double back = surface.density(true, true, -other_outside, -air) / -air.z;
    EXPECT_NEAR(there, back, 1e-12 * there);
    const double below = surface.density(false, true, -water, down(20)) / -down(20).z;
    const double below_back = surface.density(false, true, up(20), water) / -water.z;
    // from -water to down(20) reversed is from -down(20) to water
    const double reversed = surface.density(false, true, -down(20), water) / -water.z;
    EXPECT_NEAR(below, reversed, 1e-12 * below);
    EXPECT_GE(below_back, 0);
    lit += in > 0.01;
  }
  EXPECT_GT(lit, 50);
}

// However often light meets facets, none is lost and none is gained in the mean, but for what it
// gains where it comes in flat.
TEST(RoughSurface, KeepsLightInTheMean) {
  const auto surface = foamy(skewed());
  test::Random random(1);
  for (const auto& in : {down(10), down(60, 40), up(30), up(70, 100)}) {
    constexpr int photons = 200'000;
    double sum = 0, squares = 0;
    for (int i = 0; i < photons; ++i) {
      transport::Photon<double> photon;
      photon.direction = in;
      transport::AtWaves<double> at{true, in.z < 0};
      double escaped = 0, left = 0;
      for (int facet = 0; at.meets && facet < 64; ++facet) {
        const auto met = transport::meet_waves(
            surface, photon, at,
            {random.uniform(), random.uniform(), random.uniform(), random.uniform()}, true);
        escaped += met.escaped;
        if (met.in_water) left = photon.weight;
      }
      sum += escaped + left;
      squares += (escaped + left) * (escaped + left);
    }
    const double mean = sum / photons;
    const double error = std::sqrt((squares / photons - mean * mean) / photons);
    const double expected = 1 + 0.9 * smith(surface.waves, in);  // facets are nine tenths of it
    EXPECT_NEAR(mean, expected, 4 * error + 1e-6);
    EXPECT_LT(error, 0.01);
  }
}

}  // namespace
}  // namespace photic::surface
