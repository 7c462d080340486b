// Films of oil as environments, and derivatives by them, against runs of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/films.hpp"
#include "support/own_runs.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

struct OtherFilm {
  const char* name;
  std::string set, own;
};
const std::vector<OtherFilm>& other_films() {
  static const std::vector<OtherFilm> all{
      {"thinner", "\"oil.thickness_um\" = 3.0", film(3)},
      {"none", "\"oil.thickness_um\" = 0.0", film(0)},
      {"darker", "\"oil.absorption_factor\" = 2.5", film(12, "absorption_factor = 2.5\n")},
      {"brighter", "\"oil.yield\" = 0.05", film(12, "yield = 0.05\n")}};
  return all;
}

// Films of environments are those of their own runs: flat and on waves, of all light.
// Seen red: with the crossings left out, of all ways, of walks' legs, or of ways to telescopes;
// with the emission's ratio left out.
void expect_films_are_their_own_runs(const std::string& lidar, const std::string& surface,
                                     const std::string& estimator, double photons,
                                     std::size_t least) {
  const auto scene = [&](const std::string& oil, const std::string& more, std::uint64_t seed) {
    return read(lidar + oil + "[sea]\nsurface = { " + surface + " }\n" + clear_water +
                "[gates]\ndepth_min_m = -1.0\ndepth_max_m = 8.0\ndepth_step_m = 3.0\n" + more +
                simulation(photons, seed, "", estimator));
  };
  std::string environments;
  for (const auto& f : other_films())
    environments += fmt::format("[[environment]]\nname = \"{}\"\nset = {{ {} }}\n", f.name, f.set);
  const auto all = run_in_lanes(scene(film(12), environments, 21));
  ZFamily family(0.01);
  for (std::size_t e = 0; e < other_films().size(); ++e)
    compare_environment(all, e, run_in_lanes(scene(other_films()[e].own, "", 22 + e)), family,
                        other_films()[e].name);
  std::printf("%s, %s: %zu cells, rms z %.2f\n", estimator.c_str(), surface.c_str(), family.size(),
              family.rms());
  EXPECT_GE(family.size(), least);
  family.judge();
}
TEST(OilFilm, OfEnvironmentsIsThatOfItsOwnRun) {
  const std::string lidar = instrument(12, 15, 355) + of_water + channel("oil");
  expect_films_are_their_own_runs(lidar, flat, "forward", 1e6, 20);
  expect_films_are_their_own_runs(lidar, waves, "forward", 1e6, 10);
}
TEST(OilFilm, OfEnvironmentsIsThatOfItsOwnRunByWalks) {
  const std::string lidar = instrument(12, 15, 355) + of_water + channel("oil");
  expect_films_are_their_own_runs(lidar, flat, "bidirectional", 6e4, 16);
  expect_films_are_their_own_runs(lidar, waves, "bidirectional", 6e4, 16);
}

// Seen red: without the air on the film's light's way up (0.55 times the light for 0.3).
TEST(OilFilm, UnderOtherAirIsThatOfItsOwnRun) {
  const auto run = [](double absorption, const std::string& more, std::uint64_t seed) {
    return run_in_lanes(read(
        instrument(10, 15, 355) + channel("oil") + film(3) +
        fmt::format("[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 20.0\niop = [ "
                    "{{ wavelength_nm = 350.0, a_per_m = {0}, b_per_m = 0.002 }}, "
                    "{{ wavelength_nm = 700.0, a_per_m = {0}, b_per_m = 0.002 }} ]\n",
                    absorption) +
        clear_water + "[gates]\nrange_min_m = 0.0\nrange_max_m = 20.0\nrange_step_m = 20.0\n" +
        more + simulation(5e4, seed, "", "forward")));
  };
  const auto all = run(0.02,
                       "[[environment]]\nset = { \"atmosphere.layer.0.iop.0.a_per_m\" = 0.08, "
                       "\"atmosphere.layer.0.iop.1.a_per_m\" = 0.08 }\n",
                       31);
  ZFamily family(0.01);
  compare_environment(all, 0, run(0.08, "", 32), family, "darker air");
  EXPECT_EQ(family.size(), 1U);
  family.judge();
}

// The derivative by the thickness is that of films a little thicker and thinner.
void expect_derivatives_by_the_film(const std::string& estimator, double photons) {
  const auto r = run_in_lanes(read("sensitivity = [\"oil.thickness_um\", \"oil.yield\"]\n" +
                                   instrument(12, 15, 355) + of_water + channel("oil") +
                                   film(5, "yield = 0.02\n") + clear_water + two_gates +
                                   "[[environment]]\nset = { \"oil.thickness_um\" = 5.05 }\n"
                                   "[[environment]]\nset = { \"oil.thickness_um\" = 4.95 }\n" +
                                   simulation(photons, 11, "", estimator)));
  const std::size_t cells = r.echo.mean.size();
  expect_derivative_by_steps(r, 0, 0, 0.05, estimator);
  for (std::size_t i = 0; i < cells; ++i) {
    const bool of_oil = i / r.gates() == 2;
    const double by_yield = r.sensitivity.mean[cells + i] * 0.02;
    EXPECT_NEAR(by_yield, of_oil ? r.echo.mean[i] : 0, 1e-4 * r.echo.mean[i]) << i;
  }
}
TEST(OilFilm, HasDerivativesByItsThickness) {
  expect_derivatives_by_the_film("forward", 1e5);
  expect_derivatives_by_the_film("bidirectional", 2e4);
}

}  // namespace
}  // namespace photic::test
