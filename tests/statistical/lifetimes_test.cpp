// Echoes of emitters that decay are those of emitters that do not, convolved with the decay: of the
// same photons, so that nothing is left to chance.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <span>
#include <vector>

#include "core/isa.hpp"
#include "run/run.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::test {
namespace {

constexpr double stop_ns = 120, step_ns = 0.05;  // the surface is at 80 ns
constexpr double chlorophyll_ns = 5, cdom_ns = 9;

/// Channel 0 elastic, 1 chlorophyll's, 2 CDOM's; with an environment of other water.
scene::Scene lidar(const std::string& estimator, double start_ns, double gate_ns, bool decays) {
  // The same walks whatever the gates, which pilot runs would look at.
  const std::string free_walks =
      estimator == "forward" ? "" : "free_telescope_meetings = 0.1\nfree_laser_meetings = 0.3";
  std::string optics = "[optics]\n";
  if (decays)
    optics += fmt::format("chlorophyll_lifetime_ns = {}\ncdom_lifetime_ns = {}\n", chlorophyll_ns,
                          cdom_ns);
  return read(ship_instrument + channel("elastic") + channel("chlorophyll") + channel("cdom") +
              optics + "[[sea.layer]]\nchlorophyll_mg_m3 = 1\ncdom_a440_per_m = 0.1\n" +
              fmt::format("[gates]\nstart_ns = {}\nstop_ns = {}\nstep_ns = {}\n", start_ns, stop_ns,
                          gate_ns) +
              simulation(estimator == "forward" ? 200'000 : 4000, 3, free_walks, estimator) +
              "[[environment]]\nset = { \"sea.layer.0.chlorophyll_mg_m3\" = 2 }\n");
}

tally::Result run_in(std::optional<Isa> lanes, const scene::Scene& scene) {
  run::RunOptions options;
  options.lanes = lanes;
  return run::run(scene, *test::tables(), options);
}

/// The share that has left the emitter after a time.
double left(double lifetime_ns, double ns) { return ns > 0 ? -std::expm1(-ns / lifetime_ns) : 0; }

/// A channel's fine echo at once, as coarse gates see it once it decays.
std::vector<double> convolved(const tally::Result& fine, std::span<const double> echo,
                              const tally::Result& coarse, std::size_t channel,
                              double lifetime_ns) {
  std::vector<double> out(coarse.gates());
  for (std::size_t f = 0; f < fine.gates(); ++f) {
    const double middle = (fine.gate_time_edge_ns[f] + fine.gate_time_edge_ns[f + 1]) / 2;
    for (std::size_t g = 0; g < out.size(); ++g)
      out[g] += echo[channel * fine.gates() + f] *
                (left(lifetime_ns, coarse.gate_time_edge_ns[g + 1] - middle) -
                 left(lifetime_ns, coarse.gate_time_edge_ns[g] - middle));
  }
  return out;
}

void expect_alike(std::span<const double> all, std::size_t channel,
                  std::span<const double> expected) {
  for (std::size_t g = 0; g < expected.size(); ++g) {
    SCOPED_TRACE(fmt::format("channel {}, gate {}", channel, g));
    EXPECT_GT(expected[g], 0);
    EXPECT_NEAR(all[channel * expected.size() + g] / expected[g], 1, 1e-3);
  }
}

/// Estimator, lanes or not, and where the gates begin: at 100 ns much has come before.
struct Case {
  const char* estimator;
  bool lanes;
  double start_ns;
  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << fmt::format("{} {} from {} ns", c.estimator, c.lanes ? "lanes" : "scalar",
                              c.start_ns);
  }
};

// That scores are not where a fine gate has its middle is what is left of the difference: it fell
// with the square root of the scores. Seen red: with exp(+t/tau); with tau in metres; without what
// comes before the first gate; with the decays of chlorophyll and CDOM for each other's.
class Lifetimes : public testing::TestWithParam<Case> {};

TEST_P(Lifetimes, AreAConvolution) {
  const auto& [estimator, in_lanes, start_ns] = GetParam();
  const auto lanes = in_lanes ? std::optional(isa_of_tests()) : std::nullopt;
  const auto fine = run_in(lanes, lidar(estimator, 80, step_ns, false));
  const auto coarse = run_in(lanes, lidar(estimator, start_ns, 2, true));
  const auto at_once = run_in(lanes, lidar(estimator, start_ns, 2, false));
  for (std::size_t g = 0; g < coarse.gates(); ++g)
    EXPECT_EQ(coarse.echo.mean[g], at_once.echo.mean[g]);
  for (const auto& [channel, lifetime] : {std::pair(1, chlorophyll_ns), {2, cdom_ns}}) {
    expect_alike(coarse.echo.mean, channel,
                 convolved(fine, fine.echo.mean, coarse, channel, lifetime));
    expect_alike(coarse.environment_echo.mean, channel,
                 convolved(fine, fine.environment_echo.mean, coarse, channel, lifetime));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Lifetimes,
                         testing::Values(Case{"forward", false, 80}, Case{"forward", true, 100},
                                         Case{"bidirectional", false, 100},
                                         Case{"bidirectional", true, 80}));

}  // namespace
}  // namespace photic::test
