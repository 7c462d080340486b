// Other waters from the same histories, against runs of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
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
  EXPECT_GT(family.size(), cell / 2);
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
             4e6},
        Case{"layers",
             below + three,
             layers(0.06, 0.2, 0.6, 0.1, 0.3, 0.5),
             {layers(0.08, 0.16, 0.6, 0.07, 0.4, 0.5), layers(0.06, 0.2, 0.65, 0.1, 0.3, 0.6)},
             8,
             2e6},
        Case{"phase_function",
             channel("elastic"),
             water(0.06, 0.10, henyey_greenstein_phase),
             {water(0.06, 0.10, peaked_phase), water(0.10, 0.08, henyey_greenstein_phase)},
             8,
             4e6}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace photic::test
