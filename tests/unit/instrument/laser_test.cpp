// The density of the laser's directions, as its light and its walks have it.
#include "instrument/laser.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/constants.hpp"

namespace photic::instrument {
namespace {

scene::Source laser(double half_divergence_mrad, scene::SourceProfile profile) {
  scene::Source source;
  source.position_m = {1, -2, 12};
  source.direction = {0, 0, -1};
  source.diameter_m = 0.04;
  source.half_divergence_mrad = half_divergence_mrad;
  source.profile = profile;
  return source;
}
constexpr auto disc = scene::SourceProfile::disc, gaussian = scene::SourceProfile::gaussian;

double one_minus_cos_of(double angle) { return 2 * std::pow(std::sin(angle / 2), 2); }

/// The share of light within an angle, by the density per steradian.
double light_within(const Laser<double>& of, double angle) {
  constexpr int steps = 20000;
  const double step = one_minus_cos_of(angle) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += step / of.even_within((i + 0.5) * step);
  return sum;
}

// Seen red: with half the exponent; with the cut at 2 t; with the density on the axis everywhere.
TEST(Laser, SendsAllItsLightWithinItsCone) {
  for (const double t : {1e-4, 5e-3, 0.1, 0.52}) {
    EXPECT_NEAR(light_within(make_laser<double>(laser(1e3 * t, disc)), t), 1, 1e-12) << t;
    const auto beam = make_laser<double>(laser(1e3 * t, gaussian));
    EXPECT_NEAR(light_within(beam, 3 * t), 1, 1e-6) << t;
    EXPECT_TRUE(beam.emits(one_minus_cos_of(2.999 * t)));
    EXPECT_FALSE(beam.emits(one_minus_cos_of(3.001 * t)));
    EXPECT_NEAR(beam.even_within(one_minus_cos_of(t)) / beam.even_within(0), std::exp(2), 1e-12);
    EXPECT_EQ(beam.even_within(1.2 * one_minus_cos_of(3 * t)),
              beam.even_within(one_minus_cos_of(3 * t)));
  }
}

// 1 - exp(-2 g^2 / t^2) within g. Seen red: with exp(-theta^2 / t^2).
TEST(Laser, OfANarrowBeamIsAGaussianOfTheAngle) {
  for (const double t : {1e-4, 5e-3}) {
    const auto beam = make_laser<double>(laser(1e3 * t, gaussian));
    EXPECT_NEAR(light_within(beam, t / 2), 0.393469, 1e-5);
    EXPECT_NEAR(light_within(beam, t), 0.864665, 1e-5);
    EXPECT_NEAR(light_within(beam, 2 * t), 0.999665, 1e-5);
    for (const double theta : {0.0, 0.5 * t, t, 2 * t, 2.9 * t}) {
      const double density = 1 / (2 * pi * beam.even_within(one_minus_cos_of(theta)));
      EXPECT_NEAR(density * (pi * t * t / 2) * std::exp(2 * theta * theta / (t * t)), 1, 12 * t * t)
          << theta / t;
    }
  }
}

// The sampler's inverse is the light within an angle. Seen red: with the cut left out of it.
TEST(Laser, DrawsAngleByAngleWhatTheDensityStates) {
  for (const double mrad : {0.1, 100.0, 520.0}) {
    const auto beam = make_laser<double>(laser(mrad, gaussian));
    for (const double u : {1e-9, 1e-3, 0.2, 0.5, 0.9, 1 - 1e-6}) {
      const double x = beam.draw_direction(u);
      EXPECT_NEAR(light_within(beam, 2 * std::asin(std::sqrt(x / 2))), 1 - u, 1e-6) << u;
    }
  }
}

// In float too: no ray is beyond the cut or has no angle. Seen red: with the cut left out.
TEST(Laser, DrawsWithinTheBeamWhateverTheUniform) {
  for (const double mrad : {0.0, 5.0, 520.0}) {
    const auto beam = make_laser<float>(laser(mrad, gaussian));
    const float most = beam.profile.draw(0x1p-32F);
    EXPECT_GT(most, 0.99F);
    EXPECT_LE(most, 1 + 1e-6F);
    for (int i = 1; i <= 4096; ++i) {
      const float share = beam.profile.draw(1 - static_cast<float>(i) * 0x1p-24F);
      ASSERT_GE(share, 0);
      ASSERT_LT(share, 1e-3F);
    }
    EXPECT_GE(beam.profile.draw(1), 0);
  }
}

// Seen red: with half the exponent.
TEST(Laser, OfParallelLightHasTheProfileOnTheDisc) {
  const auto beam = make_laser<double>(laser(0, gaussian));
  EXPECT_EQ(beam.radius, 3 * 0.02);
  EXPECT_NEAR(beam.draw_on_disc(1 - 0.864665), 0.02, 1e-6);
  EXPECT_NEAR(beam.profile.at_edge, std::exp(-18), 1e-20);
}

}  // namespace
}  // namespace photic::instrument
