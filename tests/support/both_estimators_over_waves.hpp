// What both estimators have to find over waves, alike.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/lidars_over_waves.hpp"
#include "support/runs.hpp"
#include "support/same_light.hpp"
#include "support/scenes.hpp"

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
  expect_same_light(forward, both, c.name, 0.05, c.least);
  EXPECT_EQ(both.lost_not_finite, 0U) << c.name;
  EXPECT_NEAR(both.ledger.sum(), 1, 5 * both.ledger_standard_error + 1e-6) << c.name;
}

inline const std::string raman_water =
    "[[sea.layer]]\niop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.20 }, "
    "{ wavelength_nm = 649.0, a_per_m = 0.35, b_per_m = 0.15 } ]\n"
    "phase_function = { model = \"henyey-greenstein\", g = 0.7 }\n";

}  // namespace photic::test
