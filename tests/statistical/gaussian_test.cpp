// Lasers of a Gaussian profile: what a telescope sees of their beam, and the estimators against
// each other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "support/lidars_over_waves.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// The same instruments with a Gaussian laser.
std::string gaussian(std::string instruments) {
  return instruments.insert(instruments.find("[[telescope]]"), "profile = \"gaussian\"\n");
}
std::string layer(double a_per_m, double b_per_m, double g) {
  return water(a_per_m, b_per_m, fmt::format(R"({{ model = "henyey-greenstein", g = {} }})", g));
}

/// Points at one place that look down with half views of 1/2, 1, 2 and 4 times the divergence.
std::string points_at(double z) {
  constexpr double t_mrad = 5;
  const std::string place =
      fmt::format("position_m = [0.0, 0.0, {}]\ndirection = [0.0, 0.0, -1.0]\n", z);
  std::string out = fmt::format(
      "[source]\nwavelength_nm = 532.0\n{}diameter_m = 1e-6\nhalf_divergence_mrad = {}\n", place,
      t_mrad);
  for (const double views : {0.5, 1.0, 2.0, 4.0})
    out += fmt::format(
        "[[telescope]]\n{}diameter_m = 1e-4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = {}\n",
        place, views * t_mrad);
  return gaussian(out);
}

// 1 - exp(-2 g^2 / t^2) of the first order is seen within the angle g, in every gate: light comes
// back the way that it went. The share of photons in view is binomial; their weights differ by what
// the error of the whole beam shows. Seen red: with a disc; with half the exponent.
TEST(GaussianBeam, IsSeenByItsShareWithinTheView) {
  constexpr double photons = 2e5, seen[] = {0.393469, 0.864665, 0.999665};
  for (const double z : {12.0, -1.0}) {
    const auto r =
        run_in_lanes(read(points_at(z) + channel("elastic") + layer(0.05, 0.1, 0.5) +
                          "[gates]\ndepth_min_m = 3.0\ndepth_max_m = 18.0\ndepth_step_m = 3.0\n" +
                          simulation(photons, 3, "max_order = 1\n")));
    const std::size_t gates = r.gates();
    ASSERT_EQ(r.echo.mean.size(), 4 * gates);
    ZFamily family(0.01);
    for (std::size_t g = 0; g < gates; ++g) {
      const double all = r.echo.mean[3 * gates + g];
      const double error = r.echo.standard_error[3 * gates + g] / all;
      for (std::size_t t = 0; t < 3; ++t)
        family.add(r.echo.mean[t * gates + g] / all, seen[t],
                   std::sqrt(seen[t] * (1 - seen[t]) * (1 / photons + error * error)),
                   fmt::format("{} m, view {}, gate {}", z, t, g));
    }
    std::printf("%g m: %zu shares, rms z %.2f, largest |z| %.2f\n", z, family.size(), family.rms(),
                family.largest());
    family.judge();
  }
}

struct Lit {
  const char* name;
  std::string scene;  ///< but for its [simulation]
  double forward, bidirectional;
  std::size_t least;  ///< cells that are to be compared
};
const std::string gates = "[gates]\ndepth_max_m = 12.0\ndepth_step_m = 2.0\n";

