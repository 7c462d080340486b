// Light of emitters that decay: what each gate gets of a score.
#include "tally/decay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "core/constants.hpp"
#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

double total_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// By gate, as often as each is named.
std::array<double, 4> shares_of(double lifetime_ns, const Gates& gates, double path) {
  std::vector<GateShare> shares;
  Decay(lifetime_ns, gates).spread(path, gates, shares);
  std::array<double, 4> out{};
  for (const auto& [gate, share] : shares) out.at(static_cast<std::size_t>(gate)) += share;
  return out;
}

/// What has left after a path.
double left_after(double lifetime_ns, double path) {
  return path > 0 ? 1 - std::exp(-path / (lifetime_ns * metre_per_nanosecond)) : 0.0;
}

// Four gates of about 45 ns. Before, in and between them. Seen red: with the lifetime in
// microseconds; with exp(+t/tau); without what comes after the first gate.
TEST(Decay, IsTheDifferenceOfTwoExponentials) {
  const Tallies t;
  const auto edge = [&](std::int32_t i) { return t.gates.edge_path(i); };
  for (const double lifetime : {0.3, 4.0, 60.0, 1e4}) {
    for (const double path : {edge(0) - 3, t.path_in(0), edge(1), edge(3) - 0.01, t.path_in(3)}) {
      SCOPED_TRACE(testing::Message() << lifetime << " ns, " << path << " m");
      const auto shares = shares_of(lifetime, t.gates, path);
      for (std::int32_t g = 0; g < 4; ++g)
        EXPECT_NEAR(shares.at(static_cast<std::size_t>(g)),
                    left_after(lifetime, edge(g + 1) - path) - left_after(lifetime, edge(g) - path),
                    1e-15);
    }
  }
}

TEST(Decay, SharesSumToOneWhereItEndsWithinTheGates) {
  const Tallies t;
  for (const double lifetime : {1e-9, 0.3, 1.0, 2.0}) {
    const auto shares = shares_of(lifetime, t.gates, t.gates.edge_path(0));
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-15) << lifetime;
  }
}

TEST(Decay, NothingComesBeforeItsTimeOrAfterTheGates) {
  const Tallies t;
  EXPECT_EQ(shares_of(5, t.gates, t.gates.last_path()), (std::array<double, 4>{}));
  EXPECT_EQ(shares_of(5, t.gates, t.path_in(2))[1], 0);
  EXPECT_EQ(shares_of(1, t.gates, t.gates.edge_path(0) - 100), (std::array<double, 4>{}));
}

// Gates find their ends but for rounding: what is a hair before the last one has not come before
// the first one. Seen red: with all that is in no gate and before the end taken for what came
// before.
TEST(Decay, RoundingTakesNothingFromTheEndToTheBeginning) {
  for (double depth = 10; depth < 40; depth += 0.37) {
    auto scene = Tallies::scene();
    scene.gates.depth_m = {0.1, depth, depth / 4.1};
    const Gates gates(scene, lines());
    std::vector<GateShare> shares;
    for (double path = gates.last_path(); path > gates.last_path() - 1e-13;
         path = std::nextafter(path, 0)) {
      Decay(5, gates).spread(path, gates, shares);
      for (const auto& [gate, share] : shares) EXPECT_EQ(gate, gates.count() - 1) << depth;
    }
    Decay(5, gates).spread(gates.edge_path(0), gates, shares);
    ASSERT_FALSE(shares.empty());
    EXPECT_EQ(shares.front().gate, 0);
  }
}

TEST(Decay, MayBeAtOnce) {
  const Tallies t;
  EXPECT_TRUE(Decay().at_once());
  EXPECT_TRUE(Decay(0, t.gates).at_once());
  EXPECT_TRUE(Decay(1e-310, t.gates).at_once());
  EXPECT_FALSE(Decay(1e-300, t.gates).at_once());
}

/// Line 2, chlorophyll's, decays in 60 ns; the others are emitted at once.
struct DecayingTallies : Tallies {
  explicit DecayingTallies(std::int32_t max_order = 0, std::size_t environments = 0)
      : Tallies(max_order, environments) {
    shape.decay_of_line = {Decay(), Decay(0, gates), Decay(60, gates)};
    batch = BatchTally(shape, gates);
  }
};

