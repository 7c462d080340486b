// The air above the sea, whole runs of both estimators.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/both_estimators_over_waves.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// A laser and a telescope with a view of 200 mrad to each side that look down from a height, so
/// many degrees off nadir.
std::string lidar(double height, double tilt_deg, double view_mrad = 200, double laser_mrad = 20) {
  const double tilt = tilt_deg * radian_per_degree;
  return fmt::format(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, {0}]\ndirection = [{1}, 0.0, {2}]\n"
      "diameter_m = 0.04\nhalf_divergence_mrad = {4}\n[[telescope]]\nposition_m = [0.3, 0.0, {0}]\n"
      "direction = [{1}, 0.0, {2}]\ndiameter_m = 0.4\nfocal_length_m = 1.0\n"
      "half_field_of_view_mrad = {3}\n",
      height, std::sin(tilt), -std::cos(tilt), view_mrad, laser_mrad);
}
std::string optics(double a, double b, double g) {
  return fmt::format(
      "iop = [ {{ wavelength_nm = 532.0, a_per_m = {}, b_per_m = {} }},\n"
      "        {{ wavelength_nm = 680.0, a_per_m = {}, b_per_m = {} }} ]\n"
      "phase_function = {{ model = \"henyey-greenstein\", g = {} }}\n",
      a, b, 2 * a, b / 2, g);
}
const std::string times = "[gates]\nstart_ns = 0.0\nstop_ns = 80.0\nstep_ns = 8.0\n";

// With water of the air's index the surface does nothing to light: dense air is as layers of water
// would be in its place, with instruments in them. So this holds what is weakened on its way to and
// from the sea, what the air scatters, and how light goes on from one medium in the other, however
// often. Seen red: with what passes the surface left out; with its direction mirrored; with what
// the air takes left out of the telescope's ways, or of the laser's.
TEST(Air, OfTheWatersIndexIsAsLayersOfWater) {
  const std::string sea = "[sea]\nrefractive_index = 1.0\ngroup_index = 1.0\n";
  const std::string water = "[[sea.layer]]\n" + optics(0.05, 0.2, 0.8);
  const std::string low = optics(0.02, 0.1, 0.6), high = optics(0.01, 0.05, 0.2);
  const std::string in_air =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 2.0\n" + low +
      "[[atmosphere.layer]]\nbottom_height_m = 2.0\ntop_height_m = 5.0\n" + high + sea + water;
  const std::string in_water = sea + "[[sea.layer]]\nbottom_depth_m = 3.0\n" + high +
                               "[[sea.layer]]\nbottom_depth_m = 5.0\n" + low + water;
  for (const double tilt : {0.0, 25.0}) {
    const std::string channels = channel("elastic") + times;
    for (const auto& [estimator, photons] : {std::pair("forward", 4e5), {"bidirectional", 4e4}}) {
      const auto air = run_in_lanes(
          read(lidar(5, tilt) + in_air + channels + simulation(photons, 1, "", estimator)));
      const auto sunk = run_in_lanes(
          read(lidar(-1e-6, tilt) + in_water + channels + simulation(photons, 2, "", estimator)));
      ZFamily family(0.01);
      const auto& a = air.echo_by_order;
      const auto& w = sunk.echo_by_order;
      for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const double error = std::hypot(a.standard_error[i], w.standard_error[i]);
        if (error < 0.08 * w.mean[i])
          family.add(a.mean[i], w.mean[i], error, fmt::format("{} {}, {}", estimator, tilt, i));
      }
      std::printf("%s, %g degrees: %zu cells, rms z %.2f\n", estimator, tilt, family.size(),
                  family.rms());
      EXPECT_GE(family.size(), 25U);
      EXPECT_LT(family.rms(), 1.3);
      family.judge();
    }
  }
}

const std::string haze =
    "[atmosphere]\nprofile = \"us-standard\"\naerosol = \"maritime\"\nvisibility_km = 5.0\n";

// Gate by gate, process by process and order by order. Seen red: with the share of the light that
// is followed into the air left out of its weight.
TEST(Air, BothEstimatorsFindTheSameLight) {
  const std::string chlorophyll = "[[sea.layer]]\nbottom_depth_m = 12.0\nchlorophyll_mg_m3 = 0.3\n";
  const std::string bed = "[bottom]\nalbedo = 0.3\n";
  const std::string waves = "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 6.0 }\n";
  const std::string by_kilometres =
      "[gates]\ndepth_min_m = -1500.0\ndepth_max_m = 30.0\ndepth_step_m = 90.0\n";
  const std::string dense = "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 12.0\n" +
                            optics(0.002, 0.03, 0.7);
  for (const OverWaves& c :
       {OverWaves{"3 km, 15 degrees",
                  lidar(3000, 15, 5, 1) + haze + channel("elastic") + chlorophyll + bed +
                      by_kilometres + simulation(1, 1),
                  1e6, 1e5, 30},
        {"3 km, waves, a bed",
         lidar(3000, 0, 5, 1) + haze + channel("elastic") + waves + chlorophyll + bed +
             by_kilometres + simulation(1, 1),
         1e6, 1e5, 25},
        {"ship, dense air",
         lidar(12, 10, 40, 10) + dense + channel("elastic") + channel("raman") + waves +
             raman_water + depth_gates(12, 2) + simulation(1, 1),
         1e6, 1e5, 25}})
    expect_both_estimators_find(c);
}

}  // namespace
}  // namespace photic::test
