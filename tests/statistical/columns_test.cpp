// Columns of water side by side, run as users run them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "run/run.hpp"
#include "support/films.hpp"
#include "support/lit_scenes.hpp"
#include "support/own_runs.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

std::string column(const std::string& keys, const std::string& layers) {
  return "[[sea.column]]\n" + keys + layers;
}
std::string layer(double a_per_m, double b_per_m, double g, double bottom_m = 0) {
  return "[[sea.column.layer]]\n" +
         (bottom_m > 0 ? fmt::format("bottom_depth_m = {}\n", bottom_m) : "") +
         scattering(a_per_m, b_per_m, g);
}
std::string sea_with(const std::string& surface, const std::string& keys = "") {
  return "[sea]\nsurface = { " + surface + " }\n" + keys;
}

// A lidar over the first column, that looks across the face into the other one (world.md, section
// E): 30 degrees off nadir from 12 m, the face 5.36 m along the ray in the water.
constexpr double index_of_water = 1.34, transmittance = 0.977801,
                 in_air_m = 12 / 0.8660254037844386, to_face_m = 2 / (0.5 / index_of_water),
                 lens_radius_m = 0.2;

/// Order 1 per metre of path, in closed form.
double across_face(double s) {
  const double cos_air = std::sqrt(0.75), sin_water = 0.5 / index_of_water,
               cos_water = std::sqrt(1 - sin_water * sin_water);
  const double area_per_solid_angle =
      (s * cos_air / cos_water + index_of_water * in_air_m * cos_water / cos_air) *
      (s + index_of_water * in_air_m);
  const double beyond = std::max(0.0, s - to_face_m);
  const double b = beyond > 0 ? 0.1 : 0.05;
  const double depth = 0.1 * std::min(s, to_face_m) + 0.3 * beyond;
  return b / (4 * pi) * pi * lens_radius_m * lens_radius_m * transmittance * transmittance *
         std::exp(-2 * depth) / area_per_solid_angle;
}
TEST(Columns, HaveTheClosedFormOfOrder1) {
  for (const auto& [s, value] : {std::pair{3.0, 5.36072e-7},
                                 {5.0, 3.03847e-7},
                                 {5.3599, 2.74726e-7},
                                 {5.4, 5.34726e-7},
                                 {7.0, 1.81083e-7},
                                 {9.0, 4.72464e-8}})
    EXPECT_NEAR(across_face(s), value, 1e-4 * value) << s;
}

std::string seen_across_face(double photons, const std::string& more = "") {
  const double metre_ns = 2e9 * index_of_water / speed_of_light_m_s;
  const double start_ns = 2e9 * in_air_m / speed_of_light_m_s + 2 * metre_ns;
  const std::string place =
      "position_m = [-6.92820323027551, 0.0, 12.0]\n"
      "direction = [0.5, 0.0, -0.8660254037844386]\n";
  const std::string isotropic = "phase_function = \"isotropic\"\n";
  return "[source]\nwavelength_nm = 532.0\n" + place +
         "diameter_m = 1e-4\nhalf_divergence_mrad = 1e-4\n[[telescope]]\n" + place +
         "diameter_m = 0.4\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 200.0\n" +
         channel("elastic") +
         fmt::format("[gates]\nstart_ns = {:.17g}\nstop_ns = {:.17g}\nstep_ns = {:.17g}\n",
                     start_ns, start_ns + 8 * metre_ns, metre_ns) +
         "[sea]\nrefractive_index = 1.34\ngroup_index = 1.34\n" +
         column("x_max_m = 2.0\n",
                "[[sea.column.layer]]\niop = [{ wavelength_nm = 532.0, a_per_m = 0.05, "
                "b_per_m = 0.05 }]\n" +
                    isotropic) +
         column("",
                "[[sea.column.layer]]\niop = [{ wavelength_nm = 532.0, a_per_m = 0.2, "
                "b_per_m = 0.1 }]\n" +
                    isotropic) +
         simulation(photons, 63, more);
}

