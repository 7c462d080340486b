// Ratios of environments that are known path by path, whatever strategy has drawn it: bounds that
// every single score keeps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/constants.hpp"
#include "run/run.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::test {
namespace {

constexpr double group_index = 1.35;
constexpr double in_air_m = 24;

struct Setup {
  std::string estimator;
  bool submerged = false;
  std::string more{};  ///< of the simulation
  bool lanes = true;
  friend std::ostream& operator<<(std::ostream& out, const Setup& s) {
    return out << s.estimator << (s.submerged ? "_submerged" : "") << (s.lanes ? "" : "_scalar");
  }
};

/// Three layers with all processes, and so much absorption besides in all of them.
std::string three_waters(double more_a, double times_b = 1, double yield = 0.02) {
  std::string out = fmt::format("[sea]\ngroup_index = {}\n", group_index);
  const auto layer = [&](double a, double b, double g, const char* bottom) {
    out += fmt::format(
        "[[sea.layer]]\n{}iop = [ {{ wavelength_nm = 532.0, a_per_m = {}, b_per_m = {}, "
        "a_phytoplankton_per_m = {} }}, {{ wavelength_nm = 700.0, a_per_m = {}, b_per_m = {} }} ]\n"
        "chlorophyll_yield = {}\n"
        "phase_function = {{ model = \"henyey-greenstein\", g = {} }}\n",
        bottom, a + more_a, b * times_b, a / 3, 2 * a + more_a, b * times_b, yield, g);
  };
  layer(0.05, 0.15, 0.7, "bottom_depth_m = 1.5\n");
  layer(0.10, 0.40, 0.8, "bottom_depth_m = 3.0\n");
  layer(0.06, 0.10, 0.5, "");
  return out;
}

const std::string submerged_lidar = R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, -1.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.02
half_divergence_mrad = 5.0
[[telescope]]
position_m = [0.1, 0.0, -1.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.20
focal_length_m = 0.3
detector_diameter_m = 0.15
[[telescope]]
name = "up"
position_m = [0.1, 0.0, -2.0]
direction = [0.2, 0.0, 1.0]
diameter_m = 0.20
focal_length_m = 0.3
detector_diameter_m = 0.15
)";

/// With one environment, of other water.
tally::Result run_with(const Setup& s, const std::string& water, const std::string& other,
                       const std::string& more = "") {
  const auto scene = [&](const std::string& sea) {
    const std::string all = channel("elastic") + channel("raman") + channel("chlorophyll");
    return read((s.submerged ? submerged_lidar : ship_instrument) + all + sea +
                "[gates]\nstart_ns = 0\nstop_ns = 150\nstep_ns = 1\n" +
                simulation(s.lanes ? 40'000 : 4'000, 71, s.more + more, s.estimator));
  };
  auto out = scene(water);
  const auto changed = scene(other);
  out.environment.push_back({"other", {}, changed.optics, changed.sea});
  return s.lanes ? run_in_lanes(out) : run::run(out, *test::tables());
}

/// Echoes in water with so much more absorption everywhere fade by the length of their path, which
/// a gate shows. Returns the number of gates with light.
std::size_t expect_fading(const tally::Result& result, double more_a, bool submerged) {
  const std::size_t gates = result.gates();
  // In the air light may go a little askew.
  const double slack = submerged ? 1e-4 : 0.02;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < result.echo.mean.size(); ++i) {
    if (result.echo.mean[i] == 0) continue;
    const double ratio = result.environment_echo.mean[i] / result.echo.mean[i];
    const auto water = [&](std::size_t edge, double less) {
      const double path = metre_per_nanosecond * result.gate_time_edge_ns[edge];
      return std::max(0.0, path - (submerged ? 0 : in_air_m) - less) / group_index;
    };
    EXPECT_LE(ratio, std::exp(-more_a * water(i % gates, slack)) * (1 + 1e-4)) << i;
    EXPECT_GE(ratio, std::exp(-more_a * water(i % gates + 1, 0)) * (1 - 1e-4)) << i;
    ++seen;
  }
  return seen;
}

class EnvironmentPaths : public testing::TestWithParam<Setup> {};

