// Whole runs with free walks against the forward estimator, which has none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// From an aeroplane by a wide view, so many degrees off nadir; half angles.
std::string aeroplane(double tilt_deg, double view_mrad = 20, double laser_mrad = 3.5) {
  const double tilt = tilt_deg * radian_per_degree;
  const std::string direction = fmt::format("[{}, 0.0, {}]", std::sin(tilt), -std::cos(tilt));
  return fmt::format(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 400.0]\ndirection = {0}\n"
      "diameter_m = 0.01\nhalf_divergence_mrad = {2}\n[[telescope]]\n"
      "position_m = [0.3, 0.0, 400.0]\ndirection = {0}\ndiameter_m = 0.2\nfocal_length_m = 1.0\n"
      "half_field_of_view_mrad = {1}\n",
      direction, view_mrad, laser_mrad);
}
std::string meetings(double telescope, double laser) {
  return fmt::format("free_telescope_meetings = {}\nfree_laser_meetings = {}\n", telescope, laser);
}

struct Case {
  const char* name;
  double tilt_deg;
  std::string water;
  double photons_forward, photons;
  std::size_t least;  ///< gates that are to be compared
};

// Of both kinds together and of either alone. Seen red: with walks of the laser that are none of
// its light connected to the telescope (1.7 % under a tilted laser).
TEST(FreeWalks, AgreeWithTheForwardEstimator) {
  const std::string peaked = channel("elastic") + water(0.06, 0.1, peaked_phase);
  const std::string inelastic = channel("elastic") + channel("raman") + channel("chlorophyll") +
                                "[[sea.layer]]\nbottom_depth_m = 8.0\nchlorophyll_mg_m3 = 1.0\n"
                                "[[sea.layer]]\nchlorophyll_mg_m3 = 3.0\n";
  for (const Case& c : {Case{"tilted", 20, peaked, 2e6, 8e4, 16},
                        {"tilted, inelastic", 15, inelastic, 1e6, 7e4, 14}}) {
    const std::string scene = aeroplane(c.tilt_deg) + c.water + depth_gates(24, 3);
    const auto forward =
        run_in_lanes(read(scene + simulation(c.photons_forward, 7, "", "forward")));
    ZFamily family(0.01);
    std::uint64_t seed = 8;
    for (const auto& [telescope, laser] : {std::pair(0.1, 1.0), {0.3, 0.0}, {0.0, 2.0}}) {
      const auto r = run_in_lanes(
          read(scene + simulation(c.photons, seed++, meetings(telescope, laser), "bidirectional")));
      for (std::size_t i = 0; i < r.echo.mean.size(); ++i) {
        if (r.convergence_flags[i] != 0 || forward.convergence_flags[i] != 0) continue;
        family.add(r.echo.mean[i], forward.echo.mean[i],
                   std::hypot(r.echo.standard_error[i], forward.echo.standard_error[i]),
                   fmt::format("{}, {} and {}, cell {}", c.name, telescope, laser, i));
      }
    }
    std::printf("%s: %zu gates, rms z %.2f\n", c.name, family.size(), family.rms());
    EXPECT_GE(family.size(), c.least);
    EXPECT_LT(family.rms(), 1.4);
    family.judge();
  }
}

// A cone about the refracted axis holds rays that a tilted instrument does not see, or does not
// send: a fifth of them at 50 degrees. Walks that begin with these serve all the same.
// Seen red: with none but the telescope's own rays (6 % low, 19 standard errors).
TEST(FreeWalks, ServeThoughTheirOwnRayIsNotSeen) {
  const std::string scene = aeroplane(50, 60, 20) + channel("elastic") +
                            water(0.06, 0.1, peaked_phase) + depth_gates(12, 3);
  const auto forward = run_in_lanes(read(scene + simulation(4e6, 51, "", "forward")));
  ZFamily family(0.01);
  std::uint64_t seed = 52;
  for (const auto& [telescope, laser] : {std::pair(0.3, 0.0), {0.0, 2.0}}) {
    const auto r = run_in_lanes(
        read(scene + simulation(4e5, seed++, meetings(telescope, laser), "bidirectional")));
    for (std::size_t gate = 0; gate < 3; ++gate) {
      const double error =
          std::hypot(r.echo.standard_error[gate], forward.echo.standard_error[gate]);
      family.add(r.echo.mean[gate], forward.echo.mean[gate], error,
                 fmt::format("{} and {}, gate {}", telescope, laser, gate));
      std::printf("%g and %g, gate %zu: %.4f +- %.4f of the forward estimator's\n", telescope,
                  laser, gate, r.echo.mean[gate] / forward.echo.mean[gate],
                  error / forward.echo.mean[gate]);
    }
  }
  family.judge();
}

