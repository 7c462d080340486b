// The air above the sea, whole runs of both estimators.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "support/both_estimators_over_waves.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
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
// would be in its place, with instruments in them, and by its group index takes as long. So this
// holds what is weakened on its way to and from the sea, what the air scatters, and how light goes
// on from one medium in the other, however often. Seen red: with what passes the surface left out;
// with its direction mirrored; with the share of the light that is followed into the air left out
// of its weight; with what the air takes left out of the telescope's ways, or of the laser's; with
// the delay left out of flights, of the telescope's ways, or of where rays meet.
TEST(Air, OfTheWatersIndexIsAsLayersOfWater) {
  const std::string sea = "[sea]\nrefractive_index = 1.0\ngroup_index = 1.3\n";
  const std::string water = "[[sea.layer]]\n" + optics(0.05, 0.2, 0.8);
  const std::string slow = "refractive_index = 1.3\n";
  const std::string low = optics(0.02, 0.1, 0.6), high = optics(0.01, 0.05, 0.2);
  const std::string in_air = "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 2.0\n" +
                             low + slow +
                             "[[atmosphere.layer]]\nbottom_height_m = 2.0\ntop_height_m = 5.1\n" +
                             high + slow + sea + water;
  const std::string in_water = sea + "[[sea.layer]]\nbottom_depth_m = 3.1\n" + high +
                               "[[sea.layer]]\nbottom_depth_m = 5.1\n" + low + water;
  ZFamily all(0.01);
  for (const double tilt : {0.0, 25.0}) {
    const std::string channels =
        channel("elastic") + "[gates]\nstart_ns = 0.0\nstop_ns = 104.0\nstep_ns = 10.4\n";
    for (const auto& [estimator, photons] : {std::pair("forward", 4e5), {"bidirectional", 4e4}}) {
      const auto air = run_in_lanes(
          read(lidar(5, tilt) + in_air + channels + simulation(photons, 1, "", estimator)));
      const auto sunk = run_in_lanes(
          read(lidar(-0.1, tilt) + in_water + channels + simulation(photons, 2, "", estimator)));
      const std::size_t before = all.size();
      const auto& a = air.grid("echo_by_order");
      const auto& w = sunk.grid("echo_by_order");
      for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const double error = std::hypot(a.standard_error[i], w.standard_error[i]);
        if (error < 0.08 * w.mean[i])
          all.add(a.mean[i], w.mean[i], error, fmt::format("{} {}, {}", estimator, tilt, i));
      }
      EXPECT_GE(all.size() - before, 25U) << estimator << " " << tilt;
    }
  }
  std::printf("%zu cells, rms z %.2f\n", all.size(), all.rms());
  all.judge();
  all.judge_scatter();
}

const std::string haze =
    "[atmosphere]\nprofile = \"us-standard\"\naerosol = \"maritime\"\nvisibility_km = 5.0\n";

// Gate by gate, process by process and order by order. Seen red: with conversions
// of light that histories beside walks do not score (Raman light twice); above the air, with free
// walks that take the air's top for where the beam begins (20 to 50 % low from second order on),
// and with light of the air sent into views as if it were still to be converted, at distances whose
// squares floats do not hold.
TEST(Air, BothEstimatorsFindTheSameLight) {
  const std::string chlorophyll = "[[sea.layer]]\nbottom_depth_m = 12.0\nchlorophyll_mg_m3 = 0.3\n";
  const std::string bed = "[bottom]\nalbedo = 0.3\n";
  const std::string waves = "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 6.0 }\n";
  const std::string by_kilometres =
      "[gates]\ndepth_min_m = -1500.0\ndepth_max_m = 30.0\ndepth_step_m = 90.0\n";
  const std::string dense = "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 12.0\n" +
                            optics(0.002, 0.03, 0.7);
  const std::string thin =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 20.0\n" + optics(0.0, 0.02, 0.4);
  const std::string even =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 4.0\n" + optics(0.01, 0.1, 0.0);
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
         1e6, 1.6e5, 25},
        {"above the air",
         lidar(100, 0, 50, 5) + thin + channel("elastic") + "[[sea.layer]]\n" +
             optics(0.05, 0.1, 0.8) +
             "[gates]\ndepth_min_m = -30.0\ndepth_max_m = 20.0\ndepth_step_m = 5.0\n" +
             simulation(1, 1),
         1e6, 1e5, 25},
        {"above the air, Raman light",
         lidar(8, 0, 60, 20) + even + channel("elastic") + channel("raman") + raman_water +
             depth_gates(8, 2) + simulation(1, 1),
         1e6, 1e5, 20}})
    expect_both_estimators_find(c);
}

