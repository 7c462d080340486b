// First-order echoes of whole runs against the lidar equation integrated over every gate.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/problem.hpp"
#include "engine/run.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/phase_functions.hpp"
#include "support/lidar_equation.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/slant_path.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

constexpr double level = 0.01;  // of the family of all gates of a scene
/// How precisely an estimator is held to the equation.
struct Precision {
  std::string simulation;
  double largest_error;       ///< relative standard error that every gate must reach
  double largest_difference;  ///< relative
  bool independent_gates;
};
/// One scattering each. The equation has the overlap's mean over the lens.
const Precision forward{
    simulation(1.25e7, 7, "max_order = 1\norders_kept = 1\nreception = \"overlap\""), 0.005, 0.005,
    true};
/// Where every photon's score is about the same.
const Precision forward_in_short{
    simulation(1e6, 7, "max_order = 1\norders_kept = 1\nreception = \"overlap\""), 0.005, 0.005,
    true};
/// Meetings of one pair of walks are seen in many gates. To points of the lens ways are longer, and
/// solid angles smaller, than to its centre: by some 1e-4, less than these errors.
const Precision bidirectional{simulation(4e5, 7, "max_order = 1\norders_kept = 1", "bidirectional"),
                              0.01, 0.02, false};

/// The water that light of a line sees on its way.
EquationWater water_of(const medium::Medium& medium, std::size_t line,
                       const std::function<double(double)>& phase) {
  const auto layers = static_cast<std::size_t>(medium.layers());
  EquationWater water;
  water.n_out = medium.line[0].refractive_index;
  water.group_out = medium.line[0].group_index;
  water.n_back = medium.line[line].refractive_index;
  water.group_back = medium.line[line].group_index;
  for (std::size_t k = 0; k < layers; ++k) {
    const double share = line == 0 ? medium.albedo[k] : medium.conversion[line * layers + k];
    water.layers.push_back(
        {medium.top[k], medium.c[k], medium.c[line * layers + k], share * medium.c[k]});
  }
  water.phase = phase;
  return water;
}

/// Where the gates of a telescope and channel begin and end, as group path: that to the depths that
/// the result tells of them, where there are any and the light is of one line.
std::vector<double> edge_paths(const engine::Problem& problem, std::size_t telescope,
                               std::size_t channel) {
  const tally::Result told = engine::describe(problem);
  const auto& lines = problem.medium.line;
  const auto counted = [&](const medium::Line& line) { return line.counted_by[channel] > 0; };
  const bool one_line = std::ranges::count_if(lines, counted) == 1;
  const auto back = std::ranges::find_if(lines, counted);
  std::vector<double> edges;
  for (std::int32_t e = 0; e <= problem.gates.count(); ++e) {
    const std::size_t row = telescope * told.channels() + channel;
    const double depth =
        told.gate_depth_edge_m[row * (told.gates() + 1) + static_cast<std::size_t>(e)];
    edges.push_back(told.gate_depth_is_range || !one_line
                        ? problem.gates.edge_path(e)
                        : slant_path(problem.scene.source, problem.scene.telescope[telescope],
                                     lines.front(), *back, depth));
  }
  return edges;
}

/// What a scene's first order should be in one channel and telescope: the light of all its lines.
std::vector<double> expected(const engine::Problem& problem, std::size_t telescope,
                             std::size_t channel, const std::function<double(double)>& phase) {
  const std::vector<double> edges = edge_paths(problem, telescope, channel);
  std::vector<double> sum(edges.size() - 1, 0.0);
  for (std::size_t line = 0; line < problem.medium.line.size(); ++line) {
    const double counted = problem.medium.line[line].counted_by[channel];
    if (counted == 0) continue;
    const auto echo = first_order_echo(problem.scene.source, problem.scene.telescope[telescope],
                                       water_of(problem.medium, line, phase), edges);
    for (std::size_t g = 0; g < sum.size(); ++g) sum[g] += counted * echo[g];
  }
  return sum;
}

