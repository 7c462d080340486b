// Light of the water that is scattered or converted once, seen through a film of oil. Over the
// clean sea whole runs are held against the lidar equation (first_order_test.cpp); a film changes
// nothing in it but what passes the surface, on the way in and on the way out. The clean sea is an
// environment of the same photons, so that what is left of its echo is known to far below 0.1 %.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/constants.hpp"
#include "optics/library.hpp"
#include "optics/oil.hpp"
#include "optics/refractive_index.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::test {
namespace {

/// Fresnel's reflectance of two media, of one polarisation: 0 across the plane of incidence.
double reflectance(double n1, double n2, double sine_in_air, int polarisation) {
  const double c1 = std::sqrt(1 - std::pow(sine_in_air / n1, 2));
  const double c2 = std::sqrt(1 - std::pow(sine_in_air / n2, 2));
  const double a = polarisation == 0 ? n1 * c1 : n2 * c1;
  const double b = polarisation == 0 ? n2 * c2 : n1 * c2;
  return std::pow((a - b) / (a + b), 2);
}
/// What passes a film between air and water, light added up reflection by reflection; `optical`:
/// absorption times thickness.
double passes_film(double oil, double water, double optical, double sine_in_air) {
  const double x = std::exp(-optical / std::sqrt(1 - std::pow(sine_in_air / oil, 2)));
  double both = 0;
  for (const int polarisation : {0, 1}) {
    const double r1 = reflectance(1, oil, sine_in_air, polarisation);
    const double r2 = reflectance(oil, water, sine_in_air, polarisation);
    double inside = (1 - r1) * x;
    for (int bounce = 0; bounce < 20; ++bounce) {
      both += 0.5 * inside * (1 - r2);
      inside *= r2 * x * r1 * x;
    }
  }
  return both;
}
double passes_bare(double water, double sine_in_air) {
  return 1 - 0.5 * (reflectance(1, water, sine_in_air, 0) + reflectance(1, water, sine_in_air, 1));
}

// Seen red: with the laser's wavelength for the way out; with the way out alone.
TEST(FirstOrder, ThroughAFilmOfOil) {
  constexpr double laser = 355, thickness = 2;
  const auto oil = optics::oil(*test::tables(), "weakly-absorbing-crude");
  for (const double deg : {0.0, 40.0}) {
    const double sine = std::sin(deg * radian_per_degree);
    const std::string place =
        fmt::format("position_m = [0.0, 0.0, 12.0]\ndirection = [{:.15g}, 0.0, {:.15g}]\n", sine,
                    -std::cos(deg * radian_per_degree));
    const std::string scene = fmt::format(
        "[[environment]]\nname = \"clean\"\nset = {{ \"oil.thickness_um\" = 0.0 }}\n"
        "[source]\nwavelength_nm = {0}\n{1}diameter_m = 0.01\nhalf_divergence_mrad = 0.2\n"
        "[[telescope]]\n{1}diameter_m = 0.2\nfocal_length_m = 1.0\n"
        "half_field_of_view_mrad = 1.0\n{2}{3}"
        "[oil]\nclass = \"weakly-absorbing-crude\"\nthickness_um = {4}\n"
        "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n"
        "[gates]\ndepth_max_m = 6.0\ndepth_step_m = 2.0\n",
        laser, place, channel("elastic"), channel("raman"), thickness);
    for (const std::string estimator : {"forward", "bidirectional"}) {
      const auto r = run_in_lanes(read(scene + simulation(1e5, 5, "max_order = 1\n", estimator)));
      for (std::size_t c = 0; c < r.channels(); ++c) {
        const auto through = [&](double nm) {
          const double water = optics::refractive_index(nm, 35, 20);
          return passes_film(oil.refractive_index(nm), water,
                             oil.absorption_per_m(nm) * thickness * 1e-6, sine) /
                 passes_bare(water, sine);
        };
        const double left = through(laser) * through(r.channel_wavelength_nm[c]);
        for (std::size_t g = 0; g < r.gates(); ++g) {
          const std::size_t i = c * r.gates() + g;
          EXPECT_NEAR(r.echo.mean[i] / (r.environment_echo.mean[i] * left), 1, 1e-3)
              << estimator << ", " << deg << " degrees, channel " << c << ", gate " << g;
        }
      }
    }
  }
}

/// Fluence at a depth under waves over that of light straight from above, by facets of the slopes
/// that a Gaussian has, alike to all sides; passes(sine): through one, by the sine of the angle to
/// its normal in the air. Water of `index` attenuates by c [1/m].
template <class Passes>
double fluence(double depth, double deviation, double index, double c, Passes passes) {
  constexpr int steps = 2000;
  constexpr double widest = 6;  // deviations
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double u = widest * (k + 0.5) / steps;
    const double in = std::atan(u * deviation), sine = std::sin(in);
    const double steep = std::cos(in - std::asin(sine / index));
    sum += u * std::exp(-u * u / 2) * passes(sine) * std::exp(-c * depth / steep) / steep;
  }
  return sum * widest / steps;
}