/// A small laser high up and a small telescope near the sea: what each fills or sees is a cone of
/// so many mrad about its axis. Or both exchanged.
std::string two_points(bool exchanged) {
  struct Point {
    std::string at;
    double half_angle_mrad;
  };
  const Point high{"position_m = [0.0, 0.0, 6.0]\ndirection = [0.5, 0.0, -6.0]\n", 200},
      low{"position_m = [0.7, 0.0, 0.8]\ndirection = [-0.1, 0.0, -0.8]\n", 300};
  const Point &laser = exchanged ? low : high, &telescope = exchanged ? high : low;
  return fmt::format(
      "[source]\nwavelength_nm = 532.0\n{}diameter_m = 1e-5\nhalf_divergence_mrad = {}\n"
      "[[telescope]]\n{}diameter_m = 0.01\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = {}\n",
      laser.at, laser.half_angle_mrad, telescope.at, telescope.half_angle_mrad);
}

// Light goes both ways alike: with laser and telescope exchanged, echoes over the solid angle of
// the laser's cone are the same, by time, order and process. What was scattered last in the air is
// what was scattered first in the air then; there is far more air above one of both. Seen red: with
// no light followed from the water into the air, or from there into the water.
TEST(Air, SendsLightBothWaysAlike) {
  const std::string media =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 3.0\n" + optics(0.02, 0.4, 0.3) +
      "[[atmosphere.layer]]\nbottom_height_m = 3.0\ntop_height_m = 8.0\n" + optics(0.01, 0.2, 0.0) +
      "[[sea.layer]]\n" + optics(0.1, 0.4, 0.3) + channel("elastic") + times;
  const auto run_with = [&](bool exchanged) {
    return run_in_lanes(read(two_points(exchanged) + media + simulation(1e6, exchanged ? 21 : 22)));
  };
  const double solid_angles = (1 - std::cos(0.2)) / (1 - std::cos(0.3));
  constexpr double by_lens = 0.01;  // which has less area aslant
  auto down = run_with(false);
  for (auto* echo : {&down.grid("echo_by_process"), &down.grid("echo_by_order")})
    for (std::size_t i = 0; i < echo->mean.size(); ++i) {
      const double error = solid_angles * echo->standard_error[i];
      echo->mean[i] *= solid_angles;
      echo->standard_error[i] = std::hypot(error, by_lens * echo->mean[i]);
    }
  expect_same_light(down, run_with(true), "both ways", 0.1, 16);
}

/// Every gate of the first channel's light scattered once in the air, against what it should be.
void expect_of_air(const tally::Result& r, const std::vector<double>& expected,
                   const std::string& what) {
  ZFamily family(0.01);
  const std::size_t order = 1;
  for (std::size_t g = 0; g < expected.size(); ++g) {
    const std::size_t i = order * r.gates() + g;
    // The equations have the lens at one distance, and hardly any air in the near field.
    family.add(r.grid("echo_by_order").mean[i], expected[g],
               std::hypot(r.grid("echo_by_order").standard_error[i], 1e-3 * expected[g]),
               fmt::format("{}, gate {}", what, g));
    EXPECT_LT(r.grid("echo_by_order").standard_error[i], 0.05 * expected[g])
        << what << ", gate " << g;
  }
  family.judge();
}

