// One-dimensional waves in environments, and derivatives by them, against runs of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "support/films.hpp"
#include "support/lidars_over_waves.hpp"
#include "support/own_runs.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

const std::string paper = "model = \"paper\", wind_direction_deg = 0.0, wind_speed_m_s = ";
const std::string five_gates =
    "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 9.0\ndepth_step_m = 2.0\n";
const std::string ranges = "[gates]\nrange_min_m = 0.0\nrange_max_m = 8.0\nrange_step_m = 1.0\n";
const std::string some_water =
    "[[sea.layer]]\niop = [ { wavelength_nm = 350.0, a_per_m = 0.06, b_per_m = 0.3 }, "
    "{ wavelength_nm = 700.0, a_per_m = 0.06, b_per_m = 0.3 } ]\n"
    "phase_function = { model = \"henyey-greenstein\", g = 0.5 }\n";
std::string under_water(bool laser_looks_up) {
  const double up = laser_looks_up ? 1.0 : -1.0;
  return fmt::format(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, -3.0]\n"
      "direction = [0.0, 0.0, {}]\ndiameter_m = 0.04\nhalf_divergence_mrad = 50.0\n"
      "[[telescope]]\nposition_m = [0.0, 0.0, -3.0]\ndirection = [0.0, 0.0, {}]\n"
      "diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 300.0\n",
      up, -up);
}

/// A scene whose surface is `here`, and what `set` changes in it: to the surface `there`.
struct Case {
  std::string name, lidar, here, there, set, gates, estimator;
  double photons;
  std::size_t least;  ///< cells that are to be compared
  std::string oil{}, other_oil{};
  std::string more{};  ///< of the simulation
  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};
class WavesInLine : public testing::TestWithParam<Case> {};

// Facets that lead to a lens from a point in the water, or from the surface itself, those of walks,
// whitecaps and films.
// Seen red: without the slopes of facets that are drawn between bounds (forward); with the points
// of facets in line for those of whitecaps, and the other way round (forward; a telescope in the
// water); without the facets of walks (bidirectional).
TEST_P(WavesInLine, OfAnEnvironmentAreThoseOfItsOwnRun) {
  const Case& c = GetParam();
  const auto run = [&](const std::string& surface, const std::string& oil, const std::string& more,
                       std::uint64_t seed) {
    const std::string settings = c.estimator == "forward" ? "" : no_free_walks;
    return run_in_lanes(read(c.lidar + oil + sea(surface) + some_water + c.gates + more +
                             simulation(c.photons, seed, c.more + settings, c.estimator)));
  };
  const auto all = run(c.here, c.oil, "[[environment]]\nset = { " + c.set + " }\n", 41);
  expect_environment_is(all, run(c.there, c.other_oil, "", 42), c.least);
}