// A laser's rays come from a point behind its disc, so that free walks may come to all of a beam
// that is as wide as the disc from the first. Seen red: with a beam that begins at a point of the
// disc (6 to 24 % low from second order on).
TEST(FreeWalks, OfALaserInTheWaterComeToTheRimOfItsBeam) {
  const std::string scene =
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, -3.0]\n"
      "direction = [0.0, 0.0, -1.0]\ndiameter_m = 0.4\nhalf_divergence_mrad = 60.0\n"
      "[[telescope]]\nposition_m = [0.5, 0.0, -3.0]\ndirection = [0.0, 0.0, -1.0]\n"
      "diameter_m = 0.1\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 200.0\n" +
      channel("elastic") + water(0.1, 0.3, "{ model = \"henyey-greenstein\", g = 0.8 }") +
      "[gates]\nstart_ns = 0.0\nstop_ns = 120.0\nstep_ns = 20.0\n";
  const auto forward = run_in_lanes(read(scene + simulation(2e6, 81, "", "forward")));
  for (const auto& [telescope, laser] : {std::pair(0.0, 0.5), {0.3, 0.3}})
    expect_same_light(forward,
                      run_in_lanes(read(scene + simulation(1e5, 82, meetings(telescope, laser),
                                                           "bidirectional"))),
                      fmt::format("{} and {}", telescope, laser), 0.05, 15);
}

// In the water, an instrument that looks up sees by way of the surface: its walks come down about
// the image of its axis. Seen red: with means of phase functions about the axis itself (in
// scenes/rov.toml 6 times the echo of second order).
TEST(FreeWalks, ComeByWayOfTheSurface) {
  const auto scene = [](double laser_z, double telescope_z, const std::string& run) {
    return read(fmt::format("[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, -3.0]\n"
                            "direction = [0.0, 0.0, {}]\ndiameter_m = 0.01\n"
                            "half_divergence_mrad = 10.0\n[[telescope]]\n"
                            "position_m = [0.1, 0.0, -3.0]\ndirection = [0.0, 0.0, {}]\n"
                            "diameter_m = 0.05\nfocal_length_m = 0.2\n"
                            "half_field_of_view_mrad = 30.0\n",
                            laser_z, telescope_z) +
                channel("elastic") + water(0.06, 0.1, henyey_greenstein_phase) +
                "[gates]\nstart_ns = 40.0\nstop_ns = 130.0\nstep_ns = 15.0\n" + run);
  };
  ZFamily family(0.01);
  std::uint64_t seed = 61;
  for (const auto& [laser_z, telescope_z] : {std::pair(-1.0, 1.0), {1.0, -1.0}}) {
    const auto forward =
        run_in_lanes(scene(laser_z, telescope_z, simulation(4e6, seed++, "", "forward")));
    for (const auto& [telescope, laser] : {std::pair(0.3, 0.0), {0.0, 0.3}, {0.3, 0.3}}) {
      const auto r =
          run_in_lanes(scene(laser_z, telescope_z,
                             simulation(1e5, seed++, meetings(telescope, laser), "bidirectional")));
      for (std::size_t order = 1; order < 4; ++order) {
        for (std::size_t gate = 0; gate < r.gates(); ++gate) {
          const std::size_t i = order * r.gates() + gate;
          const double error = std::hypot(r.grid("echo_by_order").standard_error[i],
                                          forward.grid("echo_by_order").standard_error[i]);
          if (!(error < 0.05 * forward.grid("echo_by_order").mean[i])) continue;
          family.add(r.grid("echo_by_order").mean[i], forward.grid("echo_by_order").mean[i], error,
                     fmt::format("up {}, {} and {}, order {}, gate {}", telescope_z, telescope,
                                 laser, order, gate));
        }
      }
    }
  }
  std::printf("%zu cells, rms z %.2f\n", family.size(), family.rms());
  EXPECT_GE(family.size(), 60);
  family.judge();
}