// From so high that all light leaves and comes straight down: then facets by which it comes in and
// goes out do not know of each other, and a film counts by the mean over slopes for each. Light is
// scattered alike to all sides. Seen red: with the film of level facets (0.4 to 0.6 %).
TEST(FirstOrder, ThroughAFilmOfOilOnWaves) {
  constexpr double laser = 355, thickness = 8, deviation = 0.15, a = 0.1, b = 0.1, height = 2000;
  constexpr double lens = 0.5, nearest = 0.5, farthest = 12.5;
  const auto oil = optics::oil(*test::tables(), "weakly-absorbing-crude");
  const std::string scene = fmt::format(
      "[[environment]]\nname = \"clean\"\nset = {{ \"oil.thickness_um\" = 0.0 }}\n"
      "[source]\nwavelength_nm = {0}\n{1}diameter_m = 0.01\nhalf_divergence_mrad = 0.05\n"
      "[[telescope]]\n{1}diameter_m = {2}\nfocal_length_m = 1.0\n"
      "half_field_of_view_mrad = 10.0\n{3}{4}"
      "[oil]\nclass = \"weakly-absorbing-crude\"\nthickness_um = {5}\n"
      "[sea]\nsurface = {{ model = \"gaussian\", upwind_slope_variance = {6}, "
      "crosswind_slope_variance = {6} }}\n[[sea.layer]]\n"
      "iop = [ {{ wavelength_nm = 355.0, a_per_m = {7}, b_per_m = {8} }}, "
      "{{ wavelength_nm = 500.0, a_per_m = {7}, b_per_m = {8} }} ]\n"
      "phase_function = {{ model = \"isotropic\" }}\n"
      "[gates]\ndepth_min_m = {9}\ndepth_max_m = {10}\ndepth_step_m = {11}\n",
      laser, "position_m = [0.0, 0.0, 2000.0]\ndirection = [0.0, 0.0, -1.0]\n", lens,
      channel("elastic"), channel("raman"), thickness, deviation * deviation, a, b, nearest,
      farthest, farthest - nearest);
  const auto through = [&](double nm, double depth, bool film) {
    const double water = optics::refractive_index(nm, 35, 20);
    return fluence(depth, deviation, water, a + b, [&](double sine) {
      return film ? passes_film(oil.refractive_index(nm), water,
                                oil.absorption_per_m(nm) * thickness * 1e-6, sine)
                  : passes_bare(water, sine);
    });
  };
  const auto over_depth = [&](double nm, bool film) {
    constexpr int steps = 60;
    const double step = (farthest - nearest) / steps;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
      const double depth = nearest + (k + 0.5) * step;
      const double far = height + depth / optics::refractive_index(nm, 35, 20);
      sum += step * through(laser, depth, film) * through(nm, depth, film) / (far * far);
    }
    return sum;
  };
  const double n = optics::refractive_index(laser, 35, 20);
  const double elastic = pi * lens * lens / 4 * b / (4 * pi * n * n) * over_depth(laser, true);
  for (const std::string estimator : {"forward", "bidirectional"}) {
    const auto r = run_in_lanes(read(scene + simulation(4e5, 5, "max_order = 1\n", estimator)));
    ASSERT_EQ(r.gates(), 1U);
    const double error = r.echo.standard_error[0];
    EXPECT_NEAR(r.echo.mean[0], elastic, 3 * error + 1e-3 * elastic) << estimator;
    EXPECT_LT(error, 0.01 * elastic) << estimator;
    for (std::size_t c = 0; c < r.channels(); ++c) {
      const double nm = r.channel_wavelength_nm[c];
      const double left = over_depth(nm, true) / over_depth(nm, false);
      EXPECT_NEAR(r.echo.mean[c] / (r.environment_echo.mean[c] * left), 1, 1e-3)
          << estimator << ", channel " << c;
    }
  }
}

}  // namespace
}  // namespace photic::test