// Seen red, each with its estimators: without the way from the last vertex, without the edge
// between two walks, without either ray to a meeting, with reflected legs as if they were straight,
// with reflected rays to a meeting so; with the walks' own depths left out.
TEST_P(EnvironmentPaths, FadeByTheirLength) {
  const double more_a = 0.3;
  const auto result = run_with(GetParam(), three_waters(0), three_waters(more_a));
  EXPECT_GT(expect_fading(result, more_a, GetParam().submerged), 3 * 40U);
}

// Ways from a lens of 1 m that is tilted by 45 degrees become longer or shorter by up to some
// metres if a walk is translated; gates of 2 cm show how long they are. Seen red: with ways as long
// as before; with the first rays' longer by that once more, which begin at the lens.
TEST(PathsFromATiltedLens, FadeByTheirLength) {
  const double more_a = 0.3;
  const std::string lidar =
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, -2.0]\ndirection = [0.0, 0.0, "
      "-1.0]\ndiameter_m = 0.02\nhalf_divergence_mrad = 100.0\n[[telescope]]\nposition_m = "
      "[0.0, 0.5, -2.0]\ndirection = [0.0, 0.7, -0.7]\ndiameter_m = 1.0\nfocal_length_m = 1.0\n"
      "half_field_of_view_mrad = 900.0\n";
  const auto scene = [&](double more) {
    return read(lidar + channel("elastic") + three_waters(more) +
                "[gates]\nstart_ns = 0.0\nstop_ns = 40.0\nstep_ns = 0.2\n" +
                simulation(10'000, 74, "", "bidirectional"));
  };
  auto both = scene(0);
  both.environment.push_back({"other", {}, scene(more_a).optics, scene(more_a).sea});
  EXPECT_GT(expect_fading(run_in_lanes(both), more_a, true), 100U);
}

// Light that is scattered k times by water that scatters more. Seen red: with only one of the
// collisions at the ends of an edge.
TEST_P(EnvironmentPaths, AreAsManyTimesScattered) {
  const double times_b = 1.02;
  auto water = three_waters(0), other = three_waters(0, times_b);
  const auto result = run_with(GetParam(), water, other, "max_order = 3\n");
  const std::size_t gates = result.gates();
  const double max_excess = (times_b - 1) * 0.40;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < result.echo.mean.size(); ++i) {
    if (result.echo.mean[i] == 0) continue;
    const double ratio = result.environment_echo.mean[i] / result.echo.mean[i];
    const double path = metre_per_nanosecond * result.gate_time_edge_ns[i % gates + 1] -
                        (GetParam().submerged ? 0 : in_air_m);
    const bool elastic = i / gates % 3 == 0;
    EXPECT_LE(ratio, std::pow(times_b, elastic ? 3 : 2) * (1 + 1e-4)) << i;
    EXPECT_GE(ratio, std::pow(times_b, elastic ? 1 : 0) *
                         std::exp(-max_excess * path / group_index) * (1 - 1e-4))
        << i;
    ++seen;
  }
  EXPECT_GT(seen, 3 * 40U);
}

// Three times the yield is three times the light. Seen red: with conversions of walks, or at
// meetings, as if they were scatterings.
TEST_P(EnvironmentPaths, ShineAsTheirYield) {
  const auto result = run_with(GetParam(), three_waters(0), three_waters(0, 1, 0.06));
  const std::size_t gates = result.gates();
  for (std::size_t i = 0; i < result.echo.mean.size(); ++i) {
    const double expected = (i / gates % 3 == 2 ? 3 : 1) * result.echo.mean[i];
    EXPECT_NEAR(result.environment_echo.mean[i], expected, 1e-5 * expected) << i;
  }
}

/// Water that is the same all over, and what is derived by.
tally::Result derivatives(const Setup& s, const std::string& parameters, const std::string& water,
                          const std::string& more) {
  return [&](const auto& scene) {
    return s.lanes ? run_in_lanes(scene) : run::run(scene, *test::tables());
  }(read("sensitivity = [" + parameters + "]\n" +
         (s.submerged ? submerged_lidar : ship_instrument) + channel("elastic") +
         fmt::format("[sea]\ngroup_index = {}\n", group_index) + water +
         "[gates]\nstart_ns = 0\nstop_ns = 150\nstep_ns = 1\n" +
         simulation(s.lanes ? 40'000 : 4'000, 72, s.more + more, s.estimator)));
}

// d ln(echo) / d a is the length of the path, and d ln(echo) / d b less than that by 1 / b for
// light that was scattered once: the lidar equation's. Seen red: with half the step; with the
// derivative for that times the parameter.
TEST_P(EnvironmentPaths, HaveTheDerivativesOfTheLidarEquation) {
  constexpr double a = 0.08, b = 0.12;
  const auto result =
      derivatives(GetParam(), R"("sea.layer.0.iop.0.a_per_m", "sea.layer.0.iop.0.b_per_m")",
                  water(a, b, henyey_greenstein_phase), "max_order = 1\n");
  const std::size_t cells = result.echo.mean.size();
  const double slack = GetParam().submerged ? 1e-4 : 0.02;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    if (result.echo.mean[i] == 0) continue;
    const auto length = [&](std::size_t edge, double less) {
      const double path = metre_per_nanosecond * result.gate_time_edge_ns[edge];
      return std::max(0.0, path - (GetParam().submerged ? 0 : in_air_m) - less) / group_index;
    };
    const double shortest = length(i % result.gates(), slack);
    const double longest = length(i % result.gates() + 1, 0);
    const double by_a = result.sensitivity.mean[i] / result.echo.mean[i];
    const double by_b = result.sensitivity.mean[cells + i] / result.echo.mean[i];
    EXPECT_LE(by_a, -shortest + 1e-4) << i;
    EXPECT_GE(by_a, -longest - 1e-4) << i;
    EXPECT_LE(by_b, 1 / b - shortest + 1e-3) << i;
    EXPECT_GE(by_b, 1 / b - longest - 1e-3) << i;
    EXPECT_NEAR(result.logarithmic_sensitivity.mean[i], a * by_a, 1e-9) << i;
    ++seen;
  }
  EXPECT_GT(seen, 40U);
}