/// Runs a problem at first order and holds every gate of every telescope and channel against the
/// equation, [telescope * channels + channel][gate].
void compare(const tally::Result& result, const Precision& precision,
             const std::vector<std::vector<double>>& equations) {
  ZFamily family(level);
  double largest = 0;
  for (std::size_t t = 0; t < result.telescopes(); ++t) {
    for (std::size_t c = 0; c < result.channels(); ++c) {
      const auto& equation = equations[t * result.channels() + c];
      // Gates are independent of each other; channels and telescopes see the same collisions.
      ZFamily gates(level / static_cast<double>(result.telescopes() * result.channels()));
      for (std::size_t g = 0; g < result.gates(); ++g) {
        const std::size_t i = (t * result.channels() + c) * result.gates() + g;
        const double mean = result.echo.mean[i];
        const double error = result.echo.standard_error[i];
        const auto where = fmt::format("telescope {} channel {} gate {}: {} +- {}, equation {}", t,
                                       c, g, mean, error, equation[g]);
        if (equation[g] == 0) {  // before the first light
          EXPECT_EQ(mean, 0) << where;
          continue;
        }
        EXPECT_LT(error, precision.largest_error * equation[g]) << where;
        EXPECT_LT(std::abs(mean - equation[g]), precision.largest_difference * equation[g])
            << where;
        largest = std::max(largest, std::abs(mean / equation[g] - 1));
        family.add(mean, equation[g], error, where);
        gates.add(mean, equation[g], error, where);
      }
      if (precision.independent_gates) gates.judge_spread();
    }
  }
  std::printf("largest difference %.2f %% in %zu gates\n", 100 * largest, family.size());
  family.judge();
}

std::function<double(double)> shape(const optics::PhaseShape& s) {
  return [s](double cosine) { return s.p(std::max(1 - cosine, 1e-7)); };
}

/// By both estimators.
void compare(const std::string& toml,
             const std::vector<std::function<double(double)>>& phase_of_channel,
             const std::vector<Precision>& precisions = {forward, bidirectional}) {
  std::vector<std::vector<double>> equations;
  for (const Precision& precision : precisions) {
    SCOPED_TRACE(precision.simulation);
    const auto scene = read(toml + precision.simulation);
    if (equations.empty()) {
      const auto problem = engine::make_problem(scene);
      for (std::size_t t = 0; t < scene.telescope.size(); ++t) {
        for (std::size_t c = 0; c < phase_of_channel.size(); ++c)
          equations.push_back(expected(problem, t, c, phase_of_channel[c]));
      }
    }
    compare(run_in_lanes(scene), precision, equations);
  }
}

// Seen red: with n^2 left out of the refraction factor; with half for full divergence; with the
// refractive index for the group index on the way out, or on the way home; with nothing reflected
// where light leaves the water; with 1 % too much in c / c', or in the absorption along the way;
// with further points of a flight drawn too often where its free path is long.
TEST(FirstOrder, FlatSea) {
  compare(ship_instrument + channel("elastic") +
              water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") + depth_gates(50, 2),
          {shape(optics::henyey_greenstein(0.6))});
}

// Where a walk meets the laser's rays though it does not collide once. The forward estimator does
// not see anything there. Seen red: with echoes of batches below 1e-12 taken for none.
TEST(FirstOrder, WaterThatHardlyScatters) {
  for (const double per_m : {1e-7, 1e-12})
    compare(ship_instrument + channel("elastic") +
                water(per_m, per_m, "{ model = \"henyey-greenstein\", g = 0.6 }") +
                depth_gates(50, 5),
            {shape(optics::henyey_greenstein(0.6))}, {bidirectional});
}

