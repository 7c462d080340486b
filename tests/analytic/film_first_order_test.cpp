// Light of the water that is scattered or converted once, seen through a film of oil. Over the
// clean sea whole runs are held against the lidar equation (first_order_test.cpp); a film changes
// nothing in it but what passes the surface, on the way in and on the way out. The clean sea is an
// environment of the same photons, so that what is left of its echo is known to far below 0.1 %.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/constants.hpp"
#include "optics/data_folder.hpp"
#include "optics/library.hpp"
#include "optics/oil.hpp"
#include "optics/refractive_index.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

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
  const optics::Library library(optics::find_data_folder());
  const auto oil = optics::oil(library, "weakly-absorbing-crude");
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

}  // namespace
}  // namespace photic::test