// From 2 to 10 m of path, with the face within a gate: by lanes and one by one, scored at
// collisions alone and at further points. Seen red: with the first column's optical depth for all
// ways home.
TEST(Columns, AreSeenAcrossAFace) {
  using boost::math::quadrature::gauss_kronrod;
  ZFamily family(0.01);
  for (const bool in_lanes : {true, false})
    for (const int points : {1, 3}) {
      const auto scene =
          read(seen_across_face(2e5, fmt::format("scored_points = {}\norders_kept = 2", points)));
      run::RunOptions options;
      if (in_lanes) options.lanes = isa_of_tests();
      const auto result = run::run(scene, *test::tables(), options);
      const auto& orders = result.grid("echo_by_order");
      for (std::size_t gate = 0; gate < 8; ++gate) {
        const double from = 2 + static_cast<double>(gate);
        const auto integral = [&](double a, double b) {
          return b > a ? gauss_kronrod<double, 15>::integrate(across_face, a, b) : 0.0;
        };
        const double expected = integral(from, std::clamp(to_face_m, from, from + 1)) +
                                integral(std::clamp(to_face_m, from, from + 1), from + 1);
        const std::size_t first_order = 8 + gate;
        family.add(orders.mean[first_order], expected, orders.standard_error[first_order],
                   fmt::format("{} {} {}: {} for {}", in_lanes, points, gate,
                               orders.mean[first_order], expected));
      }
    }
  std::printf("across a face: %zu gates, rms z %.2f\n", family.size(), family.rms());
  family.judge();
  family.judge_scatter();
}

std::string lidar_over(double x, const std::string& lens_at = "[0.3, 0.1, 4.0]",
                       const std::string& looking = "[0.1, 0.05, -1.0]") {
  return fmt::format(
      "[source]\nwavelength_nm = 355.0\nposition_m = [{}, 0.0, 4.0]\ndirection = [0.1, 0.0, -1.0]\n"
      "diameter_m = 0.05\nhalf_divergence_mrad = 40.0\n"
      "[[telescope]]\nposition_m = {}\ndirection = {}\ndiameter_m = 2.0\n"
      "focal_length_m = 4.0\nhalf_field_of_view_mrad = 500.0\n",
      x, lens_at, looking);
}
const std::string five_gates = "[gates]\nstart_ns = 20.0\nstop_ns = 70.0\nstep_ns = 10.0\n";
const std::string with_raman = channel("raman") + channel("elastic");
const std::string shallow_bed = "[bottom]\nalbedo = 0.3\n";
/// Of the first column; the other's is black.
const std::string bright_bed = "[sea.column.bottom]\nalbedo = 0.5\n";

// Light goes the same ways where columns are alike as where there are none: to the last bit in one
// alone, within errors in several.
TEST(Columns, ThatAreAlikeAreASea) {
  const auto layers = [](const std::string& name) {
    return "[[sea" + name + ".layer]]\nbottom_depth_m = 1.0\n" + scattering(0.1, 0.3, 0.5) +
           "[[sea" + name + ".layer]]\nbottom_depth_m = 3.0\nchlorophyll_mg_m3 = 5.0\n";
  };
  const std::pair<std::string, std::string> surfaces[] = {{flat, ""}, {waves, ""}, {flat, film(2)}};
  for (const auto& [surface, oil] : surfaces) {
    const auto scene = [&](const std::string& sea, std::uint64_t seed) {
      return run_in_lanes(read(lidar_over(0) + with_raman + five_gates + sea + shallow_bed + oil +
                               simulation(2e5, seed)));
    };
    const auto plain = scene(sea_with(surface) + layers(""), 1);
    const auto one = scene(sea_with(surface) + column("", layers(".column")), 1);
    EXPECT_EQ(plain.echo.mean, one.echo.mean);
    EXPECT_EQ(plain.echo.standard_error, one.echo.standard_error);
    const auto three = scene(sea_with(surface, "y_min_m = -1000.0\n") +
                                 column("x_max_m = 0.1\n", layers(".column")) +
                                 column("x_max_m = 0.6\n", layers(".column")) +
                                 column("x_max_m = 1000.0\n", layers(".column")),
                             2);
    expect_same_light(plain, three, fmt::format("three alike, {} {}", surface, oil), 0.06, 10);
  }
}

