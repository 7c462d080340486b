// Problems 1 and 2 of Mobley et al. 1993, Appl. Opt. 32, 7484: deep water under the sun at 60
// degrees, a flat surface of index 1.34 and a black sky. Longer runs: experiments/mobley_1993.py.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "support/absorbers.hpp"
#include "support/lit_scenes.hpp"
#include "support/runs.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// A number of the paper: the mean of several models, their standard deviation over that, and half
/// a unit of its last digit.
struct Published {
  double mean, cv, half_digit;
};
/// Perpendicular irradiance 1; at optical depths 1, 5 and 10.
struct Problem {
  std::string name, phase;
  double a, b;
  std::array<Published, 3> down, up_scalar, up_radiance;
};

// Molecules' 0.06225 (1 + 0.835 cos^2).
const std::string by_molecules = R"({ model = "rayleigh", depolarisation = 0.08992 })";

// As transcribed in github.com/mgimond/aomc, comparison/mobley_problems.
const std::vector<Problem>& problems() {
  static const std::vector<Problem> all{
      {"problem 1, albedo 0.2",
       by_molecules,
       1,
       0.25,
       {{{0.141, 0.001, 5e-4}, {0.00107, 0.005, 5e-6}, {2.93e-6, 0.102, 5e-9}}},
       {{{0.0134, 0.003, 5e-5}, {0.0001, 0.039, 5e-7}, {3e-7, 0.308, 5e-10}}},
       {{{0.00172, 0.044, 5e-6}, {1.37e-5, 0.288, 5e-8}, {3.39e-8, 0.197, 5e-11}}}},
      {"problem 1, albedo 0.9",
       by_molecules,
       1,
       9,
       {{{0.366, 0.002, 5e-4}, {0.0433, 0.003, 5e-5}, {0.00316, 0.015, 5e-6}}},
       {{{0.372, 0.005, 5e-4}, {0.0435, 0.007, 5e-5}, {0.0032, 0.038, 5e-6}}},
       {{{0.0485, 0.015, 5e-5}, {0.00559, 0.052, 5e-6}, {0.000437, 0.091, 5e-7}}}},
      {"problem 2, albedo 0.2",
       "\"petzold\"",
       1,
       0.25,
       {{{0.162, 0, 5e-4}, {0.00227, 0.002, 5e-6}, {1.3e-5, 0.047, 5e-8}}},
       {{{0.000966, 0.023, 5e-7}, {1.37e-5, 0.063, 5e-8}, {7.28e-8, 0.187, 5e-11}}},
       {{{5.47e-5, 0.06, 5e-8}, {6.24e-7, 0.355, 5e-10}, {4.02e-9, 0.248, 5e-12}}}},
      {"problem 2, albedo 0.9",
       "\"petzold\"",
       1,
       9,
       {{{0.413, 0.001, 5e-4}, {0.187, 0.005, 5e-4}, {0.0685, 0.01, 5e-5}}},
       {{{0.0931, 0.021, 5e-5}, {0.0463, 0.017, 5e-5}, {0.0165, 0.014, 5e-5}}},
       {{{0.00699, 0.063, 5e-6}, {0.00329, 0.055, 5e-6}, {0.00121, 0.109, 5e-6}}}}};
  return all;
}

tally::Result solve(const Problem& p, double photons) {
  const double c = p.a + p.b;
  const Heights levels{{1 / c, 5 / c, 10 / c}};
  return run_in_lanes(read(sun_at(60) + tally_of("irradiance", levels) +
                           tally_of("radiance", levels, "direction_deg = [[0, 0]]") +
                           "[sea]\nrefractive_index = 1.34\n" + water(p.a, p.b, p.phase) +
                           simulation(photons, 21)));
}
/// Two coefficients of variation, half a digit and three errors.
void expect_published(const Known& got, const Published& published, const std::string& what) {
  EXPECT_NEAR(got.value, published.mean,
              2 * published.cv * published.mean + published.half_digit + 3 * got.error)
      << what;
  std::printf("%s: %.4g +- %.1g (%.4g, cv %.3f)\n", what.c_str(), got.value, got.error,
              published.mean, published.cv);
}

