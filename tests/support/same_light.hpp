// Two results of the same light, process by process and order by order.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "run/run.hpp"
#include "support/z_test.hpp"

namespace photic::test {

/// The share of cells by process and by order that are independent: both hold the same light. Over
/// 30 seeds of six scenes under air it was 0.39 to 0.56, from how much rms z varies.
inline constexpr double independent_share = 0.5;

/// Cells are compared whose common error is below a share of what they hold, so many at least.
/// False alarms: one in a hundred such pairs of results, by the largest z and by rms z each.
inline void expect_same_light(const tally::Result& one, const tally::Result& other,
                              const std::string& name, double share, std::size_t least) {
  ZFamily family(0.01);
  const auto compare = [&](const tally::Estimates& a, const tally::Estimates& b, const char* what) {
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
      const double error = std::hypot(a.standard_error[i], b.standard_error[i]);
      if (!(error < share * a.mean[i])) continue;
      family.add(b.mean[i], a.mean[i], error, fmt::format("{}, {} {}", name, what, i));
    }
  };
  compare(one.grid("echo_by_process"), other.grid("echo_by_process"), "process");
  compare(one.grid("echo_by_order"), other.grid("echo_by_order"), "order");
  std::printf("%s: %zu cells, rms z %.2f\n", name.c_str(), family.size(), family.rms());
  EXPECT_GE(family.size(), least) << name;
  SCOPED_TRACE(name);
  family.judge();
  family.judge_scatter(independent_share);
}

}  // namespace photic::test