std::vector<Lit> lit_by_gaussians() {
  const Lidar ship{.lens = 0.4, .view_mrad = 40, .divergence_mrad = 10, .laser = 0.04};
  const std::string beside =
      "[[telescope]]\nposition_m = [0.4, 0.1, 12.0]\ndirection = [-0.03, 0.0, -1.0]\n"
      "diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 15.0\n";
  // Of a small lens, and gates away from it: those near a large one in the water have heavy tails.
  const std::string vehicle =
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, -2.0]\n"
      "direction = [0.1, 0.0, -1.0]\ndiameter_m = 0.01\nhalf_divergence_mrad = 60.0\n"
      "[[telescope]]\nposition_m = [0.1, 0.0, -2.0]\ndirection = [0.0, 0.0, -1.0]\n"
      "diameter_m = 0.05\nfocal_length_m = 0.1\nhalf_field_of_view_mrad = 80.0\n";
  const std::string air = "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 3.0\n" +
                          scattering(0.02, 0.2, 0.2);
  const auto biaxial = instrument(ship);
  return {{"flat", gaussian(instrument(ship)) + channel("elastic") + layer(0.06, 0.1, 0.8) + gates,
           4e5, 1e5, 15},
          {"5 m/s",
           gaussian(instrument(ship)) + channel("elastic") +
               sea("model = \"cox-munk\", wind_speed_m_s = 5.0") + layer(0.06, 0.1, 0.8) + gates,
           4e5, 1e5, 15},
          {"biaxial",
           gaussian(biaxial.substr(0, biaxial.find("[[telescope]]")) + beside) +
               channel("elastic") + layer(0.06, 0.1, 0.8) + gates,
           4e5, 1e5, 15},
          {"in the water",
           gaussian(vehicle) + channel("elastic") + layer(0.06, 0.1, 0.6) +
               "[gates]\nrange_min_m = 3.0\nrange_max_m = 9.0\nrange_step_m = 2.0\n",
           4e5, 1e5, 6},
          {"under air",
           gaussian(instrument(ship)) + channel("elastic") + air + "[[sea.layer]]\n" +
               scattering(0.06, 0.2, 0.6) +
               "[gates]\ndepth_min_m = -4.0\ndepth_max_m = 8.0\ndepth_step_m = 2.0\n",
           4e5, 1e5, 15}};
}

/// Adds the cells that both know to 5 % and better.
void add_all(ZFamily& family, const tally::Estimates& a, const tally::Estimates& b,
             const std::string& what) {
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double error = std::hypot(a.standard_error[i], b.standard_error[i]);
    if (error < 0.05 * a.mean[i])
      family.add(a.mean[i], b.mean[i], error, fmt::format("{} {}", what, i));
  }
}

// Gate by gate and order by order, ten families at 0.1 %. Seen red: with the density of
// an even cone at the birth of walks; in connections with the laser; with the axis' density
// everywhere.
TEST(GaussianBeam, BothEstimatorsFindItsLight) {
  for (const Lit& c : lit_by_gaussians()) {
    ZFamily by_gate(0.001), by_order(0.001);
    for (std::uint64_t seed = 41; seed < 41 + seeds_of_tests(); ++seed) {
      const auto run = [&](const char* estimator, double photons) {
        return run_in_lanes(
            read(c.scene + simulation(photons, seed, "max_order = 3\n", estimator)));
      };
      const auto forward = run("forward", c.forward);
      const auto both = run("bidirectional", c.bidirectional);
      EXPECT_EQ(both.lost_not_finite, 0U);
      EXPECT_NEAR(both.ledger.sum(), 1, 5 * both.ledger_standard_error + 1e-6) << c.name;
      add_all(by_gate, forward.echo, both.echo, c.name + std::string(", gate"));
      add_all(by_order, forward.grid("echo_by_order"), both.grid("echo_by_order"),
              c.name + std::string(", order"));
    }
    std::printf("%s: %zu gates, rms z %.2f, largest |z| %.2f; %zu orders, %.2f, %.2f\n", c.name,
                by_gate.size(), by_gate.rms(), by_gate.largest(), by_order.size(), by_order.rms(),
                by_order.largest());
    EXPECT_GE(by_order.size(), c.least) << c.name;
    by_gate.judge();
    by_order.judge();
  }
}

// Light of analog photons is drawn as the forward estimator's, and counted alone.
TEST(GaussianBeam, PhotonsByChanceFindItsLight) {
  const std::string instruments =
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 3.0]\n"
      "direction = [0.1, 0.0, -1.0]\ndiameter_m = 0.05\nhalf_divergence_mrad = 150.0\n"
      "[[telescope]]\nposition_m = [0.3, 0.1, 3.0]\ndirection = [0.0, 0.0, -1.0]\n"
      "diameter_m = 3.0\nfocal_length_m = 6.0\nhalf_field_of_view_mrad = 300.0\n";
  const auto run = [&](const char* estimator, double photons) {
    return run_in_lanes(read(gaussian(instruments) + channel("elastic") + layer(0.05, 0.6, 0.3) +
                             "[gates]\ndepth_max_m = 6.0\ndepth_step_m = 1.0\n" +
                             simulation(photons, 51, "", estimator)));
  };
  expect_same_light(run("analog", 2e6), run("forward", 1e5), "analog photons", 0.06, 10);
}

}  // namespace
}  // namespace photic::test