std::vector<Case> cases() {
  const std::string elastic = channel("elastic");
  const std::string ship =
      instrument(
          {.off_nadir = 10, .lens = 0.4, .view_mrad = 40, .divergence_mrad = 10, .laser = 0.04}) +
      elastic;
  const std::string slanting =
      instrument({.height = 2, .off_nadir = 80, .lens = 1, .divergence_mrad = 50, .laser = 0.04}) +
      elastic;
  const std::string white = ", whitecap_fraction = ";
  const std::string set_both =
      R"("sea.surface.wind_speed_m_s" = 2.0, "sea.surface.whitecap_fraction" = 0.03)";
  const std::string across =
      "model = \"gaussian\", upwind_slope_variance = 0.0, crosswind_slope_variance = ";
  const std::string set_across = "\"sea.surface.crosswind_slope_variance\" = 0.012";
  const std::string oily = instrument(12, 15, 355) + of_water + channel("oil");
  const std::string set_film = "\"oil.thickness_um\" = 3.0, \"sea.surface.wind_speed_m_s\" = 3.0";
  std::vector<Case> out;
  for (const std::string by : {"forward", "bidirectional"}) {
    const bool forward = by == "forward";
    out.push_back({"white_" + by, ship, paper + "5.0" + white + "0.1",
                   paper + "2.0" + white + "0.03", set_both, five_gates, by, forward ? 4e5 : 2e5,
                   5});
    out.push_back({"film_" + by, oily, paper + "5.0", paper + "3.0", set_film, five_gates, by,
                   forward ? 5e5 : 1e5, 8, film(12), film(3)});
  }
  out.push_back(
      {"slanting", slanting,
       "model = \"gaussian\", crosswind_slope_variance = 0.0, upwind_slope_variance = 0.08",
       "model = \"gaussian\", crosswind_slope_variance = 0.0, upwind_slope_variance = 0.012",
       "\"sea.surface.upwind_slope_variance\" = 0.012",
       "[gates]\nrange_min_m = 8.0\nrange_max_m = 32.0\nrange_step_m = 4.0\n", "forward", 4e5, 2});
  for (const bool up : {false, true})
    out.push_back({up ? "laser_up" : "laser_down", under_water(up) + elastic,
                   across + "0.04" + white + "0.1", across + "0.012" + white + "0.03",
                   set_across + ", \"sea.surface.whitecap_fraction\" = 0.03", ranges,
                   "bidirectional", 4e5, 5, "", "", up ? "" : "max_order = 1\n"});
  return out;
}
INSTANTIATE_TEST_SUITE_P(, WavesInLine, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

// Derivatives by wind and whitecaps, or by wind and film, are differences over the same histories.
// Seen red: with the rows of waves that differ for a derivative counted twice; those of films too.
void expect_derivatives(const std::string& estimator, const std::string& lidar,
                        const std::string& surface, const std::string& other, double value) {
  constexpr double wind = 5, step = 1e-3;
  constexpr double other_step = 0.02;  // floats hardly see less of a film's reflection
  const auto environment = [](const std::string& path, double is) {
    return fmt::format("[[environment]]\nset = {{ \"{}\" = {} }}\n", path, is);
  };
  std::string environments;
  for (const double sign : {1.0, -1.0})
    environments += environment("sea.surface.wind_speed_m_s", wind * (1 + sign * step));
  for (const double sign : {1.0, -1.0})
    environments += environment(other, value * (1 + sign * other_step));
  const auto r = run_in_lanes(
      read(fmt::format("sensitivity = [\"sea.surface.wind_speed_m_s\", \"{}\"]\n", other) + lidar +
           sea(surface) + some_water + five_gates + environments +
           simulation(5e4, 43, estimator == "forward" ? "" : no_free_walks, estimator)));
  expect_derivative_by_steps(r, 0, 0, wind * step, estimator + ", wind");
  expect_derivative_by_steps(r, 1, 2, value * other_step, estimator + ", " + other);
}
TEST(DerivativesByWavesInLine, AreThoseThatSmallStepsHave) {
  const std::string lidar =
      instrument(
          {.off_nadir = 10, .lens = 0.4, .view_mrad = 40, .divergence_mrad = 10, .laser = 0.04}) +
      channel("elastic");
  for (const std::string estimator : {"forward", "bidirectional"}) {
    expect_derivatives(estimator, lidar, paper + "5.0, whitecap_fraction = 0.1",
                       "sea.surface.whitecap_fraction", 0.1);
    expect_derivatives(estimator, lidar + film(3), paper + "5.0", "oil.thickness_um", 3);
  }
}

// Far off nadir facets make much of a film's light, of any waves.
// Seen red: without the slopes of the facets that emit (1.0 times the scene's light for 0.6).
TEST(LightOfAFilm, InAnEnvironmentOfOtherWavesIsThatOfItsOwnRun) {
  const std::string lidar = instrument(6, 75, 355) + channel("oil") + film(3, "yield = 0.02\n");
  const auto run = [&](double along, double across, const std::string& more, std::uint64_t seed) {
    return run_in_lanes(
        read(lidar +
             sea(fmt::format("model = \"gaussian\", upwind_slope_variance = {}, "
                             "crosswind_slope_variance = {}",
                             along, across)) +
             clear_water + "[gates]\nrange_min_m = 0.0\nrange_max_m = 60.0\nrange_step_m = 60.0\n" +
             more + simulation(1e5, seed)));
  };
  for (const double across : {0.0, 0.01}) {
    const std::string set =
        "[[environment]]\nset = { \"sea.surface.upwind_slope_variance\" = 0.02 }\n";
    const auto all = run(0.08, across, set, 44);
    EXPECT_LT(all.environment_echo.mean[0], 0.8 * all.echo.mean[0]);
    expect_environment_is(all, run(0.02, across, "", 45), 1);
  }
}

}  // namespace
}  // namespace photic::test
