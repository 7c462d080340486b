// What a collision makes of a photon, in the mean.
#include "transport/collide.hpp"

#include <gtest/gtest.h>

#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

constexpr double conversion = 0.2;
constexpr int strata = 1000;  // midpoints of a grid of uniforms: the means are exact

/// Mean weight by line after a collision in a layer.
std::vector<double> mean_weights(const Sea& sea, std::int32_t line, std::int32_t layer) {
  std::vector<double> mean(3, 0.0);
  for (int i = 0; i < strata; ++i) {
    for (int j = 0; j < strata; ++j) {
      Photon<double> photon;
      photon.line = line;
      photon.layer = layer;
      collide(sea.view(), photon, 0, conversion, (i + 0.5) / strata, (j + 0.5) / strata);
      mean[static_cast<std::size_t>(photon.line)] += photon.weight / (double{strata} * strata);
    }
  }
  return mean;
}

// Scattering keeps b / c of the weight, each line gets its share of it. Seen red: with the
// scattered weight not divided by the probability left for it; with the lines' number left out;
// with the conversion of line 0 for that of the line.
TEST(Collide, GivesEveryBranchItsShareInTheMean) {
  const auto sea = make_sea(40);
  const double expected[3][3] = {{0.6, 1e-3, 0}, {0.8, 2e-3, 5e-3}, {0.7, 0, 0}};
  for (std::int32_t layer = 0; layer < 3; ++layer) {
    const auto mean = mean_weights(sea, 0, layer);
    for (std::size_t line = 0; line < 3; ++line) {
      EXPECT_NEAR(mean[line], expected[layer][line], 1e-10) << layer << " " << line;
    }
  }
}

// Seen red: without the test for line 0.
TEST(Collide, ConvertsLightOnlyOnce) {
  const auto sea = make_sea(40);
  const auto raman = mean_weights(sea, 1, 1);
  EXPECT_EQ(raman[0], 0);
  EXPECT_NEAR(raman[1], 0.5, 1e-10);
  EXPECT_EQ(raman[2], 0);
}

TEST(Collide, ReturnsWhereTheLightGoesFromThere) {
  const auto sea = make_sea(40);
  Photon<double> scattered;
  scattered.layer = 1;
  scattered.order = 3;
  const auto on = collide(sea.view(), scattered, 0, conversion, 0.5, 0.9);
  EXPECT_FALSE(on.converted);
  EXPECT_EQ(scattered.line, 0);
  EXPECT_EQ(scattered.order, 4);
  EXPECT_EQ(on.phase, 1);  // of the second layer
  EXPECT_EQ(on.lobe, 1);
  EXPECT_NEAR(scattered.analog_weight, 0.8, 1e-15);

  Photon<double> converted;
  converted.layer = 1;
  const auto other = collide(sea.view(), converted, 0, conversion, 0.1, 0.9);
  EXPECT_TRUE(other.converted);
  EXPECT_EQ(converted.line, 2);
  EXPECT_EQ(other.phase, 4);  // isotropic
  EXPECT_EQ(other.lobe, 1);   // the elastic table of the line it has now
  EXPECT_NEAR(converted.weight, 5e-3 * 2 / conversion, 1e-15);
  EXPECT_EQ(converted.analog_weight, 1);  // else roulette would take what conversion is about
}

// Seen red: with the survivors' weight left alone; with roulette by the weight instead of the
// analog weight.
TEST(Roulette, KeepsTheMeanWeight) {
  for (const double analog : {1e-4, 2.5e-4, 9e-4}) {
    double mean = 0;
    int survivors = 0;
    for (int i = 0; i < 10000; ++i) {
      Photon<double> photon;
      photon.weight = 3;
      photon.analog_weight = analog;
      const bool survives = roulette(photon, 1e-3, (i + 0.5) / 10000);
      survivors += survives;
      ASSERT_EQ(photon.analog_weight, 1e-3);
      if (survives) {
        mean += photon.weight / 10000;
      } else {
        ASSERT_EQ(photon.weight, 3);
      }
    }
    EXPECT_NEAR(mean, 3, 1e-9) << analog;
    EXPECT_EQ(survivors, static_cast<int>(std::lround(analog / 1e-3 * 10000)));
  }
}

TEST(Roulette, LeavesLightAboveTheThresholdAlone) {
  Photon<double> photon;
  photon.weight = 1e-9;  // small by directed sampling, not by absorption
  photon.analog_weight = 1e-3;
  EXPECT_TRUE(roulette(photon, 1e-3, 1 - 1e-12));
  EXPECT_EQ(photon.weight, 1e-9);
  EXPECT_EQ(photon.analog_weight, 1e-3);
}

TEST(Roulette, EndsLightThatIsGone) {
  Photon<double> photon;
  photon.analog_weight = 0;
  EXPECT_FALSE(roulette(photon, 1e-3, 1e-12));
  EXPECT_TRUE(std::isfinite(photon.weight));
}

}  // namespace
}  // namespace photic::transport
