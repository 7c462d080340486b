// Ways of computing the same echo agree: directed sampling and the analog walk, float and double,
// any number of threads, water in one layer and cut into several.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "estimator/model.hpp"
#include "run/batches.hpp"
#include "run/run.hpp"
#include "support/agree.hpp"
#include "support/runs.hpp"
#include "support/scalar_engines.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

const std::string broad_phase = R"({ model = "henyey-greenstein", g = 0.6 })";

std::string ship(const std::string& layers, const std::string& channels, double photons,
                 const std::string& more) {
  return ship_instrument + channels + layers + depth_gates(20, 1) + simulation(photons, 5, more);
}

// On a broad phase function the plain walk converges too, to where its rare scores widen the
// reported errors. Seen red: with 1 - e left out of the mixture of a direction; with one target too
// many in the count.
TEST(Agreement, DirectedSamplingAndPlainWalk) {
  const auto layers = water(0.1, 0.2, broad_phase);
  const auto directed = run::run(
      read(ship(layers, channel("elastic"), 2e6, "directed_fraction = 0.5")), *test::tables());
  auto plain_scene = read(ship(layers, channel("elastic"), 8e6, "directed_fraction = 0.0"));
  plain_scene.simulation.seed = 6;
  compare(directed, run::run(plain_scene, *test::tables()), 14);
}

// Inelastic echoes do not depend on how often light is converted or directed, or whether it is
// directed at all. Seen red: with scattered light not divided by 1 - the probability of a
// conversion; with converted light not divided by its own; with the density of a lobe, or that of
// the phase function, from the other's table.
TEST(Agreement, ConversionProbabilityDoesNotMatter) {
  const std::string algae =
      "[[sea.layer]]\niop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1, "
      "a_phytoplankton_per_m = 0.02 }, { wavelength_nm = 700.0, a_per_m = 0.2, b_per_m = 0.1 } ]\n"
      "phase_function = " +
      broad_phase + "\n";
  const auto channels = channel("elastic") + channel("raman") + channel("chlorophyll");
  const auto often = run::run(
      read(ship(algae, channels, 2e6, "conversion_probability = 0.5\ndirected_fraction = 0.3")),
      *test::tables());
  auto rare =
      read(ship(algae, channels, 4e6, "conversion_probability = 0.1\ndirected_fraction = 0.0"));
  rare.simulation.seed = 6;
  compare(often, run::run(rare, *test::tables()), 50);
}

// Water cut into layers of the same water is the same water. Seen red: with depths instead of
// thicknesses in the optical depths of the edges; with a free path that ends at the edge it meets;
// with the rest of a free path counted from the wrong edge; with a slanting way across an edge as
// short as its depths are apart.
TEST(Agreement, OneLayerOrThree) {
  const std::string properties =
      "iop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1 } ]\nphase_function = " +
      broad_phase + "\n";
  const std::string cut = "[[sea.layer]]\nbottom_depth_m = 4.0\n" + properties +
                          "[[sea.layer]]\nbottom_depth_m = 9.5\n" + properties + "[[sea.layer]]\n" +
                          properties;
  const auto one = run::run(read(ship(water(0.06, 0.1, broad_phase), channel("elastic"), 2e6, "")),
                            *test::tables());
  auto three = read(ship(cut, channel("elastic"), 2e6, ""));
  three.simulation.seed = 6;
  const auto in_three = run::run(three, *test::tables());
  compare(one, in_three, 18);

  // Slanting ways, that the echo in a narrow view shows little of. Nearly all shares are between 0
  // and 1, so that their variance is below their mean.
  ZFamily ledger(0.01);
  const auto photons = static_cast<double>(one.photons);
  const auto add = [&](double a, double b, const std::string& what) {
    ledger.add(a, b, std::sqrt((a + b) / photons), what);
  };
  add(one.ledger.absorbed, in_three.ledger.absorbed, "absorbed");
  add(one.ledger.escaped, in_three.ledger.escaped, "escaped");
  add(one.ledger.cut_by_time, in_three.ledger.cut_by_time, "too late");
  ledger.judge();
}

// From a laser in clear water that looks up, all there is comes by way of the surface: totally
// reflected, or a fortieth of it, which plays roulette there. Both estimators, one or four points
// of flights. Seen red: with the points of flights ended at the surface; with all of the number
// that roulette was played by used again; with nobody killed by it.
TEST(Agreement, LightThatTheSurfaceTurns) {
  const std::string clear_over_turbid =
      "[[sea.layer]]\nbottom_depth_m = 3.5\niop = [ { wavelength_nm = 532.0, a_per_m = 0.05, "
      "b_per_m = 0.005 } ]\nphase_function = " +
      broad_phase +
      "\n[[sea.layer]]\niop = [ { wavelength_nm = 532.0, a_per_m = 0.1, b_per_m = 0.2 } ]\n"
      "phase_function = " +
      broad_phase + "\n";
  for (const double tangent : {0.3, 1.5}) {
    SCOPED_TRACE(tangent);
    const auto scene = [&](const std::string& estimator, double photons, std::uint64_t seed,
                           const std::string& more) {
      return read(fmt::format(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, -3.0]
direction = [{0:.2f}, 0.0, 1.0]
diameter_m = 0.04
half_divergence_mrad = 5.0
[[telescope]]
position_m = [{1:.2f}, 0.0, 10.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.4
focal_length_m = 2.0
detector_diameter_m = 1.2
[gates]
start_ns = {2:.1f}
stop_ns = {3:.1f}
step_ns = 6.0
)",
                              tangent, 9 * tangent, 64 + 20 * tangent, 64 + 20 * tangent + 48) +
                  channel("elastic") + clear_over_turbid +
                  simulation(photons, seed, more, estimator));
    };
    const auto walks = run_in_lanes(scene("bidirectional", 2e5, 7, ""));
    const auto of_one = run_in_lanes(scene("forward", 4e6, 5, "scored_points = 1"));
    const auto of_four = run_in_lanes(
        scene("forward", 2e6, 6, "scored_points = 4\n[simulation.tools]\nweight_threshold = 0.5"));
    compare(of_one, walks, 5);
    compare(of_four, walks, 5);
  }
}