struct Row {
  const char* name;
  std::string instruments, surface, columns, bottom = shallow_bed;
};
const std::string front =
    column("x_max_m = 0.4\n", layer(0.05, 0.2, 0.3, 1) + layer(0.1, 0.4, 0.3, 3)) +
    column("", layer(0.3, 1.0, 0.3, 2) + layer(0.05, 0.3, 0.3, 3));
/// The water is clear where lenses are, as near scattering makes tails of single scores heavy.
const std::string front_over_clear_water =
    column("x_max_m = 0.4\n", layer(0.05, 0.4, 0.3, 1.5) + layer(0.1, 0, 0.3, 3)) +
    column("", layer(0.3, 1.0, 0.3, 1.7) + layer(0.05, 0, 0.3, 3));
/// Its end is in the view, its sides are beside the beam.
const std::string raft = column("x_min_m = -0.3\nx_max_m = 0.4\n", layer(0.05, 0.2, 0.3, 3)) +
                         column("x_max_m = 0.9\n", layer(0.3, 1.0, 0.3, 3));
std::string below(double laser, double lens) {
  return fmt::format(
      "[source]\nwavelength_nm = 355.0\nposition_m = [0.0, 0.0, {}]\ndirection = [0.1, 0.0, {}]\n"
      "diameter_m = 0.05\nhalf_divergence_mrad = 40.0\n"
      "[[telescope]]\nposition_m = [0.3, 0.1, {}]\ndirection = [0.2, 0.1, {}]\ndiameter_m = 1.5\n"
      "focal_length_m = 2.0\nhalf_field_of_view_mrad = 500.0\n",
      laser, laser > 0 ? -1.0 : 1.0, lens, lens > 0 ? -1.0 : 1.0);
}
const std::string beds = column("x_max_m = 0.2\n", layer(0.05, 0.1, 0.3, 1) + bright_bed) +
                         column("", layer(0.05, 0.1, 0.3, 1));
const Row rows[] = {
    {"a front in view", lidar_over(0), flat, front},
    {"a front under waves", lidar_over(0), waves, front},
    {"a front over a black bed", lidar_over(0), flat, front, ""},
    {"two beds", lidar_over(0), flat, beds, ""},
    {"a raft", lidar_over(0), flat, raft},
    {"a raft from the side", lidar_over(0, "[2.5, 0.1, 1.5]", "[-1.0, 0.0, -0.7]"), flat, raft},
    {"a raft under waves", lidar_over(0), waves, raft},
    {"a lens below a front", below(4, -2.5), flat, front_over_clear_water},
    {"a lens below a front and waves", below(4, -2.5), waves, front_over_clear_water}};

scene::Scene scene_of(const Row& row, double photons, const std::string& estimator,
                      const std::string& more = "", std::uint64_t seed = 21,
                      const std::string& settings = "", const std::string& top = "") {
  const std::string sides = row.columns == raft ? "y_min_m = -0.4\ny_max_m = 0.5\n" : "";
  return read(top + row.instruments + with_raman + five_gates + sea_with(row.surface, sides) +
              row.columns + row.bottom + more + simulation(photons, seed, settings, estimator));
}

// Seen red: with light that comes up beyond the ends of the row.
TEST(Columns, SendTheLightThatPhotonsMeetByChance) {
  for (const Row& row : rows) {
    const auto analog = run_in_lanes(scene_of(row, 4e6, "analog"));
    const auto forward = run_in_lanes(scene_of(row, 2e5, "forward"));
    expect_same_light(analog, forward, row.name, 0.1, 6);
    EXPECT_NEAR(forward.ledger.sum(), 1, 5 * forward.ledger_standard_error + 1e-6);
    EXPECT_NEAR(analog.ledger.sum(), 1, 5 * analog.ledger_standard_error + 1e-6);
    if (row.columns == raft) {
      EXPECT_GT(forward.ledger.escaped, 0.3);
    }
  }
}