// The last gates hold light of walks whose own way from the instrument is metres longer than that
// of the path they become. Seen red: with chords that end where a walk's own way is too long (10
// standard errors).
TEST(FreeWalks, LoseNothingThatIsInTime) {
  const auto scene = [](double deepest, const std::string& run) {
    return read(aeroplane(25) + channel("elastic") + water(0.06, 0.1, peaked_phase) +
                depth_gates(deepest, 2) + run);
  };
  ZFamily family(0.01);
  std::uint64_t seed = 41;
  for (const auto& [telescope, laser] : {std::pair(0.3, 0.0), {0.0, 2.0}}) {
    const auto settings = meetings(telescope, laser);
    const auto here = run_in_lanes(scene(8, simulation(4e5, seed++, settings, "bidirectional")));
    const auto longer = run_in_lanes(scene(14, simulation(4e5, seed++, settings, "bidirectional")));
    for (const std::size_t gate : {2U, 3U}) {
      const double error =
          std::hypot(here.echo.standard_error[gate], longer.echo.standard_error[gate]);
      EXPECT_LT(error, 0.02 * longer.echo.mean[gate]);
      family.add(here.echo.mean[gate], longer.echo.mean[gate], error,
                 fmt::format("{} and {}, gate {}", telescope, laser, gate));
      std::printf("gate %zu: %.4f of what a longer run sees, +- %.4f\n", gate,
                  here.echo.mean[gate] / longer.echo.mean[gate], error / longer.echo.mean[gate]);
    }
  }
  family.judge();
}

// An environment's echo by free walks is that of its own water. Seen red: with the way from the
// telescope as it was drawn.
TEST(FreeWalks, HoldInOtherWaters) {
  const auto scene = [](double a, double b, const std::string& more) {
    return aeroplane(15) + channel("elastic") + water(a, b, peaked_phase) + more +
           depth_gates(24, 3);
  };
  const std::string other =
      "[[environment]]\nset = { \"sea.layer.0.iop.0.a_per_m\" = 0.09, "
      "\"sea.layer.0.iop.0.b_per_m\" = 0.12 }\n";
  ZFamily family(0.01);
  std::uint64_t seed = 21;
  for (const auto& [telescope, laser] : {std::pair(0.3, 0.0), {0.1, 2.0}}) {
    const auto settings = meetings(telescope, laser);
    const auto all = run_in_lanes(
        read(scene(0.06, 0.1, other) + simulation(3e5, seed++, settings, "bidirectional")));
    const auto own = run_in_lanes(
        read(scene(0.09, 0.12, "") + simulation(3e5, seed++, settings, "bidirectional")));
    for (std::size_t i = 0; i < own.echo.mean.size(); ++i) {
      if (own.convergence_flags[i] != 0 || all.environment_convergence_flags[i] != 0) continue;
      family.add(all.environment_echo.mean[i], own.echo.mean[i],
                 std::hypot(all.environment_echo.standard_error[i], own.echo.standard_error[i]),
                 fmt::format("{} and {}, cell {}", telescope, laser, i));
    }
  }
  std::printf("other water: %zu gates, rms z %.2f\n", family.size(), family.rms());
  EXPECT_GE(family.size(), 4U);
  family.judge();
}

// Light that is scattered by less than the view at a walk's first vertex is found by walks that
// begin near the laser's spot alone. Seen red: with walks aimed there only in views five times as
// wide as the light (2.5 to 3.2 %).
TEST(FreeWalks, AreAimedAtTheLightOfWideViews) {
  const std::string axis =
      "position_m = [0.0, 0.0, 2500.0]\ndirection = [0.20791169, 0.0, "
      "-0.9781476]\n";
  const auto r = run_in_lanes(read(
      "[source]\nwavelength_nm = 450.0\ndiameter_m = 0.05\nhalf_divergence_mrad = 0.5\n" + axis +
      "[[telescope]]\ndiameter_m = 0.5\nfocal_length_m = 1.0\n"
      "half_field_of_view_mrad = 20.0\n" +
      axis + channel("raman") +
      "[[sea.layer]]\nbottom_depth_m = 8.0\nchlorophyll_mg_m3 = 1.0\n"
      "[[sea.layer]]\nchlorophyll_mg_m3 = 0.2\n" +
      depth_gates(24, 3) + simulation(62000, 1, meetings(0.3, 0.3), "bidirectional")));
  double sum = 0;
  for (std::size_t g = 0; g < r.gates(); ++g)
    sum += std::log(r.echo.standard_error[g] / r.echo.mean[g]);
  EXPECT_LT(std::exp(sum / static_cast<double>(r.gates())), 0.0205);
}

}  // namespace
}  // namespace photic::test
