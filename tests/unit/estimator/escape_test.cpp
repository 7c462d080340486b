// The chance that a flight leaves the water.
#include "estimator/forward/escape.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "transport/cross.hpp"
#include "transport/flight.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

// Against flights themselves: the share of all uniforms for which one ends at the surface or on the
// bed, less what the surface reflects, and the weight that it has there. Seen red: with what is
// reflected counted as leaving; with c for the coefficient of free paths; without the slant.
TEST(Escape, IsWhatFlightsDo) {
  const auto sea = make_sea(14);
  Random random(17);
  int up = 0, reflected_totally = 0;
  for (int i = 0; i < 300; ++i) {
    auto photon = photon_at(sea, {0, 0, -random.between(0, 14)}, random.below(3));
    photon.direction = random.direction();
    photon.weight = 0.7;
    const auto away = estimator::escape(sea.view(), photon);
    constexpr int flights = 20000;
    int there = 0;
    double weight = 0;
    for (int k = 0; k < flights; ++k) {
      auto flown = photon;
      const auto end = fly(sea.view(), flown, minus_log((k + 0.5) / flights));
      if (!end.surface && !end.sea_bed) continue;
      ASSERT_EQ(end.surface, away.surface);
      if (end.surface) flown.weight = reflect_down(sea.view(), flown).into_air;
      ++there;
      weight += flown.weight / flights;
    }
    double share = static_cast<double>(there) / flights;
    if (away.surface) {
      const auto at_surface =
          optics::refract(sea.line[static_cast<std::size_t>(photon.line)].refractive_index, 1.0,
                          photon.direction.z);
      share *= 1 - at_surface.reflectance;
      ++up;
      reflected_totally += at_surface.reflectance == 1 ? 1 : 0;
    }
    EXPECT_NEAR(away.probability, share, 1.0 / flights);
    EXPECT_NEAR(away.weight, weight, 1.0 / flights);
  }
  EXPECT_GT(up, 100);
  EXPECT_GT(reflected_totally, 50);
}

// Nothing leaves on a level flight, or downwards where there is no bed.
TEST(Escape, IsNoneWhereNothingStandsInTheWay) {
  const auto sea = make_sea(std::numeric_limits<double>::infinity());
  auto photon = photon_at(sea, {0, 0, -6});
  EXPECT_EQ(estimator::escape(sea.view(), photon).probability, 0);
  EXPECT_EQ(estimator::escape(sea.view(), photon).weight, 0);
  photon.direction = {1, 0, 0};
  EXPECT_EQ(estimator::escape(sea.view(), photon).probability, 0);
  EXPECT_EQ(estimator::escape(sea.view(), photon).weight, 0);
}

}  // namespace
}  // namespace photic::transport
