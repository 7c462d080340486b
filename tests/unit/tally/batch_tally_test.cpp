// Where a score goes.
#include "tally/batch_tally.hpp"

#include <limits>
#include <numeric>
#include <span>

#include "core/error.hpp"
#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Seen red: with an axis of fewer orders taken.
TEST(BatchTally, HasOneAxisOfAQuantity) {
  Shape shape = Tallies::make_shape(0, 0, 1);
  Grid grid = shape.grids[1];
  grid.axes.push_back(shape.grids[0].axes[0]);
  shape.grids.push_back(grid);
  EXPECT_NO_THROW(Tallies{shape});
  --shape.grids.back().axes.back().count;
  EXPECT_THROW(Tallies{shape}, ContractViolation);
}

// [telescope][channel][gate], then order, process or depth. Seen red: with orders counted from 1;
// with the depth's cell rounded.
TEST(BatchTally, PutsAScoreIntoItsCells) {
  Tallies t;
  t.batch.score({1, 0, 2, 9.0, t.path_in(3), 0.25});
  const std::size_t cell = (1 * 3 + 0) * 4 + 3;
  EXPECT_EQ(t.sums("echo_by_order")[cell * 4 + 2], 0.25);
  EXPECT_EQ(t.sums("echo_by_process")[cell * 3 + 0], 0.25);
  EXPECT_EQ(t.sums("echo_by_depth")[cell * 4 + 1], 0.25);
  EXPECT_EQ(t.batch.cells[cell].largest, 0.25);
  for (const char* table : {"echo_by_order", "echo_by_process", "echo_by_depth"})
    EXPECT_EQ(sum(t.sums(table)), 0.25);
  for (const CellScores& one : t.batch.cells) EXPECT_EQ(one.cut_order, 0);
}

TEST(BatchTally, CountsALineInEveryChannelThatSeesIt) {
  Tallies t;
  t.score(2, 0.5, 1, 1);   // Raman: channels 1 and 2
  t.score(2, 0.25, 1, 2);  // chlorophyll: channel 2
  const auto at = [](std::size_t channel) { return channel * 4 + 2; };
  EXPECT_EQ(t.sums("echo_by_order")[at(0) * 4 + 1], 0);
  EXPECT_EQ(t.sums("echo_by_order")[at(1) * 4 + 1], 0.5);
  EXPECT_EQ(t.sums("echo_by_order")[at(2) * 4 + 1], 0.75);
  EXPECT_EQ(t.sums("echo_by_process")[at(2) * 3 + 1], 0.5);
  EXPECT_EQ(t.sums("echo_by_process")[at(2) * 3 + 2], 0.25);
  EXPECT_EQ(t.batch.cells[at(2)].largest, 0.5);
}

TEST(BatchTally, KeepsHighOrdersTogether) {
  Tallies t;
  for (const std::int32_t order : {0, 1, 1, 2, 3, 4, 50}) t.score(0, 1.0, order);
  EXPECT_EQ(t.sums("echo_by_order")[0], 1);
  EXPECT_EQ(t.sums("echo_by_order")[1], 2);
  EXPECT_EQ(t.sums("echo_by_order")[2], 1);
  EXPECT_EQ(t.sums("echo_by_order")[3], 3);
}

TEST(BatchTally, LeavesOutWhatLiesInNoGate) {
  Tallies t;
  t.batch.score({0, 0, 1, 2, t.gates.edge_path(0) - 1, 1.0});
  t.batch.score({0, 0, 1, 2, t.gates.last_path() + 1, 1.0});
  t.score(1, 0.0);
  t.score(1, -1.0);
  EXPECT_EQ(sum(t.sums("echo_by_order")), 0);
  for (const auto& row : t.batch.touched_cells) EXPECT_TRUE(row.empty());
  EXPECT_EQ(t.batch.not_finite, 0U);
}

// A depth beyond the grid is still an echo.
TEST(BatchTally, KeepsEchoesOfDepthsBeyondTheGrid) {
  Tallies t;
  for (const double depth : {-0.1, 20.0, 1e6}) t.batch.score({0, 0, 1, depth, t.path_in(1), 1.0});
  EXPECT_EQ(sum(t.sums("echo_by_order")), 3);
  EXPECT_EQ(sum(t.sums("echo_by_depth")), 0);
}

