// Other waters from the same histories, against runs of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

#include "core/error.hpp"
#include "run/run.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// A scene with the sea of others as environments.
scene::Scene with(scene::Scene scene, const std::vector<scene::Scene>& others) {
  for (const auto& other : others)
    scene.environment.push_back({fmt::format("environment{}", scene.environment.size()),
                                 {},
                                 other.optics,
                                 other.sea,
                                 other.bottom});
  return scene;
}

const std::string three = channel("elastic") + channel("raman") + channel("chlorophyll");
std::string chlorophyll(double mg_m3, double cdom_per_m, double yield = 0.01) {
  return fmt::format(
      "[[sea.layer]]\nchlorophyll_mg_m3 = {}\ncdom_a440_per_m = {}\nchlorophyll_yield = {}\n",
      mg_m3, cdom_per_m, yield);
}
/// Layers that scatter evenly, so that echoes settle fast, with all processes; the upper one of
/// two ends at 3 m.
std::string one_layer(double a, double b, double g, const char* bottom = "") {
  return fmt::format(
      "[[sea.layer]]\n{}iop = [ {{ wavelength_nm = 532.0, a_per_m = {}, b_per_m = {}, "
      "a_phytoplankton_per_m = {} }}, {{ wavelength_nm = 700.0, a_per_m = {}, b_per_m = {} }} ]\n"
      "phase_function = {{ model = \"henyey-greenstein\", g = {} }}\n",
      bottom, a, b, a / 3, 3 * a, b, g);
}
std::string layers(double a1, double b1, double g1, double a2, double b2, double g2) {
  return one_layer(a1, b1, g1, "bottom_depth_m = 3.0\n") + one_layer(a2, b2, g2);
}

