// Error bars are features with tests of their own: over many seeds, 95 % intervals of the gates
// that are flagged as converged cover a converged reference about 95 % of the time.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

constexpr int seeds = 40;
constexpr double photons = 1e6;
constexpr double reference_photons = 25 * photons;  // its own error is in the intervals
constexpr double gate_step = 0.5;

std::string scene(const std::string& phase, double count, std::uint64_t seed) {
  return ship_instrument + channel("elastic") + water(0.06, 0.10, phase) +
         depth_gates(50, gate_step) + simulation(count, seed, "reception = \"overlap\"");
}

struct Coverage {
  double covered = 0, flagged_converged = 0;
  [[nodiscard]] double share() const { return covered / flagged_converged; }
};

/// Of the gates above a depth and of those below it, where the reference is converged.
struct Coverages {
  Coverage above, below;
};
Coverages coverages(const std::string& phase, const tally::Result& reference, std::size_t depth) {
  constexpr double two_sided_95 = 1.96;
  Coverages out;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto run =
        run_in_lanes(read(scene(phase, photons, static_cast<std::uint64_t>(1000 + seed))));
    for (std::size_t g = 0; g < run.gates(); ++g) {
      if (run.convergence_flags[g] != 0 || reference.convergence_flags[g] != 0) continue;
      Coverage& c = g < depth ? out.above : out.below;
      const double error = std::hypot(run.echo.standard_error[g], reference.echo.standard_error[g]);
      c.flagged_converged += 1;
      c.covered += std::abs(run.echo.mean[g] - reference.echo.mean[g]) < two_sided_95 * error;
    }
  }
  return out;
}

void check(const std::string& phase, double depth) {
  const auto reference = run_in_lanes(read(scene(phase, reference_photons, 7)));
  const auto gates = static_cast<std::size_t>(depth / gate_step);
  std::size_t converged = 0;
  for (std::size_t g = 0; g < gates; ++g) converged += reference.convergence_flags[g] == 0;
  EXPECT_GE(static_cast<double>(converged), 0.8 * static_cast<double>(gates)) << "flags are timid";

  const auto [shallow, deep] = coverages(phase, reference, gates);
  std::printf(
      "converged %zu of %zu gates in the reference; covered %.3f of %.0f above, %.3f of %.0f below "
      "%g m\n",
      converged, gates, shallow.share(), shallow.flagged_converged, deep.share(),
      deep.flagged_converged, depth);
  EXPECT_GE(shallow.flagged_converged, 0.8 * seeds * static_cast<double>(gates))
      << "flags are timid";
  EXPECT_GT(shallow.share(), 0.91);
  EXPECT_LT(shallow.share(), 0.99);
  // Deeper gates may be flagged as not converged, but not be wrong without a flag.
  if (deep.flagged_converged > 50) {
    EXPECT_GT(deep.share(), 0.88);
  }
}

// Seen red: with errors 1.2 or 1.5 times too small; with errors 1.5 times too large; with no flags
// at all; without the flag of a heavy tail; with a largest score of 0.05 % enough for a flag.
TEST(ErrorBars, HoldOnHenyeyGreensteinWaterTo20m) { check(henyey_greenstein_phase, 20); }
// Seen red: with errors 1.2 or 1.5 times too small; with errors 1.3 times too large; with no flags
// at all; with a largest score of 0.05 % enough for a flag.
TEST(ErrorBars, HoldOnPeakedWaterTo10m) { check(peaked_phase, 10); }

// A plain walk on peaked water, whose deep gates live on scores that it has hardly seen, says so.
TEST(ErrorBars, OfANaiveRunAreFlaggedBelow10m) {
  const auto run =
      run_in_lanes(read(ship_instrument + channel("elastic") + water(0.06, 0.10, peaked_phase) +
                        depth_gates(50, gate_step) +
                        simulation(2e7, 1, "directed_fraction = 0.0\nreception = \"overlap\"")));
  for (std::size_t g = static_cast<std::size_t>(10 / gate_step); g < run.gates(); ++g)
    EXPECT_NE(run.convergence_flags[g], 0) << "gate " << g;
}

}  // namespace
}  // namespace photic::test
