// Other waters from the same histories, against runs of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

#include "core/error.hpp"
#include "engine/run.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// A scene with the sea of others as environments.
scene::Scene with(scene::Scene scene, const std::vector<scene::Scene>& others) {
  for (const auto& other : others)
    scene.environment.push_back(
        {fmt::format("environment{}", scene.environment.size()), {}, other.optics, other.sea});
  return scene;
}

const std::string three = channel("elastic") + channel("raman") + channel("chlorophyll");
const std::string below = R"(
[[telescope]]
name = "below"
position_m = [0.3, 0.0, -1.0]
direction = [0.0, 0.1, -1.0]
diameter_m = 0.10
focal_length_m = 0.5
detector_diameter_m = 0.05
)";

std::string chlorophyll(double mg_m3, double cdom_per_m, double yield = 0.01) {
  return fmt::format(
      "[[sea.layer]]\nchlorophyll_mg_m3 = {}\ncdom_a440_per_m = {}\nchlorophyll_yield = {}\n",
      mg_m3, cdom_per_m, yield);
}
/// Two layers that scatter evenly, so that echoes settle fast, with all processes; the upper ends
/// at 3 m.
std::string layers(double a1, double b1, double g1, double a2, double b2, double g2) {
  const auto layer = [](double a, double b, double g, const char* bottom) {
    return fmt::format(
        "[[sea.layer]]\n{}iop = [ {{ wavelength_nm = 532.0, a_per_m = {}, b_per_m = {}, "
        "a_phytoplankton_per_m = {} }}, {{ wavelength_nm = 700.0, a_per_m = {}, b_per_m = {} }} ]\n"
        "phase_function = {{ model = \"henyey-greenstein\", g = {} }}\n",
        bottom, a, b, a / 3, 3 * a, b, g);
  };
  return layer(a1, b1, g1, "bottom_depth_m = 3.0\n") + layer(a2, b2, g2, "");
}

