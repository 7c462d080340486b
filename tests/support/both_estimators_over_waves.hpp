// What both estimators have to find over waves, alike.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "support/lidars_over_waves.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"
#include "support/z_test.hpp"

namespace photic::test {

struct OverWaves {
  const char* name;
  std::string scene;
  double forward = 1e6, bidirectional = 2e5;
  std::size_t least = 25;  ///< cells that are to be compared
  bool frees = true;       ///< with free walks
};

// Gate by gate, process by process and order by order.
inline void expect_both_estimators_find(const OverWaves& c) {
  const auto scene = [&](double photons, std::uint64_t seed, const std::string& estimator) {
    auto s = read(c.scene);
    s.simulation.photons = static_cast<std::uint64_t>(photons);
    s.simulation.seed = seed;
    s.simulation.estimator =
        estimator == "forward" ? scene::Estimator::forward : scene::Estimator::bidirectional;
    s.simulation.free_telescope_meetings = c.frees ? 0.1 : 0;
    s.simulation.free_laser_meetings = c.frees ? 0.3 : 0;
    return s;
  };
  const auto forward = run_in_lanes(scene(c.forward, 7, "forward"));
  const auto both = run_in_lanes(scene(c.bidirectional, 8, "bidirectional"));
  ZFamily family(0.01);
  const auto compare = [&](const tally::Estimates& f, const tally::Estimates& b, const char* what) {
    for (std::size_t i = 0; i < f.mean.size(); ++i) {
      const double error = std::hypot(f.standard_error[i], b.standard_error[i]);
      if (!(error < 0.05 * f.mean[i])) continue;
      family.add(b.mean[i], f.mean[i], error, fmt::format("{}, {} {}", c.name, what, i));
    }
  };
  compare(forward.echo_by_process, both.echo_by_process, "process");
  compare(forward.echo_by_order, both.echo_by_order, "order");
  std::printf("%s: %zu cells, rms z %.2f\n", c.name, family.size(), family.rms());
  EXPECT_GE(family.size(), c.least) << c.name;
  EXPECT_LT(family.rms(), 1.3) << c.name;
  family.judge();
  EXPECT_EQ(both.lost_not_finite, 0U) << c.name;
  EXPECT_NEAR(both.ledger.sum(), 1, 5 * both.ledger_standard_error + 1e-6) << c.name;
}

inline const std::string raman_water =
    "[[sea.layer]]\niop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.20 }, "
    "{ wavelength_nm = 649.0, a_per_m = 0.35, b_per_m = 0.15 } ]\n"
    "phase_function = { model = \"henyey-greenstein\", g = 0.7 }\n";

}  // namespace photic::test
