// Environments, and derivatives, of one run against runs of their own.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "support/runs.hpp"
#include "support/z_test.hpp"

namespace photic::test {

/// Of a gate, in an environment and in its own run, where both are known well.
inline void compare_environment(const tally::Result& all, std::size_t e, const tally::Result& own,
                                ZFamily& family, const std::string& what) {
  const std::size_t cells = own.echo.mean.size();
  for (std::size_t i = 0; i < cells; ++i) {
    const double other = all.environment_echo.standard_error[e * cells + i];
    const double error = std::hypot(other, own.echo.standard_error[i]);
    const bool known =
        own.convergence_flags[i] == 0 && all.environment_convergence_flags[e * cells + i] == 0;
    if (!known || !(error < 0.1 * own.echo.mean[i])) continue;
    family.add(all.environment_echo.mean[e * cells + i], own.echo.mean[i], error,
               fmt::format("{} cell {}", what, i));
  }
}

/// The derivative by parameter p is what two environments of the same run, in which it is more and
/// less by `step`, differ by: numbers first_environment and the one behind it.
inline void expect_derivative_by_steps(const tally::Result& r, std::size_t p,
                                       std::size_t first_environment, double step,
                                       const std::string& what) {
  const std::size_t cells = r.echo.mean.size();
  const double* more = &r.environment_echo.mean[first_environment * cells];
  for (std::size_t i = 0; i < cells; ++i) {
    if (r.echo.mean[i] == 0) continue;
    const double by_steps = (more[i] - more[cells + i]) / (2 * step);
    EXPECT_NEAR(r.sensitivity.mean[p * cells + i], by_steps, 1e-3 * std::abs(by_steps))
        << what << " " << i;
  }
}

}  // namespace photic::test