// The paper's tools leave the mean as it is.
TEST(Columns, HoldForcedAndSplitLight) {
  const std::string tools =
      "tools = { forced_collisions = 2, local_forced_collisions = \"all\", "
      "importance = [{ depth_m = 0.8, value = 3.0 }] }\n";
  for (const Row& row : rows) {
    if (row.surface != flat) continue;
    const auto plain = run_in_lanes(scene_of(row, 2e5, "forward"));
    const auto by_tools = run_in_lanes(scene_of(row, 1e5, "forward", "", 22, tools));
    expect_same_light(plain, by_tools, fmt::format("tools, {}", row.name), 0.06, 10);
    EXPECT_NEAR(by_tools.ledger.sum(), 1, 5 * by_tools.ledger_standard_error + 1e-6);
  }
}

// An environment changes one column; a derivative is by its absorption. Seen red: with the excess
// depth of the column where the light was scattered for all of its way home.
TEST(Columns, HaveEnvironmentsEach) {
  const std::string changed =
      "[[environment]]\nset = { \"sea.column.1.layer.0.iop.0.a_per_m\" = 0.4, "
      "\"sea.column.0.layer.0.iop.0.b_per_m\" = 0.25 }\n"
      "[[environment]]\nset = { \"sea.column.1.layer.0.iop.0.a_per_m\" = 0.303 }\n"
      "[[environment]]\nset = { \"sea.column.1.layer.0.iop.0.a_per_m\" = 0.297 }\n";
  for (const Row& row : rows) {
    if (row.columns == front_over_clear_water) continue;  // few gates are known well enough
    const auto scene = scene_of(row, 2e5, "forward", changed, 21, "",
                                "sensitivity = [\"sea.column.1.layer.0.iop.0.a_per_m\"]\n");
    const auto all = run_in_lanes(scene);
    const auto own = scene_of(row, 2e5, "forward", changed, 23);
    ZFamily family(0.01);
    compare_environment(all, 0, run_in_lanes(scene::scene_in(own, own.environment[0])), family,
                        row.name);
    std::printf("environment, %s: %zu cells, rms z %.2f\n", row.name, family.size(), family.rms());
    EXPECT_GE(family.size(), 3U);
    family.judge();
    if (row.columns == front) expect_derivative_by_steps(all, 0, 1, 0.003, row.name);
  }
}

// Seen from the other side, a row is that whose columns change places.
TEST(Columns, HaveMirrorImages) {
  const auto mirrored = [](bool mirror, std::uint64_t seed) {
    const double side = mirror ? -1 : 1;
    const std::string instruments = fmt::format(
        "[source]\nwavelength_nm = 355.0\nposition_m = [{0}, 0.0, 4.0]\ndirection = [{1}, 0.0, "
        "-1.0]\ndiameter_m = 0.05\nhalf_divergence_mrad = 40.0\n[[telescope]]\nposition_m = [{2}, "
        "0.1, 4.0]\ndirection = [{1}, 0.05, -1.0]\ndiameter_m = 0.5\nfocal_length_m = 4.0\n"
        "half_field_of_view_mrad = 500.0\n",
        0.05 * side, 0.1 * side, 0.3 * side);
    const std::string clear = layer(0.05, 0.2, 0.3, 1) + layer(0.1, 0.4, 0.3, 3),
                      turbid = layer(0.3, 1.0, 0.3, 3);
    const std::string row =
        mirror
            ? column("x_min_m = -0.9\nx_max_m = -0.4\n", turbid) + column("x_max_m = 0.3\n", clear)
            : column("x_min_m = -0.3\nx_max_m = 0.4\n", clear) + column("x_max_m = 0.9\n", turbid);
    return run_in_lanes(read(instruments + with_raman + five_gates + sea_with(flat) + row +
                             shallow_bed + simulation(3e5, seed)));
  };
  expect_same_light(mirrored(false, 3), mirrored(true, 4), "a row and its mirror image", 0.06, 10);
}