TEST(BatchTally, CountsWhatIsNotANumber) {
  Tallies t;
  t.score(1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(t.batch.not_finite, 1U);
  EXPECT_EQ(sum(t.sums("echo_by_order")), 0);
}

// Beyond max_order a score is only booked as cut off. Seen red: with the cut score in the echo too;
// with max_order itself cut.
TEST(BatchTally, BooksWhatMaxOrderCutsOffApart) {
  Tallies t(2);
  t.score(1, 0.5, 2);
  t.score(1, 0.125, 3);
  EXPECT_EQ(sum(t.sums("echo_by_order")), 0.5);
  EXPECT_EQ(sum(t.sums("echo_by_process")), 0.5);
  EXPECT_EQ(sum(t.sums("echo_by_depth")), 0.5);
  EXPECT_EQ(t.batch.cells[1].cut_order, 0.125);
  EXPECT_EQ(t.batch.cells[1].largest, 0.5);
  t.end_batch(10);
  const Result r = t.result();
  EXPECT_EQ(r.echo.mean[1], 0.05);
  EXPECT_EQ(r.order_cut_share[1], 0.25);
}

TEST(BatchTally, CountsScoresByOctave) {
  EXPECT_EQ(score_octave(0.75), 127);
  EXPECT_EQ(score_octave(0.5), 127);
  EXPECT_EQ(score_octave(0.499), 126);
  EXPECT_EQ(score_octave(1.0),
            127);  // no score is above 1 by more than its solid angle allows; the top one takes all
  EXPECT_EQ(score_octave(1e300), 127);
  EXPECT_EQ(score_octave(std::ldexp(1.0, -128)), 0);
  EXPECT_EQ(score_octave(1e-300), 0);
}

// Seen red: without one of the fills.
TEST(BatchTally, IsAsNewWhenCleared) {
  Tallies t(2);
  for (std::int32_t gate = 0; gate < 4; ++gate) {
    for (std::int32_t order = 1; order <= 3; ++order) t.score(gate, 0.1, order, 1, 1);
  }
  t.batch.ledger.absorbed = 1;
  t.batch.photons = t.batch.collisions = t.batch.too_many_events = t.batch.not_finite = 5;
  t.batch.operations.meetings = 5;
  t.batch.clear();
  for (const char* table : {"echo_by_order", "echo_by_process", "echo_by_depth"})
    EXPECT_EQ(sum(t.sums(table)), 0);
  for (const CellScores& cell : t.batch.cells) EXPECT_FALSE(cell.touched());
  for (const auto& kind : t.batch.octaves)
    for (const OctavesOfBatch& count : kind)
      EXPECT_EQ(std::accumulate(count.begin(), count.end(), 0U), 0U);
  for (const auto& row : t.batch.touched_cells) EXPECT_TRUE(row.empty());
  for (const auto& row : t.batch.profile.touched) EXPECT_TRUE(row.empty());
  EXPECT_EQ(t.batch.ledger.absorbed, 0);
  EXPECT_EQ(t.batch.photons + t.batch.collisions + t.batch.too_many_events + t.batch.not_finite,
            0U);
  EXPECT_EQ(t.batch.operations, Operations{});
}

// From the smallest score to the largest, and none of them twice. Seen red: with the octave of the
// largest left out; with counts that a batch keeps.
TEST(BatchTally, CountsTheOctavesOfAllScores) {
  Tallies t;
  for (int batch = 1; batch <= 2; ++batch) {
    for (const double value : {0x1p-3, 0x1p-90, 0x1.8p-41, 0x1p-41}) t.score(1, value);
    t.end_batch(10);
    const auto& octaves = t.totals.state().octaves[1];
    const auto n = static_cast<std::uint64_t>(batch);
    EXPECT_EQ(octaves[score_octaves - 3], n);
    EXPECT_EQ(octaves[score_octaves - 41], 2 * n);
    EXPECT_EQ(octaves[score_octaves - 90], n);
    EXPECT_EQ(std::accumulate(octaves.begin(), octaves.end(), std::uint64_t{0}), 4 * n);
  }
}

}  // namespace
}  // namespace photic::tally
