// Lidars over waves, and what their echoes have to be whatever estimator finds them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"
#include "tally/result.hpp"

namespace photic::test {

/// Laser and telescope at one place, looking off nadir towards an azimuth [degrees].
struct Lidar {
  double height = 12, off_nadir = 0, azimuth = 0, lens = 0.04, view_mrad = 400, divergence_mrad = 1;
  double laser = 1e-6;  ///< its diameter
};
inline std::string instrument(const Lidar& l) {
  const double t = l.off_nadir * radian_per_degree, a = l.azimuth * radian_per_degree;
  const std::string place =
      fmt::format("position_m = [0.0, 0.0, {}]\ndirection = [{:.15g}, {:.15g}, {:.15g}]\n",
                  l.height, std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), -std::cos(t));
  return fmt::format(
      "[source]\nwavelength_nm = 532.0\n{0}diameter_m = {1}\nhalf_divergence_mrad = {2}\n"
      "[[telescope]]\n{0}diameter_m = {3}\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = {4}\n",
      place, l.laser, l.divergence_mrad, l.lens, l.view_mrad);
}
inline std::string sea(const std::string& surface, const std::string& more = "") {
  return fmt::format("[sea]\nsurface = {{ {} }}\n{}", surface, more);
}

/// Light scattered once between 4 and 8 m, through slopes of 0.18 and 0.12: 7.1264e-6 photons for
/// each (six other ways to compute it agree). `more`: of the simulation.
inline scene::Scene single_scattering_through_waves(double photons, const std::string& more,
                                                    const std::string& estimator) {
  return read(instrument({.lens = 2, .view_mrad = 120, .divergence_mrad = 20}) +
              channel("elastic") +
              sea("model = \"gaussian\", upwind_slope_variance = 0.0324, "
                  "crosswind_slope_variance = 0.0144",
                  "refractive_index = 1.34\ngroup_index = 1.34\n") +
              water(0.06, 0.10, R"({ model = "henyey-greenstein", g = 0.5 })") +
              "[gates]\ndepth_max_m = 30.0\ndepth_step_m = 30.0\ndepth_cells = 15\n" +
              simulation(photons, 6, "max_order = 1\n" + more, estimator));
}
/// `within`: the error has to be smaller.
inline void expect_single_scattering(const tally::Result& r, double within) {
  double mean = 0, squares = 0;
  for (const std::size_t cell : {2U, 3U}) {
    mean += r.grid("echo_by_depth").mean[cell];
    squares += std::pow(r.grid("echo_by_depth").standard_error[cell], 2);
  }
  EXPECT_EQ(r.grid("echo_by_depth").grid.axes.front().edges[2], 4);
  EXPECT_NEAR(mean, 7.1264e-6, 4 * std::hypot(std::sqrt(squares), 0.4e-9));
  EXPECT_LT(std::sqrt(squares), within);
}

/// The echo in an environment is that of its own run, in so many cells at least.
inline void expect_environment_is(const tally::Result& all, const tally::Result& own,
                                  std::size_t least) {
  ZFamily family(0.01);
  for (std::size_t i = 0; i < own.echo.mean.size(); ++i) {
    const double error =
        std::hypot(all.environment_echo.standard_error[i], own.echo.standard_error[i]);
    if (!(error < 0.1 * own.echo.mean[i])) continue;
    family.add(all.environment_echo.mean[i], own.echo.mean[i], error, fmt::format("cell {}", i));
  }
  EXPECT_GE(family.size(), least);
  family.judge();
}

}  // namespace photic::test
