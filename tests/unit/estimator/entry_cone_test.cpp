// The directions in which walks begin.
#include "estimator/entry_cone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimator/bidirectional/birth.hpp"
#include "instrument/laser.hpp"
#include "unit/estimator/lidars.hpp"
#include "unit/transport/sea.hpp"

namespace photic::estimator {
namespace {

/// Of equally spaced uniforms, as many as are drawn in a cone.
constexpr int draws = 100000;

// Each cone gets its share, and what the wider ones lay into it: evenly, as much as the density
// says. Seen red: with the shares of two cones changed for each other; with the solid angle of the
// ring beyond.
TEST(EntryCone, GivesNarrowerConesTheirShares) {
  const auto sea = transport::make_sea(40);
  const V down{0, 0, -1}, aside{0.3, 0.2, -1}, in_air{0, 0, 10}, in_water{0, 0, -4};
  const std::vector<InnerCone> inner{{0.3, 0.5}, {0.02, 0.2}};
  for (const auto& [place, direction] :
       {std::pair{in_air, down}, {in_air, aside}, {in_water, down}}) {
    for (const bool free : {true, false}) {
      const auto telescope = telescope_at(place, direction);
      const auto cone =
          free ? entry_cone(telescope, sea, 40, inner) : cone_of_own_rays(telescope, sea, inner);
      ASSERT_EQ(cone.rings, 3U);
      const double widest = cone.one_minus_cos();
      for (std::size_t k = 0; k < cone.rings; ++k) {
        const double x = cone.ring[k].one_minus_cos;
        const double from_wider = 0.3 * x / widest,
                     from_wide = 0.5 * std::min(1.0, x / cone.ring[1].one_minus_cos);
        int within = 0;
        for (int i = 0; i < draws; ++i) within += cone.draw((i + 0.5) / draws) < x;
        EXPECT_NEAR(within, draws * (from_wider + from_wide + 0.2), 2);
        const double inner_x = k > 0 ? cone.ring[k - 1].one_minus_cos : 0;
        const double in_ring = 2 * pi * (x - inner_x) / cone.solid_angle_at((x + inner_x) / 2);
        EXPECT_NEAR(in_ring, cone.ring[k].up_to - (k > 0 ? cone.ring[k - 1].up_to : 0), 1e-12);
      }
      EXPECT_NEAR(cone.draw(1), widest, 1e-12);
    }
  }
}

// Weights are what the laser sends in a direction over what is drawn: bounded within its beam,
// which its rings hold out to the cut, and 1 as a mean. Seen red: with the rings of an even cone;
// with rings out to the half divergence; with the density on the axis everywhere.
TEST(EntryCone, FollowsAGaussianBeamOutToItsWings) {
  const auto sea = transport::make_sea(40);
  for (const V& place : {V{0, 0, 10}, V{0, 0, -4}}) {
    auto source = laser_at(place, {0.1, 0, -1});
    source.half_divergence_mrad = 5;
    source.profile = scene::SourceProfile::gaussian;
    const auto laser = instrument::make_laser<double>(source);
    const auto cone = cone_of_own_rays(source, sea);
    ASSERT_EQ(cone.rings, 8U);
    EXPECT_EQ(cone.one_minus_cos(), laser.one_minus_cos_divergence);
    EXPECT_NEAR(cone.ring[7].up_to, 1, 1e-12);
    double mean = 0, most = 0;
    for (int i = 0; i < draws; ++i) {
      const double x = cone.draw((i + 0.5) / draws);
      const double weight = cone.solid_angle_at(x) / (2 * pi * laser.even_within(x));
      mean += weight / draws;
      most = std::max(most, weight);
    }
    EXPECT_NEAR(mean, 1, 1e-3);
    EXPECT_LT(most, 2.2);
    EXPECT_GT(1 / cone.solid_angle_at(0.9 * cone.one_minus_cos()),
              0.09 / (2 * pi * cone.one_minus_cos()));
  }
}

// Of an instrument in the water. Other walks are as much less dense. Seen red: with a solid angle
// that does not know of the share.
TEST(EntryCone, UnderWavesLeavesAShareToWalksThatBeginAtFacets) {
  const auto flat_sea = transport::make_sea(40);
  auto sea = transport::make_sea(40);
  sea.waves.slopes.upwind_variance = sea.waves.slopes.crosswind_variance = 0.02;
  const std::vector<InnerCone> inner{{0.3, 0.5}};
  for (const auto& [direction, share] : {std::pair{V{0, 0, 1}, 0.25},
                                         {V{1, 0, 0}, 0.125},
                                         {V{0.6, 0, -0.8}, 0.02},
                                         {V{0, 0, -1}, 0.0}}) {
    const auto telescope = telescope_at({0, 0, -4}, direction);
    const auto flat = cone_of_own_rays(telescope, flat_sea, inner);
    const auto cone = cone_of_own_rays(telescope, sea, inner);
    EXPECT_NEAR(cone.by_facets, share, 1e-3);
    ASSERT_EQ(cone.rings, flat.rings);
    for (std::size_t k = 0; k < cone.rings; ++k)
      EXPECT_NEAR(cone.others() * cone.ring[k].solid_angle, flat.ring[k].solid_angle, 1e-12);
    for (const double u : {0.1, 0.4, 0.6, 0.9})
      EXPECT_NEAR(cone.draw(cone.others() * u), flat.draw(u), 1e-12);
  }
}

// Seen red: with their light sent down.
TEST(EntryCone, OfParallelRaysThatLookAwayLightNothing) {
  const auto sea = transport::make_sea(40);
  auto source = laser_at({0, 0, 10}, {0.1, 0, 1});
  source.half_divergence_mrad = 0;
  const auto laser = instrument::make_laser<double>(source);
  const auto birth =
      birth_at_collimated_laser(sea.view(), laser, {true, 0}, cone_of_own_rays(source, sea),
                                sea.line[0].refractive_index, 0.3, 0.6);
  EXPECT_FALSE(birth.exists);
}

}  // namespace
}  // namespace photic::estimator
