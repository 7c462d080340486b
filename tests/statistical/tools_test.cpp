// The paper's tools of the forward estimator against the plain one: whatever they do to the
// variance, the mean stays. And analog photons, which expect nothing, against both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "run/run.hpp"
#include "support/agree.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

/// Two layers over a sea bed that scatter broadly, so that plain walks converge, and emit light.
const std::string bright_layers = R"(
[[sea.layer]]
bottom_depth_m = 4.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.20, a_phytoplankton_per_m = 0.02 },
        { wavelength_nm = 700.0, a_per_m = 0.20, b_per_m = 0.20 } ]
phase_function = { model = "henyey-greenstein", g = 0.6 }
[[sea.layer]]
bottom_depth_m = 9.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.10, b_per_m = 0.30, a_phytoplankton_per_m = 0.04 },
        { wavelength_nm = 700.0, a_per_m = 0.25, b_per_m = 0.15 } ]
phase_function = { model = "henyey-greenstein", g = 0.5 }
)";

/// One telescope over the sea, one in it, three channels, gates beyond the bed.
scene::Scene bright_scene(double photons, std::uint64_t seed, const std::string& more) {
  return read(ship_instrument + submerged_telescope + channel("elastic") + channel("raman") +
              channel("chlorophyll") + bright_layers + depth_gates(12, 1) +
              simulation(photons, seed, more));
}

/// Nothing beyond the plain walk, scored where photons collide.
const std::string plainly = "scored_points = 1\n[simulation.tools]\nweight_threshold = 1e-8\n";
std::string with(const std::string& tools) { return "[simulation.tools]\n" + tools + "\n"; }

/// Undirected elastic light. Shares of a photon are then between 0 and 1, but where it is split, so
/// that the variance of an account is below its mean.
scene::Scene quiet_scene(double photons, std::uint64_t seed, const std::string& more) {
  return read(ship_instrument + channel("elastic") + bright_layers + depth_gates(12, 1) +
              simulation(photons, seed, "directed_fraction = 0\n" + more));
}

void add_ledgers(ZFamily& family, const tally::Result& a, const tally::Result& b,
                 const std::string& name) {
  const auto add = [&](double x, double y, const std::string& what) {
    const double error =
        std::sqrt(x / static_cast<double>(a.photons) + y / static_cast<double>(b.photons));
    family.add(x, y, error, fmt::format("{}, {}: {} and {}", name, what, x, y));
  };
  add(a.ledger.absorbed, b.ledger.absorbed, "absorbed");
  add(a.ledger.escaped, b.ledger.escaped, "escaped");
  add(a.ledger.sea_bed, b.ledger.sea_bed, "sea bed");
}

struct Case {
  std::string name, tools;
};
const std::vector<Case> tools_one_by_one{
    {"points of flights", ""},
    {"forced collisions", "forced_collisions = 1000"},
    {"first forced collisions", "forced_collisions = 2"},
    {"local forced collisions", "local_forced_collisions = \"all\""},
    {"importance",
     "importance = [ { depth_m = 2, value = 2 }, { depth_m = 4, value = 5 }, { depth_m "
     "= 7, value = 0.7 } ]"},
    {"early roulette", "weight_threshold = 0.3"},
    {"analog absorption", "weight_threshold = 1\nat_threshold = \"analog-absorption\""},
    {"late analog absorption", "weight_threshold = 0.5\nat_threshold = \"analog-absorption\""},
    {"all at once",
     "forced_collisions = 3\nlocal_forced_collisions = \"all\"\nweight_threshold = 0.3\n"
     "importance = [ { depth_m = 3, value = 3 } ]"}};

// Seen red, each in its case: with the chance of leaving not taken from the weight; with the weight
// not divided at splitting; with the copies dropped; with collisions scored on the way and where
// they happen; with further points on the way besides; with such points of flights that are kept in
// the water by the number of one that is not; with the weight of those that pass an analog test of
// absorption left lower.
TEST(Tools, LeaveEchoesAsTheyAre) {
  const auto plain = run_in_lanes(bright_scene(2e6, 6, plainly));
  ZFamily family(0.01);
  for (const Case& c : tools_one_by_one) {
    const auto result = run_in_lanes(bright_scene(1e6, 5, with(c.tools)));
    EXPECT_EQ(result.ledger.lost, 0);
    EXPECT_GE(add_settled(family, result, plain, c.name), 25U) << c.name;
  }
  family.judge();
}

// Four points of a flight are worth more than one: half the error near the surface, where few
// photons collide in a gate. Seen red: with the flight's own point taken four times.
TEST(Points, HalveErrors) {
  const auto scene = [](const std::string& more) {
    return read(ship_instrument + channel("elastic") + water(0.06, 0.1, henyey_greenstein_phase) +
                depth_gates(8, 1) + simulation(4e5, 6, more));
  };
  const auto one = run_in_lanes(scene("scored_points = 1")), four = run_in_lanes(scene(""));
  ZFamily family(0.01);
  EXPECT_EQ(add_settled(family, one, four), 8U);
  family.judge();
  for (std::size_t gate = 0; gate < 8; ++gate)
    EXPECT_LT(four.echo.standard_error[gate], 0.7 * one.echo.standard_error[gate]) << gate;
}

