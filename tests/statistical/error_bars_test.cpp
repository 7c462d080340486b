// Error bars are features with tests of their own: over many seeds, 95 % intervals of the gates
// that are flagged as converged cover a converged reference about 95 % of the time.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

constexpr int seeds = 40;
constexpr double photons = 4e5;
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
// at all; without the flag of a heavy tail.
TEST(ErrorBars, HoldOnHenyeyGreensteinWaterTo20m) { check(henyey_greenstein_phase, 20); }
// Seen red: with errors 1.2 or 1.5 times too small; with errors 1.3 times too large; with no flags
// at all.
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

/// A scene of the tree that ends in [simulation], with that of a run of its own.
std::string scene_of_tree(const std::string& path, const std::string& run) {
  std::ifstream file(std::string(PHOTIC_SOURCE_DIR "/") + path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return text.substr(0, text.rfind("[simulation]")) + run;
}

/// Of many runs, whose mean is the truth.
struct Spread {
  double unflagged = 0;  ///< share of all gates
  double covered = 0;    ///< of 95 % intervals of these
  double rms = 0;        ///< of their errors, over those that are claimed
};
Spread spread(const std::string& path, double count, int runs, const std::string& estimator) {
  std::vector<tally::Result> results;
  for (int seed = 1; seed <= runs; ++seed) {
    const auto run = simulation(count, static_cast<std::uint64_t>(seed),
                                estimator == "bidirectional" ? no_free_walks : "", estimator);
    results.push_back(run_in_lanes(read(scene_of_tree(path, run))));
  }
  double cells = 0, known = 0, covered = 0, squares = 0;
  for (std::size_t cell = 0; cell < results[0].convergence_flags.size(); ++cell) {
    double truth = 0;
    for (const auto& result : results) truth += result.echo.mean[cell] / runs;
    for (const auto& result : results) {
      cells += 1;
      if (result.convergence_flags[cell] != 0) continue;
      const double z = (result.echo.mean[cell] - truth) / std::sqrt(1 - 1.0 / runs) /
                       result.echo.standard_error[cell];
      known += 1;
      covered += std::abs(z) < 1.96;
      squares += z * z;
    }
  }
  std::printf("%s: %.3f of %.0f gates are not flagged, %.3f covered, rms %.3f\n", path.c_str(),
              known / cells, cells, covered / known, std::sqrt(squares / known));
  return {known / cells, covered / known, std::sqrt(squares / known)};
}

// Where scores fall off so slowly that their variance is infinite: errors hold what has not been
// seen, rather than gates being flagged. Coverages scatter by 0.008 and 0.016 (one sigma, from seed
// to seed); what is asked for is two and more of these below what 40 and 100 seeds gave.
TEST(ErrorBars, HoldOfALidarInTheWater) {
  const Spread s = spread("experiments/hard-submerged.toml", 5e5, 40, "forward");
  EXPECT_GT(s.unflagged, 0.4);
  EXPECT_GT(s.covered, 0.917);
  EXPECT_LT(s.covered, 0.98);
  EXPECT_LT(s.rms, 1.1);
}
/// 100 seeds gave 0.918, 0.964 and 0.91.
TEST(ErrorBars, HoldAcrossTheFrontOfAPlume) {
  const Spread s = spread("scenes/plume.toml", 2e5, 20, "forward");
  EXPECT_GT(s.unflagged, 0.85);
  EXPECT_GT(s.covered, 0.91);
  EXPECT_LT(s.rms, 1.1);
}
TEST(ErrorBars, HoldInTurbidLayersUnderATiltedTelescope) {
  const Spread s = spread("experiments/hard-turbid.toml", 1.2e5, 6, "bidirectional");
  EXPECT_GT(s.unflagged, 0.9);
  EXPECT_GT(s.covered, 0.90);
  EXPECT_LT(s.covered, 0.98);
  EXPECT_LT(s.rms, 1.18);
}

}  // namespace
}  // namespace photic::test