// Of all orders, chlorophyll's and of Raman and fluorescence light too. Seen red: with half the
// step.
TEST_P(EnvironmentPaths, HaveTheDerivativesThatSmallStepsHave) {
  const auto algae = [](double mg_m3) {
    return fmt::format("[[sea.layer]]\nchlorophyll_mg_m3 = {}\n", mg_m3);
  };
  constexpr double step = 0.01;
  const auto scene = [&](double mg_m3) {
    return read(
        "sensitivity = [\"sea.layer.0.chlorophyll_mg_m3\"]\n" +
        (GetParam().submerged ? submerged_lidar : ship_instrument) + channel("elastic") +
        channel("raman") + channel("chlorophyll") + algae(mg_m3) +
        "[gates]\nstart_ns = 0\nstop_ns = 150\nstep_ns = 5\n" +
        simulation(GetParam().lanes ? 40'000 : 4'000, 73, GetParam().more, GetParam().estimator));
  };
  auto all = scene(1);
  for (const double mg_m3 : {1 - step, 1 + step})
    all.environment.push_back({fmt::format("{}", mg_m3), {}, all.optics, scene(mg_m3).sea});
  const auto result = GetParam().lanes ? run_in_lanes(all) : run::run(all, *test::tables());
  const std::size_t cells = result.echo.mean.size();
  for (std::size_t i = 0; i < cells; ++i) {
    const auto& difference = result.environment_difference.mean;
    const double by_step = (difference[cells + i] - difference[i]) / (2 * step);
    EXPECT_NEAR(result.sensitivity.mean[i], by_step, 3e-3 * result.echo.mean[i]) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(, EnvironmentPaths,
                         testing::Values(Setup{"forward"}, Setup{"forward", true},
                                         Setup{"bidirectional"}, Setup{"bidirectional", true},
                                         Setup{"bidirectional", true, "walks = 3\n"},
                                         Setup{"bidirectional", true, "", false},
                                         Setup{"bidirectional", false, "", false}));

}  // namespace
}  // namespace photic::test
