// What walks that are to be connected do at a vertex.
#include "estimator/bidirectional/depart.hpp"

#include <gtest/gtest.h>

#include "support/chi_squared.hpp"
#include "support/random.hpp"
#include "unit/transport/sea.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::transport {
namespace {

using test::Random;
using V = Vec3<double>;

constexpr std::int32_t henyey_greenstein = 1;  // of the tables of make_sea()

estimator::InverseConversion<double> inverse_conversion() {
  return {0.3, 0.6, normalised(V{0.3, -0.2, -1}), henyey_greenstein, 0};
}

Photon<double> photon_in(std::int32_t line, std::int32_t layer, Random& random) {
  Photon<double> photon;
  photon.direction = random.direction();
  photon.line = line;
  photon.layer = layer;
  photon.weight = 0.7;
  photon.analog_weight = 0.6;
  photon.order = 4;
  return photon;
}

estimator::DepartUniforms<double> uniforms(Random& random) {
  return {random.uniform(), random.uniform(), random.uniform(), random.uniform()};
}

/// A value [line][layer].
double of(const std::vector<double>& table, std::int32_t line, std::int32_t layer) {
  return table[static_cast<std::size_t>(line * 3 + layer)];
}

double phase(const Sea& sea, std::int32_t table, const V& a, const V& b) {
  return sea.view().phases.value<double>(one_minus_cos(a, b), table);
}

// Light of the laser's line, and of lines that the layer does not emit. Seen red: with conversions
// where no light is emitted; with the chance of a conversion for its complement.
TEST(Depart, ScattersWhatCannotBeConvertedLight) {
  Random random(401);
  const auto sea = make_sea(40);
  const std::vector<std::pair<std::int32_t, std::int32_t>> line_and_layer{{0, 0}, {0, 1}, {0, 2},
                                                                          {1, 2}, {2, 0}, {2, 2}};
  for (const auto& [line, layer] : line_and_layer) {
    for (int i = 0; i < 1000; ++i) {
      const auto before = photon_in(line, layer, random);
      auto photon = before;
      const auto departure =
          estimator::depart(sea.view(), photon, inverse_conversion(), uniforms(random), true);
      ASSERT_EQ(photon.line, line);
      ASSERT_EQ(photon.order, 5);
      ASSERT_EQ(departure.chance, 1);
      ASSERT_EQ(departure.c_ratio, line == 0 ? 1 : 0);
      ASSERT_NEAR(photon.weight, 0.7 * of(sea.albedo, line, layer), 1e-15);
      ASSERT_NEAR(photon.analog_weight, 0.6 * of(sea.albedo, line, layer), 1e-15);
      const std::int32_t table = sea.elastic_phase[static_cast<std::size_t>(3 * line + layer)];
      ASSERT_NEAR(departure.p / phase(sea, table, before.direction, photon.direction), 1, 1e-5);
    }
  }
}

// Seen red: with no conversions; with the chance of one for its complement; without the laser's c
// in a conversion's coefficient; with the analog weight times the albedo; with p of the angle to
// the beam.
TEST(Depart, TurnsConversionsBackWithItsChance) {
  Random random(402);
  const auto sea = make_sea(40);
  const auto back = inverse_conversion();
  constexpr int samples = 20000;
  const double chance = 0.3 / (1 + 0.3 * 3);  // at the fifth vertex, beyond the first by three
  const std::vector<std::pair<std::int32_t, std::int32_t>> line_and_layer{{1, 0}, {1, 1}, {2, 1}};
  for (const auto& [line, layer] : line_and_layer) {
    std::vector<double> count(2, 0.0);
    for (int i = 0; i < samples; ++i) {
      const auto before = photon_in(line, layer, random);
      auto photon = before;
      const auto departure = estimator::depart(sea.view(), photon, back, uniforms(random), true);
      ASSERT_EQ(photon.order, 5);
      ASSERT_NEAR(length(photon.direction), 1, 1e-14);
      const bool converted = photon.line == 0;
      count[converted ? 1 : 0] += 1;
      if (!converted) {
        ASSERT_EQ(photon.line, line);
        ASSERT_NEAR(departure.chance, 1 - chance, 1e-15);
        ASSERT_EQ(departure.c_ratio, 0);
        ASSERT_NEAR(photon.weight, 0.7 * of(sea.albedo, line, layer), 1e-15);
        ASSERT_NEAR(photon.analog_weight, 0.6 * of(sea.albedo, line, layer), 1e-15);
        continue;
      }
      const auto walk_c = walk_coefficients(sea);
      ASSERT_NEAR(departure.c_ratio, of(walk_c, 0, layer) / of(walk_c, line, layer), 1e-14);
      const double emitted = of(sea.conversion, line, layer) * of(sea.c, 0, layer);
      ASSERT_NEAR(photon.weight, 0.7 * emitted / of(sea.c, line, layer), 1e-16);
      ASSERT_EQ(photon.analog_weight, 0.6);
      const double p = phase(sea, sea.conversion_phase[static_cast<std::size_t>(line)],
                             before.direction, photon.direction);
      ASSERT_NEAR(departure.p / p, 1, 1e-9);
      const double lobe = phase(sea, henyey_greenstein, back.beam, photon.direction);
      ASSERT_NEAR(departure.chance, chance * (0.4 / (4 * pi) + 0.6 * lobe) / p,
                  1e-9 * departure.chance);
    }
    test::expect_chi_squared(count, {1 - chance, chance}, samples, 0.001, "conversions");
  }
}

/// What over_phase() says of how likely directions are between two angles to the beam.
double probability_between(const Sea& sea, const V& old, std::int32_t line, double x0, double x1) {
  constexpr int steps = 64;
  const auto back = inverse_conversion();
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double azimuth = 2 * pi * j / steps;
      const V direction = turned(back.beam, x0 + (x1 - x0) * (i + 0.5) / steps, std::cos(azimuth),
                                 std::sin(azimuth));
      const double p =
          phase(sea, sea.conversion_phase[static_cast<std::size_t>(line)], old, direction);
      sum += p * back.over_phase(sea.view(), direction, p);
    }
  }
  return 2 * pi * (x1 - x0) * sum / (steps * steps);
}

