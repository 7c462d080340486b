// Light that the water converts, in haze whose phase function differs by wavelength.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "medium/air.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::test {
namespace {

constexpr double laser_nm = 355, chlorophyll_nm = 685;

/// A laser just above the sea and a lens with a wide view above it: the air scatters hardly any of
/// the laser's light, and much of what the water makes of it.
std::string lidar_in(const std::string& air, double lens_m) {
  return fmt::format(
             "[source]\nwavelength_nm = {0}\nposition_m = [0.0, 0.0, 0.1]\n"
             "direction = [0.05, 0.0, -1.0]\ndiameter_m = 0.1\nhalf_divergence_mrad = 20.0\n"
             "[[telescope]]\nposition_m = [0.0, 0.2, 8.0]\ndirection = [0.0, 0.1, -1.0]\n"
             "diameter_m = {1}\nfocal_length_m = 2.0\ndetector_diameter_m = 2.0\n",
             laser_nm, lens_m) +
         air + channel("chlorophyll") +
         fmt::format(
             "[[sea.layer]]\nchlorophyll_yield = 0.8\n"
             "iop = [ {{ wavelength_nm = {}, a_per_m = 2.0, b_per_m = 0.1, "
             "a_phytoplankton_per_m = 1.8 }},\n{{ wavelength_nm = {}, a_per_m = 0.2, "
             "b_per_m = 0.2 }} ]\nphase_function = {{ model = \"henyey-greenstein\", g = 0.5 }}\n"
             "[gates]\nstart_ns = 26.0\nstop_ns = 74.0\nstep_ns = 6.0\n",
             laser_nm, chlorophyll_nm);
}

/// Desert dust, three metres of it with an optical depth of 1.
const std::string dust =
    "[atmosphere]\nprofile = \"us-standard\"\naerosol = \"opac-mitr-0\"\n"
    "aerosol_optical_depth_550 = 1.0\ntop_km = 0.003\n";

/// It as layers that are given outright and scatter light of all wavelengths as it does that of
/// chlorophyll.
std::string dust_outright() {
  std::vector<medium::Line> lines(2);
  lines[0].wavelength_nm = laser_nm;
  lines[1] = {.process = scene::Process::chlorophyll, .wavelength_nm = chlorophyll_nm};
  const auto scene = read(lidar_in(dust, 1) + simulation(1, 1));
  const auto air = medium::AirBuilder(scene, *test::tables(), lines)(scene);
  std::string out;
  for (std::size_t k = 0; k < air.layers(); ++k) {
    const auto table = air.phase(air.phases_of[1], k);
    std::vector<double> angle_deg, p;
    for (double angle = 0; angle < 180.1; angle += angle < 0.99 ? 0.05 : 0.5) {
      const double half = std::sin(angle * radian_per_degree / 2);
      angle_deg.push_back(std::min(angle, 180.0));
      p.push_back(table->view().value(2 * half * half));
    }
    const std::size_t emitted = air.layers() + k;
    out += fmt::format(
        "[[atmosphere.layer]]\nbottom_height_m = {}\ntop_height_m = {}\nrefractive_index = {}\n"
        "iop = [ {{ wavelength_nm = {}, a_per_m = {}, b_per_m = {} }},\n"
        "{{ wavelength_nm = {}, a_per_m = {}, b_per_m = {} }} ]\n"
        "phase_function = {{ model = \"table\", file = {{ angle_deg = [{:.4f}], "
        "phase_function_per_sr = [{}] }} }}\n",
        air.height_m[k], air.height_m[k + 1], air.refractive_index[emitted], laser_nm, air.a[k],
        air.b[k], chlorophyll_nm, air.a[emitted], air.b[emitted], fmt::join(angle_deg, ", "),
        fmt::join(p, ", "));
  }
  return out;
}

// Dust scatters chlorophyll's light 1.8 times as much to 20 ... 60 degrees as the laser's. Against
// the forward estimator where no other phase function is. False alarms: one in a hundred for each
// estimator. Seen red: with the laser's phase functions for all lines; against
// analog photons, with free paths that are drawn for the height of the lowest instrument, here the
// laser (a quarter of the light that the air scatters into a lens of 3 m, in dust up to it).
TEST(Haze, ScattersLightAsItsOwnWavelength) {
  const auto run_in = [](const std::string& air, double lens_m, const std::string& estimator,
                         double photons, std::uint64_t seed) {
    return run_in_lanes(
        read(lidar_in(air, lens_m) + simulation(photons, seed, "max_order = 30", estimator)));
  };
  const std::string outright = dust_outright();
  const auto big = run_in(outright, 3, "forward", 1e6, 3);
  expect_same_light(run_in(dust, 3, "analog", 8e6, 4), big, "analog", 0.06, 12);
  const auto small = run_in(outright, 0.4, "forward", 1e6, 5);
  for (const auto& [estimator, photons] : {std::pair("forward", 1e6), {"bidirectional", 3e5}})
    expect_same_light(run_in(dust, 0.4, estimator, photons, 6), small, estimator, 0.08, 12);
}

}  // namespace
}  // namespace photic::test