// Of a disc of light over the end of a row the circular segment beyond it meets nothing; water with
// the index of air reflects nothing. Seen red: with a surface beside the row.
TEST(Columns, HaveNoSurfaceBesideThem) {
  const double radius = 0.5, aside = 0.25;
  const double on_row = (std::acos(aside / radius) -
                         aside / radius * std::sqrt(1 - aside * aside / radius / radius)) /
                        pi;
  for (const std::string estimator : {"forward", "analog"}) {
    const auto result = run_in_lanes(
        read(light("beam", "position_m = [0, 0, 3]\nzenith_deg = 0\ndiameter_m = 1.0") +
             tally_of("boundaries") + "[sea]\nrefractive_index = 1.0\n" +
             column("x_min_m = 0.25\n", layer(0.2, 0.1, 0.3)) + simulation(1e5, 7, "", estimator)));
    const Known missed = known(result, "reflected_by_surface");
    EXPECT_NEAR(missed.value, 1 - on_row, 4 * missed.error) << estimator;
    EXPECT_LT(missed.error, 0.003);
    const Known balance = known(result, "balance");
    EXPECT_NEAR(balance.value, 1, 4 * balance.error + 1e-6) << estimator;
  }
}

// Light does not know where the origin of a scene is. Seen red: with faces, or sides, that stay
// where they are.
TEST(Columns, MayStandAnywhere) {
  const auto moved = [](double x, double y) {
    const auto at = [&](double z, double from_x) {
      return fmt::format("position_m = [{}, {}, {}]\n", x + from_x, y, z);
    };
    return run_in_lanes(
        read("[source]\nwavelength_nm = 355.0\n" + at(4, 0) +
             "direction = [0.1, 0.0, -1.0]\ndiameter_m = 0.05\nhalf_divergence_mrad = 40.0\n"
             "[[telescope]]\n" +
             at(4, 0.3) +
             "direction = [0.1, 0.05, -1.0]\ndiameter_m = 0.5\n"
             "focal_length_m = 4.0\nhalf_field_of_view_mrad = 500.0\n" +
             with_raman + five_gates +
             sea_with(flat, fmt::format("y_min_m = {}\ny_max_m = {}\n", y - 0.4, y + 0.5)) +
             column(fmt::format("x_min_m = {}\nx_max_m = {}\n", x - 0.3, x + 0.4),
                    layer(0.05, 0.2, 0.3, 3)) +
             column(fmt::format("x_max_m = {}\n", x + 0.9), layer(0.3, 1.0, 0.3, 3)) + shallow_bed +
             simulation(5e4, 6)));
  };
  const auto here = moved(0, 0);
  for (const auto& [x, y] : {std::pair{64.0, 0.0}, {0.0, -32.0}}) {
    const auto there = moved(x, y);
    for (std::size_t i = 0; i < here.echo.mean.size(); ++i)
      EXPECT_NEAR(there.echo.mean[i], here.echo.mean[i], 1e-3 * here.echo.mean[i]) << i;
    EXPECT_NEAR(there.ledger.escaped, here.ledger.escaped, 1e-4);
  }
}

// A front that moves through the beam takes the echo from one water's to the other's.
TEST(Columns, TakeTheEchoFromOneWaterToTheOther) {
  std::vector<tally::Result> moved;
  for (const double face : {-50.0, -0.3, 0.0, 0.2, 0.5, 50.0})
    moved.push_back(run_in_lanes(
        read(lidar_over(0) + channel("elastic") + five_gates + sea_with(flat) +
             column(fmt::format("x_max_m = {}\n", face), layer(0.05, 0.1, 0.3, 3)) +
             column("", layer(0.05, 0.8, 0.3, 3)) + simulation(2e5, 5, "orders_kept = 1"))));
  const std::size_t gates = moved.front().echo.mean.size();
  int apart = 0;
  for (std::size_t i = 1; i < moved.size(); ++i)
    for (std::size_t gate = 0; gate < gates; ++gate) {
      const auto &before = moved[i - 1].grid("echo_by_order"),
                 &after = moved[i].grid("echo_by_order");
      const std::size_t cell = gates + gate;  // order 1
      const double error = std::hypot(before.standard_error[cell], after.standard_error[cell]);
      // The first gate's water is bright where it is turbid.
      if (gate > 1) continue;
      EXPECT_LT(after.mean[cell], before.mean[cell] + 4 * error) << i << " " << gate;
      apart += after.mean[cell] < before.mean[cell] - 10 * error ? 1 : 0;
    }
  EXPECT_GE(apart, 2);
}

}  // namespace
}  // namespace photic::test
