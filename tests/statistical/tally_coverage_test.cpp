// The share of cells whose standard errors hold as much as they claim. Of scenes/sun.toml, with
// more photons: experiments/tally_coverage.py.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "support/lit_scenes.hpp"
#include "support/runs.hpp"
#include "tally/result.hpp"

namespace photic::test {
namespace {

constexpr int seeds = 100;
constexpr double two_sided_95 = 1.96;

/// The runs of a scene with many seeds.
std::vector<tally::Result> runs_of(const std::string& scene, double photons) {
  std::vector<tally::Result> out;
  for (int seed = 1; seed <= seeds; ++seed)
    out.push_back(run_in_lanes(
        read(scene + simulation(photons, static_cast<std::uint64_t>(seed), "", "forward"))));
  return out;
}

// Of cells that are not flagged, and that chance has a part in, between 93 and 97 of a hundred
// intervals of 95 % cover the mean of all runs: some 20 cells of 100 runs, which are not
// independent of each other in one run. Seen red: with errors of half their size.
TEST(TallyCoverage, OfTheSun) {
  const auto runs = runs_of(sun_at(30) + tally_of("irradiance", {{0, 1, 2, 4}, {0}}) +
                                tally_of("boundaries", {}, "zenith_deg = [0, 30, 60, 90]") +
                                "[sea]\nrefractive_index = 1.34\n" +
                                layer_to(2, 0.1, 0.4, henyey_greenstein_phase) +
                                layer_to(5, 0.05, 0.2, henyey_greenstein_phase),
                            2e4);
  const double part_of_mean = std::sqrt(1 - 1.0 / seeds);  // each run is
  int intervals = 0, cover = 0;
  for (std::size_t t = 0; t < runs[0].tallies.size(); ++t)
    for (std::size_t i = 0; i < runs[0].tallies[t].mean.size(); ++i) {
      double mean = 0;
      for (const auto& r : runs) mean += r.tallies[t].mean[i] / seeds;
      for (const auto& r : runs) {
        const auto& tally = r.tallies[t];
        const double error = tally.standard_error[i];
        if (tally.flags[i] != 0 || !(error > 1e-6 * mean)) continue;
        ++intervals;
        cover += std::abs(tally.mean[i] - mean) < two_sided_95 * part_of_mean * error;
      }
    }
  const double covered = static_cast<double>(cover) / intervals;
  std::printf("%.1f %% of %d intervals cover\n", 100 * covered, intervals);
  EXPECT_GT(intervals, 1500);
  EXPECT_GT(covered, 0.93);
  EXPECT_LT(covered, 0.97);
}

}  // namespace
}  // namespace photic::test