// The ship's lidar of PREMAR-2F's Table 1 sees ever more of its beam: molecules at 15 C and 1 atm
// send back per metre 7.786e-9 x 0.0625 = 3.041e-9 x 0.16 = 4.866e-10 of its photons, from 5 m as
// from 8 m. Over a plane of 3 km, 15 degrees off nadir, all of the beam is seen: b p(180) A / R^2
// exp(-2 tau). Seen red: with the layers in the wrong order.
TEST(Air, FirstOrderIsThatOfTheLidarEquation) {
  const std::string molecules =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 20.0\n"
      "iop = [ { wavelength_nm = 532.0, a_per_m = 0.0, b_per_m = 1.31605e-5 } ]\n";
  const std::string sea = "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n" + channel("elastic");
  const double low_c = 2.2e-4, high_c = 1.2e-5, low_b = 2e-4, high_b = 1e-5,
               cosine = std::cos(15 * radian_per_degree);
  const std::string layers =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 1000.0\n" +
      optics(low_c - low_b, low_b, 0.5) +
      "[[atmosphere.layer]]\nbottom_height_m = 1000.0\ntop_height_m = 5000.0\n" +
      optics(high_c - high_b, high_b, 0.0);
  const auto back = [](double g) { return (1 - g * g) / (4 * pi * std::pow(1 + g, 3)); };
  std::vector<double> plane;
  for (double height = 1800; height > 150; height -= 200) {  // gates of 200 m
    double sum = 0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i) {
      const double h = height - (i + 0.5) * 200.0 / steps;
      const double tau =
          (high_c * (3000 - std::max(h, 1000.0)) + low_c * std::max(0.0, 1000 - h)) / cosine;
      const double beta = h < 1000 ? low_b * back(0.5) : high_b * back(0);
      const double range = (3000 - h) / cosine;
      sum += beta * (pi * 0.04) / (range * range) * std::exp(-2 * tau) * (200.0 / steps / cosine);
    }
    plane.push_back(sum);
  }
  for (const auto& [estimator, photons] : {std::pair("forward", 1e6), {"bidirectional", 1e5}}) {
    const auto ship = run_in_lanes(read(ship_instrument + molecules + sea +
                                        "[gates]\ndepth_min_m = -9.0\ndepth_max_m = -1.0\n"
                                        "depth_step_m = 1.0\n" +
                                        simulation(photons, 3, "", estimator)));
    expect_of_air(ship, std::vector<double>(8, 4.866e-10), fmt::format("{}, ship", estimator));
    const auto high = run_in_lanes(read(lidar(3000, 15, 5, 1) + layers + sea +
                                        "[gates]\ndepth_min_m = -1800.0\ndepth_max_m = -200.0\n"
                                        "depth_step_m = 200.0\n" +
                                        simulation(photons, 4, "", estimator)));
    plane.resize(high.gates());
    expect_of_air(high, plane, fmt::format("{}, plane", estimator));
  }
}

// From space the air delays the sea's echo by 2.449 m one way (8451 m of air at 15 C and 1 atm, n_g
// - 1 = 2.8975e-4): gates of depth know it. So every gate is weaker by the same factor. Seen red:
// with the delay left out of gates (1.8 m of depth), or of the telescope's way.
TEST(Air, WeakensAndDelaysTheSeasEcho) {
  const std::string sea =
      "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n" + channel("elastic") + depth_gates(30, 5);
  const std::string air = "[atmosphere]\nprofile = \"us-standard\"\naerosol = \"none\"\n";
  const std::string instruments = lidar(705e3, 3, 0.065, 0.05);
  const double secant = 1 / std::cos(3 * radian_per_degree);
  const double passes = std::exp(-2 * 0.1365 * secant);
  for (const auto& [estimator, photons, most] :
       {std::tuple("bidirectional", 1e5, 0.01), {"forward", 1e6, 0.05}}) {
    const std::string run = simulation(photons, 5, "", estimator);
    const auto clear = run_in_lanes(read(instruments + sea + run));
    const auto dim = run_in_lanes(read(instruments + air + sea + run));
    for (std::size_t e = 0; e < clear.gate_time_edge_ns.size(); ++e)
      EXPECT_NEAR(
          (dim.gate_time_edge_ns[e] - clear.gate_time_edge_ns[e]) * metre_per_nanosecond / 2,
          2.449 * secant, 2e-3);
    ZFamily family(0.01);
    for (std::size_t g = 0; g < clear.gates(); ++g) {  // process 0: elastic
      const double expected = passes * clear.echo.mean[g];
      family.add(dim.grid("echo_by_process").mean[g], expected,
                 std::hypot(dim.grid("echo_by_process").standard_error[g],
                            passes * clear.echo.standard_error[g]),
                 fmt::format("{}, gate {}", estimator, g));
      EXPECT_LT(dim.grid("echo_by_process").standard_error[g], most * expected)
          << estimator << " " << g;
    }
    family.judge();
  }
}

