// Echoes of one scene, computed in two ways.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/z_test.hpp"
#include "tally/result.hpp"

namespace photic::test {

/// Adds the gates of both results that have errors below 5 % to a family, against each other.
/// Plain walks are seldom flagged as converged, and their rare large scores widen the errors as
/// well: only z-scores can be judged, not their spread. Returns their number.
inline std::size_t add_settled(ZFamily& family, const tally::Result& a, const tally::Result& b,
                               const std::string& what = "") {
  constexpr double small_error = 0.05;
  std::size_t settled = 0;
  for (std::size_t i = 0; i < a.echo.mean.size(); ++i) {
    const double error = std::hypot(a.echo.standard_error[i], b.echo.standard_error[i]);
    if (!(error < small_error * a.echo.mean[i])) continue;
    family.add(a.echo.mean[i], b.echo.mean[i], error, fmt::format("{} cell {}", what, i));
    ++settled;
  }
  return settled;
}

/// Judges them at 1 %; there must be at least `least`.
inline void compare(const tally::Result& a, const tally::Result& b, std::size_t least) {
  ZFamily family(0.01);
  EXPECT_GE(add_settled(family, a, b), least);
  family.judge();
}

}  // namespace photic::test
