// Scores are in proportion to light's contribution, and their weights are of walks' densities
// alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "estimator/bidirectional/connection_end.hpp"
#include "optics/phase_functions.hpp"
#include "support/random.hpp"
#include "unit/transport/sea.hpp"

namespace photic::estimator {
namespace {

using test::Random;
using V = Vec3<double>;

/// The densities of the strategies that draw a path which is connected, each times both p.
std::vector<double> densities_of(double area, double reach, const EndDensities<double>& a,
                                 const EndDensities<double>& b) {
  return {area, reach * a.arriving_edge * b.p, reach * b.arriving_edge * a.p,
          reach * (a.behind + b.behind) * a.p * b.p};
}
std::vector<double> densities_of(const MeetingDensities<double>& at) {
  return {at.here, at.p * at.next, at.p * at.behind};
}
double sum_of(const std::vector<double>& densities) {
  return std::accumulate(densities.begin(), densities.end(), 0.0);
}

// Seen red: with both densities p in the numerator instead of the contribution; with the
// contribution in the sum of the densities instead of both p.
TEST(Balance, OfConnectionsTakesTheContributionApartFromDensities) {
  Random random(91);
  for (int n = 0; n < 100; ++n) {
    const auto end = [&] {
      return EndDensities<double>{random.scale(1e-3, 1e3), random.uniform(), random.uniform()};
    };
    const auto a = end(), b = end();
    const double light = random.scale(1e-3, 1e3), area = random.uniform(), tau = random.uniform(),
                 reach = random.uniform();
    const double score = balance(light, area, tau, reach, a, b);
    EXPECT_EQ(balance(2 * light, area, tau, reach, a, b), 2 * score);
    EXPECT_NEAR(score * sum_of(densities_of(area, reach, a, b)) / (light * std::exp(-tau)), 1,
                1e-12);
  }
}

// Seen red: with p in the numerator instead of the contribution; with the contribution in the sum
// of the densities instead of p.
TEST(Balance, OfMeetingsTakesTheContributionApartFromDensities) {
  Random random(92);
  for (int n = 0; n < 100; ++n) {
    const MeetingDensities<double> at{random.scale(1e-3, 1e3), random.uniform(), random.uniform(),
                                      random.uniform()};
    const double light = random.scale(1e-3, 1e3), tau = random.uniform();
    const double score = balance(light, tau, at);
    EXPECT_EQ(balance(2 * light, tau, at), 2 * score);
    EXPECT_NEAR(score * sum_of(densities_of(at)) / (light * std::exp(-tau)), 1, 1e-12);
  }
}

const transport::Sea sea_with_bed = transport::make_sea(40, {0.3, 0.3, 0.3});
constexpr std::int32_t second_layer = 1, place_of_bed = 3;

Vertex<double> vertex_at(std::int32_t line, std::int32_t place, const V& direction) {
  Vertex<double> v;
  v.position = {0, 0, place == place_of_bed ? -40.0 : -8.0};
  v.direction = direction;
  v.line = line;
  v.layer = place;
  return v;
}

// Seen red: with the phase function of scattering at conversions, that of a conversion where light
// is scattered; with the cosine of the arriving light on the bed.
TEST(Contribution, IsThePhaseFunctionOrLambertsLaw) {
  Random random(93);
  const auto view = sea_with_bed.view();
  for (int n = 0; n < 100; ++n) {
    const V down{0.6, 0, -0.8}, leaving = random.direction();
    const double x = one_minus_cos(down, leaving);
    const double scattered = optics::henyey_greenstein(0.8).p(x),
                 converted = optics::raman_phase(0.17).p(x), of_bed = std::max(leaving.z, 0.0) / pi;
    const auto of = [&](const Interaction<double>& vertex) {
      return contribution(view, vertex, leaving);
    };
    EXPECT_NEAR(of(scattering_at<double>(view, 1, second_layer, down)) / scattered, 1, 1e-4);
    EXPECT_NEAR(of(conversion_at<double>(view, 1, second_layer, down)) / converted, 1, 1e-4);
    EXPECT_NEAR(of(scattering_at<double>(view, 0, place_of_bed, down)), of_bed, 1e-15);
    for (const bool converts : {false, true})
      EXPECT_NEAR(of(interaction_at<double>(view, converts, 1, second_layer, down)) /
                      (converts ? converted : scattered),
                  1, 1e-4);
  }
}

// Seen red: with ends whose contribution is 1, or that of the other kind of vertex.
TEST(ConnectionEnd, HasTheContributionOfItsVertex) {
  Random random(94);
  const auto view = sea_with_bed.view();
  const InverseConversion<double> inverse{0.3, 0.6, {0, 0, -1}, 0, 0.1};
  const Freedom<double> freedom{1, RotationAxis<double>{}};
  for (int n = 0; n < 100; ++n) {
    const V direction = random.direction(), leaving = random.direction();
    const double at_bed = std::max(leaving.z, 0.0) / pi;
    const auto scattering =
        contribution(view, scattering_at<double>(view, 0, second_layer, direction), leaving);
    const auto conversion =
        contribution(view, conversion_at<double>(view, 1, second_layer, direction), leaving);
    const auto expect = [](const ConnectionEnd<double>& end, double of_light) {
      EXPECT_DOUBLE_EQ(end.contribution, of_light);
      EXPECT_DOUBLE_EQ(end.densities.p, density_of(of_light));
    };
    const auto elastic = vertex_at(0, second_layer, direction),
               emitted = vertex_at(1, second_layer, direction),
               on_bed = vertex_at(0, place_of_bed, direction);
    expect(scattering_from_laser(view, elastic, 1.0, leaving, inverse, 1.0, freedom), scattering);
    expect(scattering_from_laser(view, on_bed, 1.0, leaving, inverse, 1.0, freedom), at_bed);
    expect(conversion_from_laser(view, elastic, 1.0, leaving, 1, inverse, 0, 1.0, 1.0, freedom),
           conversion);
    expect(arrival_from_laser(view, elastic, 1.0, leaving, inverse, 0, freedom), scattering);
    expect(arrival_from_laser(view, emitted, 1.0, leaving, inverse, 0, freedom), conversion);
    expect(scattering_of_converted(view, emitted, leaving), scattering);
  }
}

}  // namespace
}  // namespace photic::estimator