struct Case {
  std::string name, instrument, water;
  std::vector<std::string> others;
  double depth_m, photons;
  std::size_t least;  ///< cells that are to be compared
  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class Environments : public testing::TestWithParam<Case> {};

TEST_P(Environments, AreTheirOwnRuns) {
  const Case& c = GetParam();
  const auto scene = [&](const std::string& water, std::uint64_t seed) {
    return read(ship_instrument + c.instrument + water + depth_gates(c.depth_m, c.depth_m / 10) +
                simulation(c.photons, seed));
  };
  std::vector<scene::Scene> others;
  for (const auto& water : c.others) others.push_back(scene(water, 1));
  const tally::Result all = run_in_lanes(with(scene(c.water, 41), others));

  ZFamily family(0.01);
  std::size_t cell = 0;
  for (std::size_t e = 0; e < c.others.size(); ++e) {
    const tally::Result own = run_in_lanes(scene(c.others[e], 42 + e));
    for (std::size_t i = 0; i < own.echo.mean.size(); ++i, ++cell) {
      if (own.convergence_flags[i] != 0 || all.environment_convergence_flags[cell] != 0) continue;
      family.add(all.environment_echo.mean[cell], own.echo.mean[i],
                 std::hypot(all.environment_echo.standard_error[cell], own.echo.standard_error[i]),
                 fmt::format("environment {}, cell {}", e, i));
    }
  }
  std::printf("%s: %zu of %zu cells compared, rms z %.2f\n", c.name.c_str(), family.size(), cell,
              family.rms());
  EXPECT_GE(family.size(), c.least);
  family.judge();
}

INSTANTIATE_TEST_SUITE_P(
    , Environments,
    testing::Values(
        Case{"chlorophyll",
             three,
             chlorophyll(0.5, 0.02),
             {chlorophyll(0.7, 0.02), chlorophyll(0.4, 0.0), chlorophyll(0.5, 0.02, 0.03)},
             5,
             4e6,
             50},
        Case{"layers",
             below + three,
             layers(0.06, 0.2, 0.6, 0.1, 0.3, 0.5),
             {layers(0.08, 0.16, 0.6, 0.07, 0.4, 0.5), layers(0.06, 0.2, 0.65, 0.1, 0.3, 0.6)},
             8,
             4e6,
             30},
        Case{"phase_function",
             channel("elastic"),
             water(0.06, 0.10, henyey_greenstein_phase),
             {water(0.06, 0.10, peaked_phase), water(0.10, 0.08, henyey_greenstein_phase)},
             5,
             1e7,
             10}),
    [](const auto& test) { return test.param.name; });

scene::Scene algae_scene(double mg_m3, std::uint64_t seed) {
  return read(ship_instrument + three + chlorophyll(mg_m3, 0.02) + depth_gates(5, 0.5) +
              simulation(2e6, seed));
}

// In all there is to see. Seen red: with the difference alone for the environment's echo; with its
// error for that of the difference.
TEST(EnvironmentOf, TheSceneItselfIsTheSceneToTheBit) {
  const auto scene = algae_scene(0.5, 43);
  const auto result = run_in_lanes(with(scene, {scene}));
  EXPECT_EQ(result.environment_echo.mean, result.echo.mean);
  EXPECT_EQ(result.environment_echo.standard_error, result.echo.standard_error);
  for (const double d : result.environment_difference.mean) EXPECT_EQ(d, 0);
  for (const double d : result.environment_difference.standard_error) EXPECT_EQ(d, 0);
  const auto alone = run_in_lanes(scene);
  EXPECT_EQ(alone.echo.mean, result.echo.mean);
}

// What the error of a difference from the same histories is for. Seen red: with the error of the
// environment's echo for it.
TEST(EnvironmentOf, OnePercentMoreIsSeenSharply) {
  const auto scene = algae_scene(0.5, 44);
  const auto result = run_in_lanes(with(scene, {algae_scene(0.505, 1)}));
  std::size_t compared = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < result.echo.mean.size(); ++i) {
    if (result.environment_convergence_flags[i] != 0) continue;
    const double apart =
        std::hypot(result.echo.standard_error[i], result.environment_echo.standard_error[i]);
    least = std::min(least, apart / result.environment_difference.standard_error[i]);
    ++compared;
  }
  std::printf("errors of differences are at least %.0f times smaller, in %zu gates\n", least,
              compared);
  EXPECT_GE(compared, 15U);
  EXPECT_GE(least, 20);
}

// One and the same, whatever the engine: ratios are rounded to float in lanes.
TEST(EnvironmentOf, LanesIsThatOfTheScalarEngine) {
  const auto scene = with(algae_scene(0.5, 45), {algae_scene(0.7, 1), algae_scene(0.3, 1)});
  const auto lanes = run_in_lanes(scene);
  const auto scalar = engine::run(scene);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < lanes.environment_difference.mean.size(); ++i) {
    const double error = scalar.environment_difference.standard_error[i];
    if (!(error > 0)) continue;
    EXPECT_NEAR(lanes.environment_difference.mean[i], scalar.environment_difference.mean[i],
                0.2 * error)
        << i;
    ++compared;
  }
  EXPECT_EQ(compared, 60U);
}

// Also of runs that go on and of any number of threads. Seen red: with the sums of the environments
// not cleared between batches.
TEST(EnvironmentOf, ThreadsAndSittingsDoNotMatter) {
  auto scene = with(algae_scene(0.5, 46), {algae_scene(0.7, 1)});
  scene.simulation.photons = 40'000;
  engine::RunOptions options;
  options.threads = 3;
  options.lanes = isas_here().back();
  const auto once = engine::run(scene, options);
  auto shorter = scene;
  shorter.simulation.photons = 17'000;
  const auto first = engine::run(shorter, options);
  options.threads = 1;
  options.start = {.state = first.state.value(), .wall_time_s = 0, .file = "old.nc"};
  const auto then = engine::run(scene, options);
  EXPECT_EQ(then.environment_echo.mean, once.environment_echo.mean);
  EXPECT_EQ(then.environment_difference.standard_error, once.environment_difference.standard_error);
  EXPECT_EQ(then.environment_convergence_flags, once.environment_convergence_flags);
}

}  // namespace
}  // namespace photic::test
