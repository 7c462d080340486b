// Echoes of one scene, computed in two ways.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/z_test.hpp"
#include "tally/result.hpp"

namespace photic::test {

/// Gates of both results with errors below a limit, against each other; at least `least` of them.
/// Plain walks are seldom flagged as converged, and their rare large scores widen the errors as
/// well: only z-scores are judged, not their spread.
inline void compare(const tally::Result& a, const tally::Result& b, std::size_t least,
                    double small_error = 0.05) {
  ZFamily family(0.01);
  for (std::size_t i = 0; i < a.echo.mean.size(); ++i) {
    const double error = std::hypot(a.echo.standard_error[i], b.echo.standard_error[i]);
    if (!(error < small_error * a.echo.mean[i])) continue;
    family.add(a.echo.mean[i], b.echo.mean[i], error, fmt::format("cell {}", i));
  }
  EXPECT_GE(family.size(), least);
  family.judge();
}

}  // namespace photic::test