// Seen red: with the obstruction left out of the lens' area, or of its image; with the blur of an
// infinitely far point; with a free path that crosses one edge at most; with the rest of a free
// path, or the absorption along it, by the coefficient of the layer it began in.
TEST(FirstOrder, ThreeLayersAndThreeTelescopes) {
  compare(ship_instrument + R"(
[[telescope]]
name = "aside, obstructed, defocused"
position_m = [0.5, -0.3, 12.0]
direction = [-0.02, 0.012, -1.0]
diameter_m = 0.40
focal_length_m = 1.0
detector_diameter_m = 0.06
detector_shift_m = 0.02
obstruction_diameter_m = 0.15
[[telescope]]
name = "wide, higher"
position_m = [0.0, 1.0, 20.0]
direction = [0.0, -0.02, -1.0]
diameter_m = 0.30
focal_length_m = 1.0
half_field_of_view_mrad = 80.0
)" + channel("elastic") +
              R"(
[[sea.layer]]
bottom_depth_m = 7.3
iop = [ { wavelength_nm = 532.0, a_per_m = 0.02, b_per_m = 0.04 } ]
phase_function = { model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 }
[[sea.layer]]
bottom_depth_m = 21.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.04, b_per_m = 0.02 } ]
phase_function = { model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.01, b_per_m = 0.05 } ]
phase_function = { model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 }
[gates]
depth_max_m = 50.0
depth_step_m = 2.5
)",
          {shape(optics::fournier_forand(1.10, 3.5835))});
}

// Seen red: with the laser's wavelength for the emitted one in the optical depth, the refractive
// index or the group index of the way home; with the refractive index for the group index on the
// way out; with converted light taken for scattered.
TEST(FirstOrder, RamanAndFluorescenceHaveTwoWavelengths) {
  const auto lambert = [](double) { return 1 / (4 * pi); };
  compare(ship_instrument + channel("elastic") + channel("raman") + channel("chlorophyll") + R"(
[[sea.layer]]
bottom_depth_m = 10.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.03, b_per_m = 0.03, a_phytoplankton_per_m = 0.01 },
        { wavelength_nm = 700.0, a_per_m = 0.10, b_per_m = 0.02 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.04, b_per_m = 0.02, a_phytoplankton_per_m = 0.005 },
        { wavelength_nm = 700.0, a_per_m = 0.15, b_per_m = 0.01 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[gates]
depth_max_m = 50.0
depth_step_m = 2.5
)",
          {shape(optics::rayleigh(0.039)), shape(optics::raman_phase(0.17)), lambert});
}

// Light that is spread over its spectra: the equation adds up all lines, each with its own way
// home. Two walks of the laser and of the telescope in a set. Seen red: with hues that are made up
// for as if all lines of a band had as many.
TEST(FirstOrder, Spectra) {
  const auto lambert = [](double) { return 1 / (4 * pi); };
  auto instrument = ship_instrument;
  instrument.replace(instrument.find("532.0"), 5, "450.0");
  compare(instrument + channel("raman") + channel("chlorophyll") + R"(
[[channel]]
name = "filter"
centre_nm = 650.0
fwhm_nm = 30.0
filter = "gaussian"
[optics]
emission = "spectra"
[[sea.layer]]
bottom_depth_m = 6.0
iop = [ { wavelength_nm = 440.0, a_per_m = 0.09, b_per_m = 0.03, a_phytoplankton_per_m = 0.02, a_cdom_per_m = 0.04 },
        { wavelength_nm = 600.0, a_per_m = 0.25, b_per_m = 0.02 },
        { wavelength_nm = 760.0, a_per_m = 1.20, b_per_m = 0.02 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[[sea.layer]]
iop = [ { wavelength_nm = 440.0, a_per_m = 0.06, b_per_m = 0.02, a_phytoplankton_per_m = 0.01, a_cdom_per_m = 0.01 },
        { wavelength_nm = 600.0, a_per_m = 0.22, b_per_m = 0.01 },
        { wavelength_nm = 760.0, a_per_m = 1.20, b_per_m = 0.01 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[gates]
depth_max_m = 12.0
depth_step_m = 4.0
)",
          {shape(optics::raman_phase(0.17)), lambert, lambert},
          {{simulation(4e6, 7, "max_order = 1\norders_kept = 1\nreception = \"overlap\""), 0.02,
            0.03, true},
           {simulation(4e5, 7, "max_order = 1\norders_kept = 1\nwalks = 2", "bidirectional"), 0.03,
            0.05, false}});
}

// Seen red: with the optical depth of the way home straight up; with the absorption of a slanting
// way across an edge straight down, or by the coefficient of the layer it began in; with the rest
// of a free path by that layer's.
TEST(FirstOrder, Tilted30DegreesInTwoLayers) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [0.5, 0.0, -0.8660254037844386]
diameter_m = 0.04
half_divergence_mrad = 2.0
[[telescope]]
position_m = [0.0, 0.2, 12.0]
direction = [0.5, 0.0, -0.8660254037844386]
diameter_m = 0.40
focal_length_m = 2.0
half_field_of_view_mrad = 30.0
)" + channel("elastic") +
              R"(
[[sea.layer]]
bottom_depth_m = 15.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.03, b_per_m = 0.03 } ]
phase_function = { model = "henyey-greenstein", g = 0.6 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.02, b_per_m = 0.035 } ]
phase_function = { model = "henyey-greenstein", g = 0.6 }
[gates]
range_min_m = 14.0
range_max_m = 64.0
range_step_m = 2.5
)",
          {shape(optics::henyey_greenstein(0.6))});
}

