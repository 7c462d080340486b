// The bidirectional estimator under waves, of instruments in the water: facets send light back to
// them, and between collisions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "support/both_estimators_over_waves.hpp"
#include "support/lidars_over_waves.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// Laser and telescope at places of their own, looking in a plane, so many degrees off the nadir.
std::string instruments(double laser_height, double laser_off_nadir, double height,
                        double off_nadir, double view_mrad, double divergence_mrad = 20) {
  const auto look = [](double degrees) {
    const double t = degrees * radian_per_degree;
    return fmt::format("direction = [{:.15g}, 0.0, {:.15g}]\n", std::sin(t), -std::cos(t));
  };
  return fmt::format(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, {}]\n{}diameter_m = 0.04\n"
      "half_divergence_mrad = {}\n[[telescope]]\nposition_m = [0.3, 0.1, {}]\n{}"
      "diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = {}\n",
      laser_height, look(laser_off_nadir), divergence_mrad, height, look(off_nadir), view_mrad);
}
const std::string upper_water = "[[sea.layer]]\nbottom_depth_m = 3.0\n" + raman_water.substr(14);

// No mirror images help there: what facets send to the instruments is found facet by facet.
TEST(WalksUnderWaves, FindWhatTheForwardEstimatorDoesInTheWater) {
  const std::string windy =
      sea("model = \"cox-munk\", wind_speed_m_s = 9.0, wind_direction_deg = 30.0");
  const std::string steep =
      sea("model = \"gaussian\", upwind_slope_variance = 0.04, crosswind_slope_variance = 0.03, "
          "whitecap_fraction = 0.1");
  const std::string both = channel("elastic") + channel("raman");
  const auto end = [](double range, double step, int order = 3) {
    return fmt::format("[gates]\nrange_min_m = 0.0\nrange_max_m = {}\nrange_step_m = {}\n", range,
                       step) +
           simulation(1, 1, fmt::format("max_order = {}\n", order));
  };
  for (const OverWaves& c :
       {OverWaves{"both look up",
                  instruments(-5, 165, -4, 160, 300) + both + steep + raman_water + end(16, 2), 1e6,
                  2e5, 10},
        // All light has been sent back by facets. That of higher orders has tails there by the
        // forward estimator: OfHardlyAnySlopeSendBackWhatAFlatSurfaceDoes.
        OverWaves{"the telescope looks up, the laser down, once",
                  instruments(-3, 0, -3, 180, 300) + both + steep + raman_water + end(16, 2, 1),
                  1e6, 2e5, 24},
        OverWaves{"waves of one direction over a telescope that looks up",
                  instruments(6, 10, -3, 170, 300) + both +
                      sea("model = \"paper\", wind_speed_m_s = 9.0, wind_direction_deg = 30.0") +
                      raman_water + end(16, 2),
                  1e6, 2e5, 5},
        OverWaves{"the laser in the air",
                  instruments(6, 10, -8, 165, 300) + both + windy + upper_water + raman_water +
                      end(24, 3),
                  1e6, 2e5, 15},
        OverWaves{"the telescope in the air",
                  instruments(-3, 160, 6, 10, 100) + both + windy + raman_water + end(24, 3), 1e6,
                  4e5, 8}})
    expect_both_estimators_find(c);
}

// Between a laser and a telescope in the water, of which one looks up and the other down, all light
// is sent back by the surface, some of it several times in a row: between its vertices, too, before
// and after it is converted. Both are tilted. Seen red: with rays behind facets that do not meet.
TEST(WalksUnderWaves, OfHardlyAnySlopeSendBackWhatAFlatSurfaceDoes) {
  const auto run = [](bool laser_looks_up, const std::string& surface, double photons,
                      std::uint64_t seed) {
    return run_in_lanes(
        read(instruments(-3, laser_looks_up ? 174 : 6, -3, laser_looks_up ? 5 : 172, 200) +
             channel("elastic") + channel("raman") + sea(surface) + raman_water +
             "[gates]\nstart_ns = 20.0\nstop_ns = 120.0\nstep_ns = 25.0\n" +
             simulation(photons, seed, no_free_walks, "bidirectional")));
  };
  ZFamily family(0.01);
  for (const bool laser_looks_up : {false, true}) {
    const auto flat = run(laser_looks_up, "model = \"flat\"", 2e5, 41);
    const auto level = run(laser_looks_up,
                           "model = \"gaussian\", upwind_slope_variance = 1e-6, "
                           "crosswind_slope_variance = 1e-6",
                           6e5, 42);
    const auto &f = flat.grid("echo_by_order"), &l = level.grid("echo_by_order");
    for (std::size_t i = 0; i < f.mean.size(); ++i) {
      const double error = std::hypot(f.standard_error[i], l.standard_error[i]);
      if (!(error < 0.1 * f.mean[i])) continue;
      family.add(l.mean[i], f.mean[i], error,
                 fmt::format("the laser looks {}, cell {}", laser_looks_up ? "up" : "down", i));
    }
  }
  std::printf("%zu cells, rms z %.2f\n", family.size(), family.rms());
  EXPECT_GE(family.size(), 60);
  EXPECT_LT(family.rms(), 1.3);
  family.judge();
}

// All light between a laser and a telescope of which one looks down and the other up has been sent
// back by facets: on its way to the telescope, or where walks of the laser begin.
TEST(WalksUnderWaves, OverOtherWavesAndWaterAreTheirOwnRun) {
  struct Sea {
    double upwind, crosswind, whitecaps, absorption, scattering;
  };
  const auto run = [](const Sea& is, const std::string& more, std::uint64_t seed,
                      bool laser_looks_up) {
    const auto scene =
        read(more + instruments(-3, laser_looks_up ? 180 : 0, -3, laser_looks_up ? 0 : 180, 300) +
             channel("elastic") +
             sea(fmt::format("model = \"gaussian\", upwind_slope_variance = {}, "
                             "crosswind_slope_variance = {}, whitecap_fraction = {}",
                             is.upwind, is.crosswind, is.whitecaps)) +
             water(is.absorption, is.scattering, R"({ model = "henyey-greenstein", g = 0.3 })") +
             "[gates]\nrange_min_m = 0.0\nrange_max_m = 8.0\nrange_step_m = 1.0\n" +
             simulation(laser_looks_up ? 2e6 : 4e5, seed, no_free_walks, "bidirectional"));
    return run_in_lanes(scene);
  };
  const Sea here{0.04, 0.03, 0.1, 0.06, 0.2}, there{0.02, 0.015, 0.03, 0.12, 0.25};
  const std::string other = fmt::format(
      "[[environment]]\nset = {{ \"sea.surface.upwind_slope_variance\" = {}, "
      "\"sea.surface.crosswind_slope_variance\" = {}, \"sea.surface.whitecap_fraction\" = {}, "
      "\"sea.layer.0.iop.0.a_per_m\" = {}, \"sea.layer.0.iop.0.b_per_m\" = {} }}\n",
      there.upwind, there.crosswind, there.whitecaps, there.absorption, there.scattering);
  expect_environment_is(run(here, other, 31, false), run(there, "", 32, false), 5);
  expect_environment_is(run(here, other, 33, true), run(there, "", 34, true), 4);
}

}  // namespace
}  // namespace photic::test
