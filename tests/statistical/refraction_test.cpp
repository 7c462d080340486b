// Air that bends light, whole runs of both estimators.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "optics/fresnel.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

constexpr double height = 3000, low_top = 100, low_index = 1.001, tilt_deg = 50;
constexpr double water_index = 1.34, absorption = 0.05, scattering = 0.02;

/// A lidar 50 degrees off nadir, over 100 m of dense air below thin air.
std::string scene_text(bool refraction) {
  const double tilt = tilt_deg * radian_per_degree;
  const std::string clear = "iop = [ { wavelength_nm = 532.0, a_per_m = 0.0, b_per_m = 1e-9 } ]\n";
  return fmt::format(
             "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, {0}]\n"
             "direction = [{1}, 0.0, {2}]\ndiameter_m = 0.04\nhalf_divergence_mrad = 0.2\n"
             "[[telescope]]\nposition_m = [0.0, 0.0, {0}]\ndirection = [{1}, 0.0, {2}]\n"
             "diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 5.0\n",
             height, std::sin(tilt), -std::cos(tilt)) +
         fmt::format("[atmosphere]\nrefraction = {}\n", refraction) +
         fmt::format(
             "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = {}\n"
             "refractive_index = {}\n",
             low_top, low_index) +
         clear +
         fmt::format("[[atmosphere.layer]]\nbottom_height_m = {}\ntop_height_m = 4000.0\n",
                     low_top) +
         clear + fmt::format("[sea]\nrefractive_index = {}\ngroup_index = 1.36\n", water_index) +
         fmt::format(
             "[[sea.layer]]\niop = [ {{ wavelength_nm = 532.0, a_per_m = {}, "
             "b_per_m = {} }} ]\nphase_function = {{ model = \"isotropic\" }}\n",
             absorption, scattering) +
         channel("elastic") + depth_gates(10, 5);
}

/// Light that is scattered once per metre of depth, but for constants. D(p) is how far from below
/// the lens a ray with p = n sin(theta) comes to its depth.
double first_order(double depth, bool refraction) {
  const double sine = std::sin(tilt_deg * radian_per_degree);
  const double low = refraction ? low_index : 1, water = water_index * low;
  const auto aside = [&](double p) {
    const auto part = [p](double thickness, double n) {
      return thickness * p / std::sqrt(n * n - p * p);
    };
    return part(height - low_top, 1) + part(low_top, low) + part(depth, water);
  };
  constexpr double small = 1e-5;
  const double d_aside = (aside(sine + small) - aside(sine - small)) / (2 * small);
  const double sine_water = sine / water, cosine_water = std::sqrt(1 - sine_water * sine_water);
  const double cosine_low = std::sqrt(1 - sine * sine / (low * low));
  const double passes = 1 - optics::fresnel_reflectance(1.0, water_index, cosine_low, cosine_water);
  const double per_solid_angle = aside(sine) * d_aside * water * cosine_water / sine_water;
  return passes * passes / per_solid_angle / cosine_water *
         std::exp(-2 * (absorption + scattering) * depth / cosine_water);
}
double of_gate(double from, bool refraction) {
  double sum = 0;
  for (int i = 0; i < 200; ++i) sum += first_order(from + (i + 0.5) * 5 / 200, refraction);
  return sum;
}

// By how much the echo of first order is weaker: the lens is seen from farther away, and aslant.
// And when it comes: by way of the bent axis. Seen red: with the angle of the axis as it is at the
// instrument; with the path from where that seems to stand; with instruments as far away as their
// axes are long.
TEST(Refraction, BendsTheAxesAsSnellsLawHasIt) {
  const double sine = std::sin(tilt_deg * radian_per_degree);
  const double straight = height / std::cos(tilt_deg * radian_per_degree);
  const double low_cosine = std::sqrt(1 - sine * sine / (low_index * low_index));
  const double bent = (height - low_top) / height * straight + low_index * low_top / low_cosine;
  for (const auto& [estimator, photons, within] :
       {std::tuple("forward", 1e6, 1e-4), {"bidirectional", 2e5, 5e-4}}) {
    const std::string run = simulation(photons, 7, "", estimator);
    const auto with = run_in_lanes(read(scene_text(true) + run));
    const auto without = run_in_lanes(read(scene_text(false) + run));
    EXPECT_NEAR(with.gate_time_edge_ns[0] * metre_per_nanosecond, 2 * bent, 1e-6);
    EXPECT_NEAR(without.gate_time_edge_ns[0] * metre_per_nanosecond,
                2 * (straight + (low_index - 1) * low_top * straight / height), 1e-6);
    for (std::size_t g = 0; g < 2; ++g) {
      const double from = 5.0 * static_cast<double>(g);
      const double expected = of_gate(from, true) / of_gate(from, false);
      EXPECT_LT(expected, 0.9985);
      const std::size_t order_1 = with.gates() + g;  // behind order 0
      EXPECT_NEAR(
          with.grid("echo_by_order").mean[order_1] / without.grid("echo_by_order").mean[order_1],
          expected, within)
          << estimator << ", gate " << g;
    }
  }
}

}  // namespace
}  // namespace photic::test
