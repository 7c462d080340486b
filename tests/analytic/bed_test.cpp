// Light that goes straight to the sea bed and straight back, against its closed form, in water that
// does not scatter.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "core/constants.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

constexpr double index = 1.34, height = 12.0, lens = 0.1;

struct Bed {
  double zenith_deg, albedo, depth, c;
};

double transmittance(double from, double to) {
  if (from == 0) return 4 * index / ((1 + index) * (1 + index));
  const double s = std::sin(from - to) / std::sin(from + to);
  const double p = std::tan(from - to) / std::tan(from + to);
  return 1 - (s * s + p * p) / 2;
}

/// Photons detected by a lens across the axis per photon sent along it: transmitted twice,
/// reflected by rho cos / pi, into the solid angle that the refracted lens has from the bed. With r
/// the horizontal distance of a ray that leaves the bed under t, dA = cos(air) r dr dphi and dOmega
/// = sin(t) dt dphi.
double expected(const Bed& bed) {
  const double air = bed.zenith_deg * pi / 180;
  const double water = std::asin(std::sin(air) / index);
  const double in_air = height / std::cos(air), in_water = bed.depth / std::cos(water);
  const double through = transmittance(air, water) * std::exp(-bed.c * in_water);
  // r / sin(t) and dr / dt.
  const double radius = index * in_air + in_water;
  const double slope =
      in_air / std::cos(air) * index * std::cos(water) / std::cos(air) + in_water / std::cos(water);
  const double area_per_solid_angle = std::cos(air) * radius * slope;
  const double reflected = bed.albedo * std::cos(water) / pi;
  return through * through * reflected * pi * lens * lens / area_per_solid_angle;
}

std::string scene_over(const Bed& bed) {
  const double angle = bed.zenith_deg * pi / 180;
  const auto place = fmt::format("position_m = [1.0, 2.0, {}]\ndirection = [{}, {}, {}]\n", height,
                                 0.6 * std::sin(angle), 0.8 * std::sin(angle), -std::cos(angle));
  return "[source]\nwavelength_nm = 532.0\ndiameter_m = 1e-4\nhalf_divergence_mrad = 0.05\n" +
         place + "[[telescope]]\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 40.0\n" +
         fmt::format("diameter_m = {}\n", 2 * lens) + place + channel("elastic") +
         fmt::format("[sea]\nrefractive_index = {}\n", index) +
         fmt::format(
             "[[sea.layer]]\nbottom_depth_m = {}\niop = [ {{ wavelength_nm = 532.0, "
             "a_per_m = {}, b_per_m = 0.0 }} ]\nphase_function = {}\n",
             bed.depth, bed.c, henyey_greenstein_phase) +
         fmt::format("[bottom]\nalbedo = {}\n", bed.albedo) +
         fmt::format("[gates]\ndepth_min_m = {}\ndepth_max_m = {}\ndepth_step_m = 1.0\n",
                     bed.depth - 1.5, bed.depth + 1.5);
}

// The first two are numbers worked out apart from this. Seen red: with the cosine left out of
// the density of Lambert's law.
TEST(SeaBed, ReflectsWhatTheLidarEquationSays) {
  const double half_lens = lens / 0.2;  // they have a lens of 0.2 m in radius
  EXPECT_NEAR(expected({0, 0.2, 5, 0.1}), 6.34630e-6 * half_lens * half_lens, 1e-11);
  EXPECT_NEAR(expected({0, 0.2, 10, 0.16}), 4.59408e-7 * half_lens * half_lens, 1e-12);
  for (const Bed& bed : {Bed{0, 0.2, 5, 0.1}, Bed{0, 0.2, 10, 0.16}, Bed{30, 0.2, 5, 0.1},
                         Bed{30, 0.9, 8, 0.3}, Bed{55, 0.35, 3, 0.5}}) {
    for (const char* estimator : {"forward", "bidirectional"}) {
      SCOPED_TRACE(fmt::format("{}, {} degrees", estimator, bed.zenith_deg));
      const auto r = run_in_lanes(read(scene_over(bed) + simulation(6e5, 5, "", estimator)));
      const double error = r.echo.standard_error[1] / expected(bed);
      EXPECT_LT(error, 5e-4);
      EXPECT_NEAR(r.echo.mean[1] / expected(bed), 1, std::min(1e-3, 3.5 * error + 5e-5));
      EXPECT_EQ(r.echo.mean[0], 0);
      EXPECT_EQ(r.echo.mean[2], 0);
      EXPECT_EQ(r.process_names(), (std::vector<std::string>{"elastic", "bottom"}));
      EXPECT_EQ(r.grid("echo_by_process").mean[r.gates() + 1], r.echo.mean[1]);
      EXPECT_EQ(r.grid("echo_by_order").mean[r.gates() + 1], r.echo.mean[1]);
    }
  }
}

}  // namespace
}  // namespace photic::test