// Seen red: with the surface's losses taken again from photons that are kept from leaving; with
// what leaves not booked.
TEST(Tools, LeaveTheLedgerAsItIs) {
  const auto plain = run_in_lanes(quiet_scene(4e6, 6, plainly));
  ZFamily family(0.01);
  for (const Case& c : tools_one_by_one) {
    SCOPED_TRACE(c.name);
    const auto result = run_in_lanes(quiet_scene(2e6, 5, with(c.tools)));
    add_ledgers(family, result, plain, c.name);
    EXPECT_NEAR(result.ledger.sum(), 1, 1.5e-3);
    EXPECT_EQ(result.ledger.cut_by_weight, 0);
  }
  family.judge();
}

// Ratios of environments are those of the paths, whatever drew them. Seen red: with the way to a
// chosen point, or to a further point of a flight, or flights, left out of them.
TEST(Tools, LeaveEnvironmentsAsTheyAre) {
  const auto other = [](const std::string& more) {
    auto scene = quiet_scene(2e6, 6, more);
    scene.sea.layer[0].iop[0].a_per_m = 0.08;
    scene.sea.layer[1].iop[0].b_per_m = 0.24;
    return scene;
  };
  const auto own = run_in_lanes(other(plainly));
  ZFamily family(0.01);
  for (const Case& c : tools_one_by_one) {
    auto scene = quiet_scene(1e6, 5, with(c.tools));
    scene.environment.push_back({"other", {}, scene.optics, other("").sea});
    const auto all = run_in_lanes(scene);
    tally::Result environment = all;
    environment.echo = all.environment_echo;
    EXPECT_GE(add_settled(family, environment, own, c.name), 5U) << c.name;
  }
  family.judge();
}

// Ending histories does not: echoes are low, the more the deeper, and what is cut is reported. Seen
// red: with what is cut not booked.
TEST(Tools, EndingHistoriesReportsWhatItCuts) {
  const auto plain = run_in_lanes(quiet_scene(2e6, 6, ""));
  const auto ended =
      run_in_lanes(quiet_scene(2e6, 5, with("weight_threshold = 0.6\nat_threshold = \"end\"")));
  EXPECT_NEAR(ended.ledger.sum(), 1, 1.5e-3);
  EXPECT_GT(ended.ledger.cut_by_weight, 0.05);
  ASSERT_EQ(ended.warnings.size(), 1U);
  EXPECT_NE(ended.warnings[0].find("of the launched weight: echoes are low"), std::string::npos);
  double lowest = 0;
  for (std::size_t gate = 0; gate < 8; ++gate) {
    const double z = (ended.echo.mean[gate] - plain.echo.mean[gate]) /
                     std::hypot(ended.echo.standard_error[gate], plain.echo.standard_error[gate]);
    EXPECT_LT(z, 4) << gate;
    lowest = std::min(lowest, z);
  }
  EXPECT_LT(lowest, -5);
}

/// Big lenses with wide views over and in water that turns much light back and makes much of it
/// fluoresce: what a photon can fall on.
scene::Scene big_lenses(const std::string& estimator, double photons, std::uint64_t seed) {
  return read(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 5.0]
direction = [0.05, 0.0, -1.0]
diameter_m = 0.1
half_divergence_mrad = 20.0
[[telescope]]
position_m = [0.0, 0.2, 5.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 3.0
focal_length_m = 2.0
detector_diameter_m = 2.0
detector_shift_m = 0.1
obstruction_diameter_m = 0.8
[[telescope]]
name = "below"
position_m = [3.0, 0.0, -2.0]
direction = [-1.0, 0.1, 0.9]
diameter_m = 1.0
focal_length_m = 0.5
detector_diameter_m = 0.6
)" + channel("elastic") +
              channel("raman") + channel("chlorophyll") + R"(
[[sea.layer]]
bottom_depth_m = 3.0
chlorophyll_yield = 1.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.20, b_per_m = 0.40, a_phytoplankton_per_m = 0.15 },
        { wavelength_nm = 700.0, a_per_m = 0.05, b_per_m = 0.30 } ]
phase_function = { model = "henyey-greenstein", g = 0.3 }
[[sea.layer]]
bottom_depth_m = 9.0
chlorophyll_yield = 0.5
iop = [ { wavelength_nm = 532.0, a_per_m = 0.10, b_per_m = 0.20, a_phytoplankton_per_m = 0.05 },
        { wavelength_nm = 700.0, a_per_m = 0.05, b_per_m = 0.60 } ]
phase_function = "isotropic"
[gates]
start_ns = 24.0
stop_ns = 104.0
step_ns = 4.0
)" + simulation(photons, seed, "max_order = 30", estimator));
}

// What falls on the detectors is what local estimates expect, in all light, in the air and in the
// water, of the surface's mirror too; and by order of scattering. Seen red: with the obstruction
// open; with all light let through the surface from below; with light that it reflects not
// received; with the last way in the water timed as in the air.
TEST(AnalogPhotons, AreCountedAsOftenAsTheForwardEstimatorExpects) {
  const auto expected = run_in_lanes(big_lenses("forward", 2e6, 3));
  const auto counted = run_in_lanes(big_lenses("analog", 2e7, 4));
  compare(counted, expected, 15);
  EXPECT_NEAR(counted.ledger.sum(), 1, 1e-12);
  ZFamily orders(0.01);
  const auto &a = counted.grid("echo_by_order"), &b = expected.grid("echo_by_order");
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double error = std::hypot(a.standard_error[i], b.standard_error[i]);
    if (error < 0.1 * a.mean[i]) orders.add(a.mean[i], b.mean[i], error, fmt::format("{}", i));
  }
  EXPECT_GT(orders.size(), 40U);
  orders.judge();
}

}  // namespace
}  // namespace photic::test