/// A big lens with a wide view in dense air, over water that turns much light back: what a photon
/// can fall on.
scene::Scene big_lens(const std::string& surface, const std::string& estimator, double photons,
                      std::uint64_t seed) {
  return read(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 5.0]\ndirection = [0.05, 0.0, "
      "-1.0]\n"
      "diameter_m = 0.1\nhalf_divergence_mrad = 20.0\n"
      "[[telescope]]\nposition_m = [0.0, 0.2, 5.0]\ndirection = [0.0, 0.1, -1.0]\n"
      "diameter_m = 3.0\nfocal_length_m = 2.0\ndetector_diameter_m = 2.0\n"
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 3.0\n" +
      optics(0.02, 0.15, 0.3) +
      "[[atmosphere.layer]]\nbottom_height_m = 3.0\ntop_height_m = 8.0\n" +
      optics(0.01, 0.06, 0.0) + channel("elastic") + channel("raman") + "[sea]\nsurface = " +
      surface + "\n[[sea.layer]]\nbottom_depth_m = 4.0\n" + optics(0.1, 0.4, 0.3) +
      "[bottom]\nalbedo = 0.5\n[gates]\nstart_ns = 0.0\nstop_ns = 96.0\nstep_ns = 8.0\n" +
      simulation(photons, seed, "max_order = 30", estimator));
}

// Photons that chance alone sends about, from one medium to the other and back, fall on the
// detector as often as the forward estimator expects: light of the air, of the water and of the
// bed, under a flat surface and under waves. Seen red: with what passes the surface upwards taken
// for what escapes; with nothing mirrored by the sea.
TEST(Air, AnalogPhotonsAreCountedAsOftenAsExpected) {
  for (const std::string surface :
       {"{ model = \"flat\" }", "{ model = \"cox-munk\", wind_speed_m_s = 8.0 }"}) {
    const auto expected = run_in_lanes(big_lens(surface, "forward", 1e6, 3));
    const auto counted = run_in_lanes(big_lens(surface, "analog", 8e6, 4));
    EXPECT_NEAR(counted.ledger.sum(), 1, 1e-9);
    expect_same_light(counted, expected, surface, 0.1, 40);
  }
}

// Nearly all light that the sea mirrors comes hardly later than what turns at the surface, and none
// before. Seen red: with paths as floats round them (a third of it before, from 3 km); with all of
// the way from space in floats; with no allowance for the rounding of the delay (from 9 km).
TEST(Air, LightThatTheSeaMirrorsComesWithTheSurfacesGate) {
  const std::string gates =
      "[gates]\ndepth_min_m = -0.05\ndepth_max_m = 0.05\ndepth_step_m = 0.05\n";
  const std::string sea = "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n" + channel("elastic") + gates;
  for (const double height : {12.3, 3123.7, 9000.0, 9123.4, 705123.4})
    for (const auto& [estimator, photons] : {std::pair("forward", 2e5), {"bidirectional", 2e4}}) {
      const double view = height > 1e4 ? 0.065 : 0.8;
      const auto r = run_in_lanes(read(lidar(height, 0, view, 0.7 * view) + haze + sea +
                                       simulation(photons, 9, "", estimator)));
      const std::size_t air = r.gates();  // behind elastic light
      EXPECT_GT(r.grid("echo_by_process").mean[air + 1], 0) << height;
      // What the air there sends back itself is less.
      const double most = height > 1000 ? 2e-4 : 0.02;
      EXPECT_LT(r.grid("echo_by_process").mean[air], most * r.grid("echo_by_process").mean[air + 1])
          << estimator << ", " << height;
    }
}