// Every tally of a cell. Seen red: with the whole score in by_process; with the largest score not
// shared.
TEST(BatchTally, SpreadsWhatDecays) {
  DecayingTallies t;
  t.score(0, 0.25, 1, 1);
  t.score(1, 0.5, 2, 2);
  const auto shares = shares_of(60, t.gates, t.path_in(1));
  EXPECT_GT(shares[3], 0.1);
  for (std::size_t g = 0; g < 4; ++g) {
    SCOPED_TRACE(g);
    const std::size_t cell = 2 * 4 + g;
    const double expected = 0.5 * shares.at(g);
    EXPECT_EQ(t.sums("echo_by_order")[cell * 4 + 2], expected);
    EXPECT_EQ(t.sums("echo_by_process")[cell * 3 + 2], expected);
    EXPECT_EQ(t.sums("echo_by_depth")[cell * 4 + 1], expected);
    EXPECT_EQ(t.batch.cells[cell].largest, std::max(expected, g == 0 ? 0.25 : 0.0));
    EXPECT_EQ(t.sums("echo_by_process")[(1 * 4 + g) * 3 + 1], g == 0 ? 0.25 : 0);
  }
  EXPECT_EQ(t.batch.scores, 2U);
  t.batch.clear();
  for (const char* table : {"echo_by_order", "echo_by_process", "echo_by_depth"})
    EXPECT_EQ(total_of(t.sums(table)), 0);
}

// As of light that comes as its gate ends, but for rounding. What comes next counts once. Seen red:
// with a share of 0 taken for a score.
TEST(BatchTally, SharesOfNothingAreNoScores) {
  DecayingTallies t;
  t.batch.score({0, 2, 1, 2, t.path_in(1), 5e-324});  // each of its shares is rounded to 0
  t.score(1, 0.5, 1, 2);
  std::vector<std::uint32_t> cells = t.batch.touched_cells[2];
  std::ranges::sort(cells);
  EXPECT_EQ(std::ranges::adjacent_find(cells), cells.end());
}

// Seen red: with what comes before the first gate dropped.
TEST(BatchTally, KeepsTheTailOfWhatCameBeforeTheGates) {
  DecayingTallies t;
  const double before = t.gates.edge_path(0) - 60 * metre_per_nanosecond;
  t.batch.score({0, 2, 1, 2, before, 1.0});
  t.batch.score({0, 0, 1, 2, before, 1.0});
  const double until_end = (t.gates.last_path() - before) / (60 * metre_per_nanosecond);
  EXPECT_NEAR(total_of(t.sums("echo_by_order")), std::exp(-1) - std::exp(-until_end), 1e-15);
}

// Seen red: with the first gate alone.
TEST(BatchTally, SpreadsWhatDecaysInEnvironments) {
  DecayingTallies t(0, 2);
  std::array<double, EnvironmentScores::size> ratios{};
  ratios[0] = 2;
  ratios[1] = 0.5;
  const Score score{0, 2, 1, 7, t.path_in(1), 0.5};
  t.batch.score(score, t.batch.bins(score.path, score.depth), ratios.data());
  const auto shares = shares_of(60, t.gates, t.path_in(1));
  for (std::size_t g = 0; g < 4; ++g) {
    EXPECT_EQ(t.batch.environment[2 * 4 + g].echo[0], shares.at(g));
    EXPECT_EQ(t.batch.environment[2 * 4 + g].difference[1], -0.25 * shares.at(g));
  }
}

TEST(BatchTally, BooksWhatMaxOrderCutsOffInAllItsGates) {
  DecayingTallies t(2);
  t.score(1, 0.5, 3, 2);
  const auto shares = shares_of(60, t.gates, t.path_in(1));
  for (std::size_t g = 0; g < 4; ++g)
    EXPECT_EQ(t.batch.cells[2 * 4 + g].cut_order, 0.5 * shares.at(g));
  EXPECT_EQ(total_of(t.sums("echo_by_order")), 0);
}

}  // namespace
}  // namespace photic::tally
