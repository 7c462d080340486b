// Totals that go on from a state are those that never stopped.
#include "tally/state.hpp"

#include "core/error.hpp"
#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

void score_at_random(Tallies& t, test::Random& random) {
  for (int k = 0; k < 200; ++k) {
    t.batch.score({static_cast<std::size_t>(random.below(2)), random.below(3), 1 + random.below(5),
                   random.between(0, 20), random.between(t.gates.edge_path(0), t.gates.last_path()),
                   random.scale(1e-6, 1e-3)});
  }
  t.batch.photons = 1000;
  t.batch.collisions = static_cast<std::uint64_t>(random.below(9000));
  t.batch.scores = static_cast<std::uint64_t>(random.below(9000));
  t.batch.too_many_events = static_cast<std::uint64_t>(random.below(3));
  t.batch.not_finite = static_cast<std::uint64_t>(random.below(3));
  Operations::each(
      [&](const char*, auto& number) { number = static_cast<std::uint64_t>(random.below(9000)); },
      t.batch.operations);
  Ledger::each([&](const char*, double& weight) { weight = random.between(0, 1000); },
               t.batch.ledger);
}

void expect_same(const Estimates& a, const Estimates& b) {
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.standard_error, b.standard_error);
}

// Seen red: with the ledger of the state left out; with the largest scores; with the collisions;
// with the operations.
TEST(TotalsState, GoesOnToTheLastBit) {
  for (const int stop : {0, 1, 2, 21, 32, 39}) {
    SCOPED_TRACE(stop);
    test::Random random(13);
    Tallies t(2);
    Totals rest(t.shape);
    for (int b = 0; b < 40; ++b) {
      score_at_random(t, random);
      if (b == stop) rest = Totals(t.shape, t.totals.state());
      t.totals.merge(t.batch);
      if (b >= stop) rest.merge(t.batch);
      t.batch.clear();
    }
    EXPECT_EQ(rest.state(), t.totals.state());
    Result resumed;
    rest.fill(resumed);
    const Result whole = t.result();
    expect_same(resumed.echo, whole.echo);
    expect_same(resumed.grid("echo_by_order"), whole.grid("echo_by_order"));
    expect_same(resumed.grid("echo_by_process"), whole.grid("echo_by_process"));
    expect_same(resumed.grid("echo_by_depth"), whole.grid("echo_by_depth"));
    EXPECT_EQ(resumed.convergence_flags, whole.convergence_flags);
    EXPECT_EQ(resumed.grid("echo_by_process").flags, whole.grid("echo_by_process").flags);
    EXPECT_EQ(resumed.grid("echo_by_order").flags, whole.grid("echo_by_order").flags);
    EXPECT_EQ(resumed.variance_of_variance, whole.variance_of_variance);
    EXPECT_EQ(resumed.largest_score_share, whole.largest_score_share);
    EXPECT_EQ(resumed.order_cut_share, whole.order_cut_share);
    EXPECT_EQ(resumed.ledger, whole.ledger);
    EXPECT_EQ(resumed.batches, 40U);
  }
}

TEST(TotalsState, HoldsASnapshotAtEachPowerOfTwo) {
  Tallies t;
  for (std::uint64_t b = 0; b < 20; ++b) {
    EXPECT_EQ(t.totals.state().snapshot_photons.size(), snapshots_at(b) * t.shape.rows()) << b;
    t.score(0, 1e-3);
    t.end_batch(1000);
  }
  std::vector<double> batches, photons;
  for (const double b : {1, 2, 4, 8, 16}) {
    batches.insert(batches.end(), t.shape.rows(), b);
    photons.insert(photons.end(), t.shape.rows(), 1e3 * b);
  }
  EXPECT_EQ(t.totals.state().snapshot_batches, batches);
  EXPECT_EQ(t.totals.state().snapshot_photons, photons);
}

// Seen red: without the comparison of the snapshots.
TEST(TotalsState, OfAnotherShapeIsABug) {
  Tallies t;
  t.end_batch(1000);
  const auto refused = [&](void (*spoil)(TotalsState&)) {
    TotalsState state = t.totals.state();
    spoil(state);
    EXPECT_THROW(Totals(t.shape, std::move(state)), ContractViolation);
  };
  refused([](TotalsState& s) { s.row.pop_back(); });
  refused([](TotalsState& s) { s.echo.pop_back(); });
  refused([](TotalsState& s) { s.grids[0].pop_back(); });
  refused([](TotalsState& s) { s.grids[1].pop_back(); });
  refused([](TotalsState& s) { s.grids[2].pop_back(); });
  refused([](TotalsState& s) { s.grids.pop_back(); });
  refused([](TotalsState& s) { s.cut_order.pop_back(); });
  refused([](TotalsState& s) { s.largest.pop_back(); });
  refused([](TotalsState& s) { s.octaves.pop_back(); });
  refused([](TotalsState& s) { s.snapshot_photons.pop_back(); });
  refused([](TotalsState& s) { s.snapshot_batches.pop_back(); });
  refused([](TotalsState& s) { s.snapshot_echo.pop_back(); });
  refused([](TotalsState& s) { s.batches = 2; });
}

}  // namespace
}  // namespace photic::tally