/// A ship's run in air that is given in so many layers of one kind.
tally::Result ship_in_air(const std::string& estimator, int layers, double a, double b,
                          int threads = 2) {
  std::string air;
  for (int k = 0; k < layers; ++k)
    air += fmt::format("[[atmosphere.layer]]\nbottom_height_m = {}\ntop_height_m = {}\n",
                       12.5 * k / layers, 12.5 * (k + 1) / layers) +
           optics(a, b, 0.7);
  run::RunOptions options;
  options.lanes = isa_of_tests();
  options.threads = threads;
  return run::run(
      read(lidar(12, 10, 40, 10) + air + channel("elastic") + channel("raman") + raman_water +
           depth_gates(12, 2) +
           simulation(estimator == "forward" ? 4e4 : 8e3, 1,
                      "free_telescope_meetings = 0.1\nfree_laser_meetings = 0.1", estimator)),
      *test::tables(), options);
}

// Seen red: with layers above the first a millimetre thicker where ways through the air are
// weakened.
TEST(Air, InAnyNumberOfLayersAndThreadsIsTheSame) {
  for (const std::string estimator : {"forward", "bidirectional"}) {
    const auto one = ship_in_air(estimator, 1, 0.002, 0.03);
    const auto many = ship_in_air(estimator, 50, 0.002, 0.03);
    for (std::size_t i = 0; i < one.echo.mean.size(); ++i)
      EXPECT_NEAR(many.echo.mean[i], one.echo.mean[i], 1e-5 * one.echo.mean[i]) << estimator;
    EXPECT_EQ(ship_in_air(estimator, 1, 0.002, 0.03, 3).state, one.state) << estimator;
    // Air that does nothing changes nothing.
    EXPECT_EQ(ship_in_air(estimator, 2, 0, 0).echo.mean, ship_in_air(estimator, 0, 0, 0).echo.mean)
        << estimator;
  }
}

// Flights that do not leave the water, importances and collisions scored on the way: none changes
// the light, nor what of it goes on in the air. Seen red: with what leaves on forced flights not
// followed into the air, or followed from where the flight begins.
TEST(Air, ToolsLeaveItsLightAsItIs) {
  const std::string air =
      "[[atmosphere.layer]]\nbottom_height_m = 0.0\ntop_height_m = 6.0\n" + optics(0.01, 0.15, 0.3);
  const std::string water =
      "[[sea.layer]]\nbottom_depth_m = 5.0\n" + optics(0.05, 0.4, 0.4) + "[bottom]\nalbedo = 0.3\n";
  const auto run_with = [&](const std::string& tools, std::uint64_t seed) {
    return run_in_lanes(read(lidar(12, 10, 60, 15) + air + channel("elastic") + channel("raman") +
                             water + depth_gates(6, 1.5) +
                             simulation(5e5, seed, "scored_points = 1\n" + tools)));
  };
  const auto plain = run_with("", 31);
  for (const auto& [name, tools] :
       {std::pair<std::string, std::string>{"forced collisions", "forced_collisions = 1000"},
        {"all at once",
         "forced_collisions = 2\nlocal_forced_collisions = \"all\"\nweight_threshold = 0.1\n"
         "importance = [ { depth_m = 0.5, value = 3 }, { depth_m = 3, value = 0.7 } ]"}}) {
    const auto by_tools = run_with("[simulation.tools]\n" + tools + "\n", 32);
    expect_same_light(plain, by_tools, "tools under air, " + name, 0.05, 20);
    EXPECT_NEAR(by_tools.ledger.sum(), 1, 5 * by_tools.ledger_standard_error + 1e-6);
  }
}

}  // namespace
}  // namespace photic::test