// Chi-squared of cosines to the beam, each line at 0.1 %. Seen red: with
// the shares of the mixture swapped; with the lobe about the walk's direction; with the lobe not
// over p.
TEST(Depart, DrawsConvertedDirectionsAsDenseAsItSays) {
  Random random(403);
  const auto sea = make_sea(40);
  const V old = normalised(V{0.5, 0.1, 1});
  constexpr int samples = 200000;
  for (const std::int32_t line : {1, 2}) {
    std::vector<double> count(40, 0.0), probability;
    const double cell = 2.0 / static_cast<double>(count.size());
    for (std::size_t k = 0; k < count.size(); ++k) {
      const double from = cell * static_cast<double>(k);
      probability.push_back(probability_between(sea, old, line, from, from + cell));
    }
    for (int i = 0; i < samples; ++i) {
      Photon<double> photon;
      photon.direction = old;
      photon.line = line;
      photon.layer = 1;
      estimator::depart(sea.view(), photon, inverse_conversion(),
                        {random.uniform(), random.uniform(), 0, random.uniform()}, true);
      ASSERT_EQ(photon.line, 0);
      const double x = one_minus_cos(inverse_conversion().beam, photon.direction);
      count[static_cast<std::size_t>(x / cell)] += 1;
    }
    double whole = 0;
    for (const double p : probability) whole += p;
    EXPECT_NEAR(whole, 1, 1e-4) << "a density";
    for (double& p : probability) p /= whole;
    test::expect_chi_squared(count, probability, samples, 0.001, "line " + std::to_string(line));
  }
}

estimator::InverseConversion<double> scattering_reversal() {
  estimator::InverseConversion<double> back = inverse_conversion();
  back.scattered = 0.2;
  return back;
}

// Chi-squared of cosines to the beam at 0.1 %, against the phase function times what is said to be
// over it. Seen red: with the lobe's share for the other; with the lobe about the walk's direction;
// with the number used up by the choice of the lobe used again.
TEST(Depart, ScattersTheLasersLightAsDenseAsItSays) {
  Random random(404);
  const auto sea = make_sea(40);
  const auto back = scattering_reversal();
  const V old = normalised(V{0.5, 0.1, 1});
  constexpr int samples = 200000, steps = 400;
  std::vector<double> count(40, 0.0), probability(40, 0.0);
  const double cell = 2.0 / static_cast<double>(count.size());
  const std::int32_t table = sea.elastic_phase[1];
  for (int i = 0; i < 40 * steps; ++i) {
    const double x = 2.0 * (i + 0.5) / (40 * steps);
    for (int j = 0; j < steps; ++j) {
      const double azimuth = 2 * pi * (j + 0.5) / steps;
      const V direction = turned(back.beam, x, std::cos(azimuth), std::sin(azimuth));
      const double p = phase(sea, table, old, direction);
      probability[static_cast<std::size_t>(i / steps)] +=
          p * back.scattered_over_phase(sea.view(), 1, direction, p);
    }
  }
  double whole = 0;
  for (const double p : probability) whole += p;
  EXPECT_NEAR(whole * 2 * pi * 2 / (40.0 * steps * steps), 1, 2e-3) << "a density";
  for (double& p : probability) p /= whole;
  for (int i = 0; i < samples; ++i) {
    Photon<double> photon;
    photon.direction = old;
    photon.layer = 1;
    const auto departure = estimator::depart(sea.view(), photon, back, uniforms(random), true);
    const double p = phase(sea, table, old, photon.direction);
    ASSERT_NEAR(departure.p / p, 1, 1e-5);
    ASSERT_NEAR(departure.chance / back.scattered_over_phase(sea.view(), 1, photon.direction, p), 1,
                1e-4);
    ASSERT_EQ(departure.reverse_chance, 1);
    count[static_cast<std::size_t>(one_minus_cos(back.beam, photon.direction) / cell)] += 1;
  }
  test::expect_chi_squared(count, probability, samples, 0.001, "scattered light");
}

// A walk from the laser draws from the phase function alone, and returns how a telescope's walk
// would find the way that it came. Seen red: with the direction in which it leaves; with the lobe
// drawn.
TEST(Depart, FromTheLaserReturnsHowWalksPassIt) {
  Random random(405);
  const auto sea = make_sea(40);
  const auto back = scattering_reversal();
  for (int i = 0; i < 1000; ++i) {
    const auto before = photon_in(0, 1, random);
    const auto u = uniforms(random);
    auto photon = before, plain = before;
    const auto departure = estimator::depart(sea.view(), photon, back, u, false);
    estimator::depart(sea.view(), plain, inverse_conversion(), u, true);
    ASSERT_EQ(photon.direction, plain.direction);
    ASSERT_EQ(departure.chance, 1);
    const double lobe = phase(sea, henyey_greenstein, back.beam, -before.direction);
    ASSERT_NEAR(departure.reverse_chance / (0.8 + 0.2 * lobe / departure.p), 1, 1e-12);
  }
}

}  // namespace
}  // namespace photic::transport