template <class T>
tally::Result run_in(const scene::Scene& scene, int threads) {
  const auto model = estimator::make_model(scene, *test::tables());
  run::RunOptions options;
  options.threads = threads;
  run::RunControl control(scene.simulation, options);
  const auto simulator = scalar_engine<T>(model);
  const auto totals = run::BatchRunner(model, *simulator, control).run();
  auto result = estimator::describe(model);
  totals.fill(result);
  return result;
}

// The same histories but for rounding: closer than their own errors by far. A phase function with
// a peak, for which a small angle must keep its digits. Seen red in float: with 1 - cos as one less
// a product; with a logarithm without its series; with uniforms of 15 bits.
TEST(Agreement, FloatAndDouble) {
  const auto scene = read(ship(water(0.06, 0.1, peaked_phase), channel("elastic"), 4e5, ""));
  const auto in_double = run_in<double>(scene, 2);
  const auto in_float = run_in<float>(scene, 2);
  for (std::size_t g = 0; g < in_double.gates(); ++g) {
    EXPECT_NEAR(in_float.echo.mean[g], in_double.echo.mean[g],
                0.03 * in_double.echo.standard_error[g])
        << "gate " << g;
  }
  EXPECT_NEAR(in_float.ledger.escaped, in_double.ledger.escaped, 1e-5 * in_double.ledger.escaped);
  EXPECT_NE(in_float.echo.mean,
            in_double.echo.mean);  // or the comparison would be of one with itself
}

// The tests' scalar engine is compiled for any processor of its kind, the program's for this one,
// too. Seen red: with products and sums contracted in the program's.
TEST(Agreement, BitsDoNotDependOnInstructions) {
  const std::string algae =
      "[[sea.layer]]\nbottom_depth_m = 5.0\nchlorophyll_mg_m3 = 1.0\n[[sea.layer]]\n";
  auto scene =
      read(ship(algae, channel("elastic") + channel("raman"), 2e4, "directed_fraction = 0.5"));
  for (const auto estimator : {scene::Estimator::forward, scene::Estimator::bidirectional}) {
    scene.simulation.estimator = estimator;
    const auto here = run::run(scene, *test::tables());
    const auto anywhere = run_in<double>(scene, 2);
    EXPECT_GT(here.echo.mean.front(), 0);
    EXPECT_EQ(here.echo.mean, anywhere.echo.mean);
    EXPECT_EQ(here.grid("echo_by_order").standard_error,
              anywhere.grid("echo_by_order").standard_error);
    EXPECT_EQ(here.ledger.absorbed, anywhere.ledger.absorbed);
  }
}

// Seen red: with batches merged as they come; with any of a tally's ledger, depths, largest scores
// or octaves left as they were from one batch to the next.
TEST(Agreement, BitsDoNotDependOnThreads) {
  const std::string algae =
      "[[sea.layer]]\nbottom_depth_m = 5.0\nchlorophyll_mg_m3 = 1.0\n[[sea.layer]]\n";
  const auto scene = read(ship(algae, channel("elastic") + channel("raman"), 123'456, ""));
  const auto one = run_in<double>(scene, 1);
  for (const int threads : {2, 7}) {
    const auto other = run_in<double>(scene, threads);
    EXPECT_EQ(one.photons, other.photons);
    EXPECT_EQ(one.echo.mean, other.echo.mean);
    EXPECT_EQ(one.echo.standard_error, other.echo.standard_error);
    EXPECT_EQ(one.grid("echo_by_order").standard_error, other.grid("echo_by_order").standard_error);
    EXPECT_EQ(one.grid("echo_by_depth").mean, other.grid("echo_by_depth").mean);
    EXPECT_EQ(one.convergence_flags, other.convergence_flags);
    EXPECT_EQ(one.ledger.absorbed, other.ledger.absorbed);
  }
}

// A lidar that looks up from below sees what is mirrored in the surface. Close to the telescope
// scores have no bound: later gates, and those of plain walks, hold more of that than their errors
// cover. Seen red: with 1 - e left out of the mixture of a direction; with the density of the first
// target alone; with one target too many in the count.
TEST(Agreement, LookingUpDirectedMoreAndLess) {
  const auto rov = [](const std::string& more, std::uint64_t seed, double photons) {
    return read(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, -6.0]
direction = [0.3, 0.0, 1.0]
diameter_m = 0.02
half_divergence_mrad = 5.0
[[telescope]]
position_m = [0.2, 0.0, -6.0]
direction = [0.3, 0.0, 1.0]
diameter_m = 0.10
focal_length_m = 0.3
half_field_of_view_mrad = 150.0
)" + channel("elastic") +
                water(0.1, 0.05, broad_phase) +
                "[gates]\nrange_min_m = 1.0\nrange_max_m = 7.0\nrange_step_m = 1.0\n" +
                simulation(photons, seed, more));
  };
  compare(run::run(rov("directed_fraction = 0.5", 5, 4e6), *test::tables()),
          run::run(rov("directed_fraction = 0.1", 6, 6e6), *test::tables()), 6);
}

}  // namespace
}  // namespace photic::test