/// E_d, E_u, scalar down, scalar up and L_u of independent code: means and their errors.
struct Independent {
  std::size_t problem, level;
  std::array<Known, 5> numbers;
};
const std::vector<Independent>& independent_numbers() {
  static const std::vector<Independent> all{
      {0, 0, {{{.14140, 5e-5}, {.006021, 4e-6}, {.19474, 7e-5}, {.01341, 1e-5}, {.0016761, 7e-7}}}},
      {0,
       1,
       {{{.001068, 5e-6}, {4.47e-5, 4e-7}, {.001442, 6e-6}, {9.90e-5, 1.1e-6}, {1.275e-5, 7e-8}}}},
      {1,
       0,
       {{{.36598, 1.9e-4}, {.17341, 1.2e-4}, {.66458, 3.9e-4}, {.37231, 4.4e-4}, {.04871, 3e-5}}}},
      {1,
       2,
       {{{.003154, 1.2e-5},
         {.001485, 6e-6},
         {.005571, 2.5e-5},
         {.003176, 1.8e-5},
         {.000420, 2e-6}}}},
      {3, 0, {{{.41331, 1.3e-4}, {.03567, 8e-5}, {.6194, 4e-4}, {.0924, 4e-4}, {.00678, 5e-5}}}},
      {3, 1, {{{.18789, 2e-4}, {.01699, 5e-5}, {.2985, 4e-4}, {.0463, 2e-4}, {.003143, 1.7e-5}}}},
      {3, 2, {{{.06916, 1.2e-4}, {.006072, 3e-5}, {.1076, 3e-4}, {.0162, 1e-4}, {.001136, 8e-6}}}}};
  return all;
}
/// All irradiances, too. False alarms: one in a hundred.
void judge_independent(const std::vector<tally::Result>& results) {
  const std::array names{"irradiance_down", "irradiance_up", "scalar_irradiance_down",
                         "scalar_irradiance_up", "radiance"};
  ZFamily family(0.01);
  for (const auto& [problem, level, numbers] : independent_numbers())
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Known own = known(results[problem], names[i], level);
      family.add(own.value, numbers[i].value, std::hypot(own.error, numbers[i].error),
                 fmt::format("{}, level {}, {}: {} +- {} for {}", problems()[problem].name, level,
                             names[i], own.value, own.error, numbers[i].value));
    }
  std::printf("independent code: %zu numbers, rms z %.2f\n", family.size(), family.rms());
  family.judge();
}

// All 36 numbers, and those of independent code. Seen red: with no directions drawn about that of
// the radiance (problem 2, albedo 0.9); with radiance of light from both sides of a level, and with
// none that is attenuated on its way.
TEST(Mobley1993, AllNumbers) {
  std::vector<tally::Result> results;
  for (const Problem& p : problems()) {
    const auto& r = results.emplace_back(solve(p, 2e5 * static_cast<double>(seeds_of_tests())));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string where = fmt::format("{}, level {}", p.name, i);
      expect_published(known(r, "irradiance_down", i), p.down[i], where + ", E_d");
      expect_published(known(r, "scalar_irradiance_up", i), p.up_scalar[i], where + ", E_0u");
      expect_published(known(r, "radiance", i), p.up_radiance[i], where + ", L_u");
    }
  }
  judge_independent(results);
}

/// A thousandth, for what follows from the same scores.
void expect_same(double one, double other, const std::string& what) {
  EXPECT_NEAR(one, other, 1e-3 * other) << what;
}

// Radiance at the flat surface: above it what comes from below is T / n^2 of that, and below it
// what goes down is what the mirror sends back, with all light beyond the critical angle. Of the
// same light, so that errors cancel: to a thousandth. Seen red: without 1 / n^2; without the
// mirror.
TEST(Mobley1993, RadianceAtTheSurface) {
  constexpr double n = 1.34;
  const double refracted_deg = std::asin(std::sin(40 * radian_per_degree) / n) / radian_per_degree;
  const std::string directions = fmt::format(
      "direction_deg = [[0, 0], [180, 0], [40, 70], [{}, 70], [{}, 70], [60, 70], "
      "[120, 70]]",
      refracted_deg, 180 - refracted_deg);
  const auto r = run_in_lanes(read(sun_at(60) + tally_of("radiance", {{0}, {0}}, directions) +
                                   fmt::format("[sea]\nrefractive_index = {}\n", n) +
                                   water(1, 1, "\"isotropic\"") + simulation(5e4, 22)));
  const auto above = [&](std::size_t direction) {
    return known(r, "radiance", 2 * direction).value;
  };
  const auto below = [&](std::size_t direction) {
    return known(r, "radiance", 2 * direction + 1).value;
  };
  const double straight = refracted(1, n).first;
  const double aslant = refracted(std::cos(40 * radian_per_degree), n).first;
  expect_same(above(0), (1 - straight) / (n * n) * below(0), "straight up, above");
  expect_same(below(1), straight * below(0), "straight down, below");
  expect_same(above(2), (1 - aslant) / (n * n) * below(3), "aslant, above");
  expect_same(below(4), aslant * below(3), "aslant, below");
  expect_same(below(6), below(5), "in total reflection");
  for (const std::size_t down : {1U, 4U, 6U}) EXPECT_EQ(above(down), 0);  // the sky is black
}

}  // namespace
}  // namespace photic::test