// An airborne lidar with a telescope at its beam and one beside it, with gates by depth. Seen red:
// timed straight down, where the first gates are empty.
TEST(FirstOrder, DepthsOfALidarTilted20Degrees) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 300.0]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.01
half_divergence_mrad = 1.0
[[telescope]]
name = "coaxial"
position_m = [0.0, 0.0, 300.0]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.15
focal_length_m = 1.0
half_field_of_view_mrad = 5.0
[[telescope]]
name = "biaxial"
position_m = [0.3, 0.8, 300.2]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.20
focal_length_m = 1.0
half_field_of_view_mrad = 10.0
)" + channel("elastic") +
              water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") + depth_gates(40, 2),
          {shape(optics::henyey_greenstein(0.6))}, {forward_in_short, bidirectional});
}

// A beam that goes down at 45 degrees, seen from its side, from higher up at 20 degrees, and from
// straight above: what a gate is called differs by metres. Seen red: with the depths of the first
// telescope for all.
TEST(FirstOrder, DepthsOfThreeTelescopesAtOtherHeightsAndTilts) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [1.0, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 2.0
[[telescope]]
name = "coaxial"
position_m = [0.0, 0.2, 12.0]
direction = [1.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 2.0
half_field_of_view_mrad = 30.0
[[telescope]]
name = "higher, steeper"
position_m = [1.081, 0.0, 30.0]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.40
focal_length_m = 1.0
half_field_of_view_mrad = 300.0
[[telescope]]
name = "above"
position_m = [14.0, 0.0, 20.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 1.0
half_field_of_view_mrad = 450.0
)" + channel("elastic") +
              water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") + depth_gates(24, 2),
          {shape(optics::henyey_greenstein(0.6))}, {forward_in_short, bidirectional});
}

// Seen red: with the refractive index for the group index on the way out, or on the way home; with
// 1 % too much in c / c'; with the absorption across an edge by the coefficient of the layer it
// began in.
TEST(FirstOrder, Submerged) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, -5.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.02
half_divergence_mrad = 3.0
[[telescope]]
position_m = [0.15, 0.0, -5.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.20
focal_length_m = 0.5
half_field_of_view_mrad = 60.0
)" + channel("elastic") +
              R"(
[[sea.layer]]
bottom_depth_m = 12.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.03, b_per_m = 0.03 } ]
phase_function = { model = "henyey-greenstein", g = 0.3 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.05, b_per_m = 0.04 } ]
phase_function = { model = "henyey-greenstein", g = 0.3 }
[gates]
depth_min_m = 8.0
depth_max_m = 40.0
depth_step_m = 2.0
)",
          {shape(optics::henyey_greenstein(0.3))});
}

}  // namespace
}  // namespace photic::test
