// Which of several short runs is the best one, those among them that saw nothing.
#include "run/pilots.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace photic::run {
namespace {

constexpr std::optional<double> nothing;

/// Of one channel, seen unless all gates saw nothing.
Pilot pilot(double cost, const std::vector<std::optional<double>>& squared_error,
            std::size_t rows_seen = 1) {
  return {cost, squared_error, rows_seen};
}

constexpr double known_to = 1;

std::optional<std::size_t> best_of(const std::vector<Pilot>& pilots, Aim aim) {
  return best_of(pilots, gates_compared(pilots, known_to), aim);
}

// A cost ten times as high for an error a hundred times as small.
TEST(Pilots, AreComparedAtEqualCost) {
  for (const Aim aim : {Aim::all_gates, Aim::worst_gates}) {
    EXPECT_EQ(best_of({pilot(100, {1e-2}), pilot(1000, {1e-4})}, aim), 1U);
    EXPECT_EQ(best_of({pilot(100, {1e-2}), pilot(100000, {1e-4})}, aim), 0U);
  }
}

// Pilots know the work badly: of those alike the one that took less. Seen red: with the least work
// alone; with the cheaper one whatever its work; with one that is hardly cheaper.
TEST(Pilots, ThatAreAlikeAreJudgedByTheirCost) {
  for (const Aim aim : {Aim::all_gates, Aim::worst_gates}) {
    EXPECT_EQ(best_of({pilot(200, {1.00e-4}), pilot(100, {2.3e-4})}, aim), 1U);
    EXPECT_EQ(best_of({pilot(200, {1.00e-4}), pilot(100, {2.5e-4})}, aim), 0U);
    EXPECT_EQ(best_of({pilot(105, {1.00e-4}), pilot(100, {1.08e-4})}, aim), 1U);
    EXPECT_EQ(best_of({pilot(105, {1.00e-4}), pilot(100, {1.14e-4})}, aim), 0U);
  }
}

// Better in nine gates of ten, or in the one that a run to a target waits for. Seen red: with the
// mean over all gates for both.
TEST(Pilots, AreComparedByTheWorstGatesIfThereIsATarget) {
  std::vector<std::optional<double>> mostly(10, 1e-5), evenly(10, 1e-4);
  mostly[7] = 1e-2;
  EXPECT_EQ(best_of({pilot(1, mostly), pilot(1, evenly)}, Aim::all_gates), 0U);
  EXPECT_EQ(best_of({pilot(1, mostly), pilot(1, evenly)}, Aim::worst_gates), 1U);
}

// A gate that one of them is blind in counts against it, although it is better in all others: it
// would never meet the target there. Seen red: with such gates left out.
TEST(Pilots, AreJudgedByGatesThatOnlyOthersSee) {
  const std::vector<Pilot> two{pilot(1, {1e-6, 1e-6, nothing}), pilot(1, {1e-4, 1e-4, 1e-2})};
  EXPECT_EQ(best_of(two, Aim::worst_gates), 1U);
}

// Gates that no pilot knows anything of are left to luck, and decide only where there are no
// others. Seen red: with all gates that any of them saw.
TEST(Pilots, AreNotJudgedByGatesThatNoneKnows) {
  const std::vector<Pilot> two{pilot(1, {1e-4, 19.0, nothing}), pilot(1, {1e-2, 2.0, nothing})};
  EXPECT_EQ(gates_compared(two, known_to), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(best_of(two, Aim::worst_gates), 0U);
  const std::vector<Pilot> dim{pilot(1, {19.0, nothing}), pilot(1, {2.0, nothing})};
  EXPECT_EQ(gates_compared(dim, known_to), (std::vector<bool>{true, false}));
  EXPECT_EQ(best_of(dim, Aim::worst_gates), 1U);
}

// However cheap it was to see nothing. Seen red: by badness alone, with 1
// for the squared error of a gate without a score, which a gate with a single one exceeds.
TEST(Pilots, ThatSawNothingNeverWin) {
  for (const Aim aim : {Aim::all_gates, Aim::worst_gates}) {
    EXPECT_EQ(best_of({pilot(1, {nothing, nothing}, 0), pilot(1e9, {20.0, nothing})}, aim), 1U);
    EXPECT_EQ(best_of({pilot(1e9, {20.0, nothing}), pilot(1, {nothing, nothing}, 0)}, aim), 0U);
    EXPECT_EQ(best_of({pilot(1, {1e-4, nothing}, 1), pilot(1e9, {1e-4, 0.1}, 2)}, aim), 1U);
    EXPECT_EQ(best_of({pilot(1, {1e-4, nothing}), pilot(1.1, {1e-4, 0.9})}, aim), 1U);
    EXPECT_EQ(best_of({pilot(1, {nothing}, 0), pilot(2, {nothing}, 0)}, aim), std::nullopt);
  }
}

/// Two telescopes of one channel and two gates.
tally::Result result_of(const std::vector<double>& echo, const std::vector<double>& error,
                        const std::vector<double>& largest_share) {
  tally::Result result;
  result.telescope_name = {"a", "b"};
  result.channel_name = {"c"};
  result.gate_time_edge_ns = {0, 1, 2};
  result.echo.mean.assign(echo.begin(), echo.end());
  result.echo.standard_error.assign(error.begin(), error.end());
  result.largest_score_share = largest_share;
  return result;
}

// By channel of a telescope, and with the weight of large scores.
TEST(Pilots, KnowWhereTheySawLight) {
  const Pilot both =
      pilot_of(result_of({0, 2, 4, 4}, {0, 0.2, 0.4, 0}, {0, 1e-3, 0.1, 0}), 7, 0.05);
  EXPECT_EQ(both.cost, 7);
  EXPECT_EQ(both.rows_seen, 2U);
  EXPECT_EQ(both.squared_error[0], std::nullopt);
  EXPECT_NEAR(both.squared_error[1].value(), 0.01, 1e-15);
  EXPECT_NEAR(both.squared_error[2].value(), 0.2, 1e-15);  // 0.01, of which one score has all
  EXPECT_GT(both.squared_error[3].value(), 0);             // for its logarithm
  EXPECT_EQ(pilot_of(result_of({1, 1, 0, 0}, {1, 1, 0, 0}, {1, 1, 0, 0}), 1, 0.05).rows_seen, 1U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      pilot_of(result_of({1, 1, 0, 0}, {nan, nan, nan, nan}, {1, 1, 0, 0}), 1, 0.05).rows_seen, 0U);
  EXPECT_EQ(gates_compared({both, pilot(1, {1.0, nothing, nothing, nothing})}, known_to),
            std::vector<bool>(4, true));
}

}  // namespace
}  // namespace photic::run