struct Case {
  std::string name, instrument, water;
  std::vector<std::string> others;
  double depth_m, photons;
  std::size_t least;  ///< cells that are to be compared
  std::string estimator = "forward";
  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

class Environments : public testing::TestWithParam<Case> {};

// Seen red: with the way back to the telescope as in the scene; with weights of collisions as if
// free paths were the scene's own (rms z of 7.5 and 8.9).
TEST_P(Environments, AreTheirOwnRuns) {
  const Case& c = GetParam();
  const auto scene = [&](const std::string& water, std::uint64_t seed) {
    return read(ship_instrument + c.instrument + water + depth_gates(c.depth_m, c.depth_m / 10) +
                simulation(c.photons, seed, "", c.estimator));
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

const std::vector<std::string> changed_algae = {chlorophyll(0.7, 0.02), chlorophyll(0.4, 0.0),
                                                chlorophyll(0.5, 0.02, 0.03)};
const std::string three_layers_here =
    one_layer(0.06, 0.2, 0.6, "bottom_depth_m = 1.5\n") + layers(0.1, 0.3, 0.5, 0.05, 0.1, 0.7);
const std::vector<std::string> three_layers_changed = {
    one_layer(0.06, 0.2, 0.6, "bottom_depth_m = 1.5\n") + layers(0.13, 0.25, 0.5, 0.05, 0.1, 0.7),
    one_layer(0.08, 0.22, 0.65, "bottom_depth_m = 1.5\n") + layers(0.1, 0.3, 0.5, 0.04, 0.12, 0.6),
    one_layer(0.06, 0.2, 0.6, "bottom_depth_m = 1.5\n") + layers(0.1, 0.3, 0.5, 0.06, 0.12, 0.65)};

/// Shallow water over a bed.
std::string over_bed(double a, const std::string& albedo) {
  return one_layer(a, 0.2, 0.6, "bottom_depth_m = 3.3\n") + "[bottom]\nalbedo = " + albedo + "\n";
}
const std::string bed_here = over_bed(0.06, "0.2");
const std::vector<std::string> beds_changed = {
    over_bed(0.06, "0.1"), over_bed(0.07, "0.25"),
    over_bed(0.06, "{ wavelength_nm = [500, 700], albedo = [0.1, 0.5] }"),
    over_bed(0.06, "{ zenith_deg = [0, 30, 90], albedo = [0.1, 0.3, 0.6] }")};

INSTANTIATE_TEST_SUITE_P(
    , Environments,
    testing::Values(
        Case{"chlorophyll", three, chlorophyll(0.5, 0.02), changed_algae, 5, 1e7, 50},
        Case{"layers",
             submerged_telescope + three,
             layers(0.06, 0.2, 0.6, 0.1, 0.3, 0.5),
             {layers(0.08, 0.16, 0.6, 0.07, 0.4, 0.5), layers(0.06, 0.2, 0.65, 0.1, 0.3, 0.6)},
             8,
             6e6,
             30},
        Case{"three_layers", three, three_layers_here, three_layers_changed, 6, 2e6, 20},
        Case{"phase_function",
             channel("elastic"),
             water(0.06, 0.10, henyey_greenstein_phase),
             {water(0.06, 0.10, peaked_phase), water(0.10, 0.08, henyey_greenstein_phase)},
             5,
             1e7,
             10},
        Case{"bidirectional", three, chlorophyll(0.5, 0.02), changed_algae, 10, 1.5e5, 70,
             "bidirectional"},
        Case{"bidirectional_three_layers", three, three_layers_here, three_layers_changed, 8, 2.5e5,
             25, "bidirectional"},
        // Seen red: with the albedo of the angle on the telescope's side, in each estimator.
        Case{"bed", three, bed_here, beds_changed, 6, 2e6, 40},
        Case{"bidirectional_bed", three, bed_here, beds_changed, 6, 1.3e5, 40, "bidirectional"}),
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
  for (std::size_t i = 0; i < result.echo.mean.size(); ++i) {
    const double error = result.echo.standard_error[i];  // the unseen in it is known by octaves
    EXPECT_NEAR(result.environment_echo.standard_error[i], error, 0.05 * error);
  }
  for (const double d : result.environment_difference.mean) EXPECT_EQ(d, 0);
  for (const double d : result.environment_difference.standard_error) EXPECT_EQ(d, 0);
  auto alone = scene;
  alone.simulation.sampling = scene::Sampling::random;  // as with environments
  EXPECT_EQ(run_in_lanes(alone).echo.mean, result.echo.mean);
}

/// Runs of a scene that differ in their seeds, with one environment.
std::vector<tally::Result> repeats(const scene::Scene& scene, const scene::Scene& other) {
  std::vector<tally::Result> out;
  for (std::uint64_t seed = 500; seed < 544; ++seed) {
    auto one = with(scene, {other});
    one.simulation.photons = 400'000;
    one.simulation.seed = seed;
    out.push_back(run_in_lanes(one));
  }
  return out;
}

struct Moments {
  double mean = 0, variance = 0;
};
template <class Value>
Moments moments(const std::vector<tally::Result>& results, Value value) {
  const auto n = static_cast<double>(results.size());
  Moments m;
  for (const auto& r : results) m.mean += value(r) / n;
  for (const auto& r : results) m.variance += std::pow(value(r) - m.mean, 2) / (n - 1);
  return m;
}

double difference(const tally::Result& result, std::size_t cell) {
  return result.environment_difference.mean[cell];
}

// What differences from the same histories are for, by how runs scatter and not by what they say:
// on peaked water that has its own tail.
TEST(EnvironmentOf, OnePercentMoreIsSeenSharply) {
  const auto results = repeats(algae_scene(0.5, 1), algae_scene(0.505, 1));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < results[0].echo.mean.size(); ++i) {
    const auto of = [&](auto value) { return moments(results, value).variance; };
    const double apart = of([i](const auto& r) { return r.echo.mean[i]; }) +
                         of([i](const auto& r) { return r.environment_echo.mean[i]; });
    least = std::min(least, std::sqrt(apart / of([i](const auto& r) { return difference(r, i); })));
  }
  std::printf("differences scatter at least %.0f times less than those of separate runs\n", least);
  EXPECT_GE(least, 20);
}

// Errors of differences, where they have converged, in water that the forward estimator can do.
// Seen red: with half the error; with that of the environment's echo.
TEST(EnvironmentOf, DifferencesScatterAsTheySay) {
  const auto scene = [](const std::string& layers_of) {
    return read(ship_instrument + channel("elastic") + channel("raman") + layers_of +
                depth_gates(8, 1) + simulation(1, 1));
  };
  const auto results = repeats(scene(layers(0.06, 0.2, 0.6, 0.1, 0.3, 0.5)),
                               scene(layers(0.06, 0.21, 0.6, 0.11, 0.3, 0.5)));
  const double own_share = 1 - 1.0 / static_cast<double>(results.size());  // of the mean
  double covered = 0, known = 0;
  for (std::size_t i = 0; i < results[0].echo.mean.size(); ++i) {
    const double mean = moments(results, [i](const auto& r) { return difference(r, i); }).mean;
    for (const auto& r : results) {
      if (r.environment_convergence_flags[i] != 0) continue;
      const double error = r.environment_difference.standard_error[i] * std::sqrt(own_share);
      covered += std::abs(difference(r, i) - mean) < 1.96 * error ? 1 : 0;
      ++known;
    }
  }
  std::printf("%.1f %% of %.0f intervals of differences cover\n", 100 * covered / known, known);
  EXPECT_GT(known, 300);
  EXPECT_GE(covered, 0.88 * known);
  EXPECT_LE(covered, 0.99 * known);
}

/// How often 95 % intervals of unflagged gates cover the truth.
struct Coverage {
  double covered = 0, known = 0, all = 0;
  /// That they do, and that flags leave a share of all gates.
  void expect(const std::string& what, double min_known) const {
    std::printf("%s: of %.0f gates %.0f are not flagged; %.1f %% of these intervals cover\n",
                what.c_str(), all, known, 100 * covered / known);
    EXPECT_GE(known, min_known * all) << what;
    EXPECT_GE(covered, 0.88 * known) << what;
    EXPECT_LE(covered, 0.99 * known) << what;
  }
};

// Strongly changed water is right, or flagged: 95 % intervals cover what a run of its own finds.
// Seen red: with free paths no shorter than in the clearest of all (59 of 400 gates known).
void expect_strong_changes_covered(const std::string& estimator, double photons, double g,
                                   std::uint64_t seeds, double min_known) {
  const auto scene = [&](double times, double n, std::uint64_t seed, const std::string& by) {
    return read(ship_instrument + channel("elastic") +
                water(0.06 * times, 0.10 * times,
                      fmt::format("{{ model = \"henyey-greenstein\", g = {} }}", g)) +
                depth_gates(10, 1) +
                simulation(n, seed, by == "bidirectional" ? no_free_walks : "", by));
  };
  const std::vector<double> changes{0.4, 0.7, 1.5, 2.5};  // of the attenuation
  std::vector<scene::Scene> others;
  std::vector<tally::Result> own;
  for (const double times : changes) {
    others.push_back(scene(times, 1, 1, estimator));
    own.push_back(run_in_lanes(scene(times, 4e5, 61, "bidirectional")));
  }
  std::vector<Coverage> coverage(changes.size());
  for (std::uint64_t seed = 700; seed < 700 + seeds; ++seed) {
    const auto all = run_in_lanes(with(scene(1, photons, seed, estimator), others));
    for (std::size_t e = 0; e < changes.size(); ++e) {
      for (std::size_t i = 0; i < own[e].echo.mean.size(); ++i) {
        const std::size_t cell = e * own[e].echo.mean.size() + i;
        ++coverage[e].all;
        if (own[e].convergence_flags[i] != 0 || all.environment_convergence_flags[cell] != 0)
          continue;
        const double off = all.environment_echo.mean[cell] - own[e].echo.mean[i];
        const double error =
            std::hypot(all.environment_echo.standard_error[cell], own[e].echo.standard_error[i]);
        ++coverage[e].known;
        coverage[e].covered += std::abs(off) < 1.96 * error ? 1 : 0;
      }
    }
  }
  for (std::size_t e = 0; e < changes.size(); ++e)
    coverage[e].expect(fmt::format("{}, attenuation times {}", estimator, changes[e]), min_known);
}

TEST(EnvironmentOf, StrongChangesAreRightOrFlaggedBidirectional) {
  expect_strong_changes_covered("bidirectional", 6.2e4, 0.924, 40, 0.5);
}
TEST(EnvironmentOf, StrongChangesAreRightOrFlaggedForward) {
  expect_strong_changes_covered("forward", 2.5e5, 0.6, 100, 0.25);
}

// Of elastic, Raman and fluorescence light, all orders. Seen red: with half the step.
TEST(Derivatives, AreThoseOfSeparateRuns) {
  const auto scene = [](double mg_m3, std::uint64_t seed) {
    return read("sensitivity = [\"sea.layer.0.chlorophyll_mg_m3\"]\n" + ship_instrument + three +
                chlorophyll(mg_m3, 0.02) + depth_gates(10, 1) +
                simulation(2e5, seed, "", "bidirectional"));
  };
  constexpr double value = 0.5, step = 0.05;
  const auto all = run_in_lanes(scene(value, 81));
  const auto less = run_in_lanes(scene(value - step, 82));
  const auto more = run_in_lanes(scene(value + step, 83));
  ZFamily family(0.01);
  for (std::size_t i = 0; i < all.echo.mean.size(); ++i) {
    if ((all.sensitivity_convergence_flags[i] | less.convergence_flags[i] |
         more.convergence_flags[i]) != 0)
      continue;
    family.add(all.sensitivity.mean[i], (more.echo.mean[i] - less.echo.mean[i]) / (2 * step),
               std::hypot(all.sensitivity.standard_error[i],
                          std::hypot(more.echo.standard_error[i], less.echo.standard_error[i]) /
                              (2 * step)),
               fmt::format("cell {}", i));
  }
  std::printf("%zu derivatives compared, rms z %.2f\n", family.size(), family.rms());
  EXPECT_GE(family.size(), 20U);
  family.judge();
}

// No light is none, not what rounding leaves of two that are equal. Seen red: with the scene's echo
// plus the difference always.
TEST(EnvironmentOf, WaterWithoutFluorescenceHasNoneToTheBit) {
  const auto scene = algae_scene(0.5, 47);
  auto dark = scene;
  for (auto& layer : dark.sea.layer) layer.chlorophyll_yield = 0;
  const auto result = run_in_lanes(with(scene, {dark}));
  const std::size_t gates = result.gates();
  for (std::size_t i = 2 * gates; i < 3 * gates; ++i) {
    EXPECT_EQ(result.environment_echo.mean[i], 0);
    EXPECT_EQ(result.environment_convergence_flags[i] & tally::no_score, tally::no_score);
    EXPECT_NEAR(result.environment_difference.mean[i], -result.echo.mean[i],
                1e-9 * result.echo.mean[i]);
  }
}

// One and the same, whatever the engine: ratios are rounded to float in lanes. Seen red: with
// ratios of the lane beside.
TEST(EnvironmentOf, LanesIsThatOfTheScalarEngine) {
  const auto scene = with(algae_scene(0.5, 45), {algae_scene(0.7, 1), algae_scene(0.3, 1)});
  const auto lanes = run_in_lanes(scene);
  const auto scalar = run::run(scene, *test::tables());
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

// Whitecaps send light where no facets do, as steep as they would have to be. Seen red: with the
// ratio of facets' densities, which no float holds there, in what whitecaps send on (scores are
// lost); with a direction to another facet that has no value where there is none (the scalar
// engine's derivative is 7 % off).
TEST(EnvironmentOf, WindKeepsWhatWhitecapsSendOn) {
  const auto scene = read("sensitivity = [\"sea.surface.wind_speed_m_s\"]\n" + ship_instrument +
                          channel("elastic") +
                          "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 10.0 }\n" +
                          water(0.06, 0.1, henyey_greenstein_phase) +
                          "[[environment]]\nset = { \"sea.surface.wind_speed_m_s\" = 10.04 }\n"
                          "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 5.0\ndepth_step_m = 2.0\n" +
                          simulation(4e4, 47));
  const auto lanes = run_in_lanes(scene), scalar = run::run(scene, *test::tables(), {});
  EXPECT_EQ(lanes.lost_not_finite, 0U);
  for (std::size_t i = 0; i < scalar.environment_echo.mean.size(); ++i) {
    EXPECT_NEAR(lanes.environment_echo.mean[i], scalar.environment_echo.mean[i],
                0.2 * scalar.environment_echo.standard_error[i]);
    EXPECT_NEAR(lanes.sensitivity.mean[i], scalar.sensitivity.mean[i],
                0.2 * scalar.sensitivity.standard_error[i]);
  }
}

// Also of runs that go on and of any number of threads. Seen red: with the sums of the environments
// not cleared between batches.
TEST(EnvironmentOf, ThreadsAndSittingsDoNotMatter) {
  auto scene = with(algae_scene(0.5, 46), {algae_scene(0.7, 1)});
  scene.simulation.photons = 40'000;
  scene.simulation.batch_photons = 500;
  run::RunOptions options;
  options.threads = 3;
  options.lanes = isa_of_tests();
  const auto once = run::run(scene, *test::tables(), options);
  auto shorter = scene;
  shorter.simulation.photons = 17'000;
  const auto first = run::run(shorter, *test::tables(), options);
  options.threads = 1;
  options.start = {.state = first.state.value(), .wall_time_s = 0, .file = "old.nc"};
  const auto then = run::run(scene, *test::tables(), options);
  EXPECT_EQ(then.environment_echo.mean, once.environment_echo.mean);
  EXPECT_EQ(then.environment_difference.standard_error, once.environment_difference.standard_error);
  EXPECT_EQ(then.environment_convergence_flags, once.environment_convergence_flags);
}

}  // namespace
}  // namespace photic::test
