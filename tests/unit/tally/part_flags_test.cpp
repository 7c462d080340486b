// Flags of single orders and processes.
#include <cstdint>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

/// Of telescope 0, channel 0, gate 0.
struct PartFlags {
  std::int32_t gate = 0, first_order = 0, second_order = 0, process = 0;
};

PartFlags flags_of(const Tallies& t) {
  const Result r = t.result();
  const std::size_t gates = t.shape.gates;
  return {r.convergence_flags[0], r.grid("echo_by_order").flags[gates],
          r.grid("echo_by_order").flags[2 * gates], r.grid("echo_by_process").flags[0]};
}

/// Batches of 1000 photons, whose first order adds up to 1e-3, and the second to `second(batch)`.
template <class Second>
void add_batches(Tallies& t, int batches, Second second) {
  test::Random random(41);
  for (int b = 0; b < batches; ++b) {
    const double first = 1e-3 * random.between(0.9, 1.1);
    for (int k = 0; k < 50; ++k) t.score(0, first / 50, 1);
    for (int k = 0; k < 50; ++k) t.score(0, second(b) / 50, 2);
    t.end_batch(1000);
  }
}

TEST(PartFlags, AreNotRaisedByASteadyPart) {
  Tallies t;
  add_batches(t, 64, [](int b) { return b % 2 == 0 ? 4e-5 : 5e-5; });
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.gate, 0);
  EXPECT_EQ(f.first_order, 0);
  EXPECT_EQ(f.second_order, 0);
  EXPECT_EQ(f.process, 0);
}

// Its share of the unseen is above its own error, and below that of the gate. Seen red: with that
// share compared to the part's own error.
TEST(PartFlags, HeavyTailIsNoneWhereTheGateHasNone) {
  Tallies t;
  add_batches(t, 64, [](int) { return 5e-5; });
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.gate, 0);
  EXPECT_EQ(f.second_order, 0);
}

// Seen red: with the sums of the echo for those of the part.
TEST(PartFlags, NoScore) {
  Tallies t;
  add_batches(t, 64, [](int) { return 0.0; });
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.first_order, 0);
  EXPECT_EQ(f.second_order, no_score);
  const Result r = t.result();
  EXPECT_EQ(r.grid("echo_by_process").flags[t.shape.gates], no_score);
}

TEST(PartFlags, FewBatches) {
  Tallies t;
  add_batches(t, 29, [](int b) { return b % 2 == 0 ? 4e-5 : 5e-5; });
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.gate, few_batches);
  EXPECT_EQ(f.second_order, few_batches);
  EXPECT_EQ(f.process, few_batches);
}

// Of the part alone, beside which the rest of the gate is large. Seen red: with the sums of the
// echo for those of the part.
TEST(PartFlags, LargeError) {
  Tallies t;
  add_batches(t, 64, [](int b) { return b % 2 == 0 ? 5e-5 : 0.0; });
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.gate, 0);
  EXPECT_EQ(f.first_order, 0);
  EXPECT_EQ(f.second_order, large_error);
  EXPECT_EQ(f.process, 0);
}

// Of orders that scatter, and whose sum does not, so that any score would be many of its errors.
// Seen red: without the flags of the gate.
TEST(PartFlags, HeavyTailOfTheGate) {
  Tallies t;
  for (int b = 0; b < 64; ++b) {
    const double first = b % 2 == 0 ? 4e-4 : 6e-4;
    double second = 1e-3 - first;
    for (int k = b; k < 128; k += 64) {
      const double large = 2e-5 * falling_off(k, 128, 3);
      t.score(0, large, 2);
      second -= large;
    }
    for (int k = 0; k < 100; ++k) {
      t.score(0, first / 100, 1);
      t.score(0, second / 100, 2);
    }
    t.end_batch(1000);
  }
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.gate, heavy_tail);
  EXPECT_EQ(f.first_order, heavy_tail);
  EXPECT_EQ(f.second_order, heavy_tail);
  EXPECT_EQ(f.process, heavy_tail);
}

// Too few scores to know how they are distributed. Seen red: with the flags of the gate where a
// part has no score.
TEST(PartFlags, HeavyTailOfFewScores) {
  Tallies t;
  for (int b = 0; b < 64; ++b) {
    t.score(0, 1e-3);
    t.end_batch(1000);
  }
  const PartFlags f = flags_of(t);
  EXPECT_EQ(f.gate, heavy_tail);
  EXPECT_EQ(f.first_order, heavy_tail);
  EXPECT_EQ(f.second_order, no_score);
  EXPECT_EQ(f.process, heavy_tail);
}

// Light that no walk carries does not ask for any: order 0, and processes of that kind. Seen red:
// with the flag of the gate for all of its parts.
TEST(PartFlags, BeamMissedIsOfLightThatWalksCarry) {
  for (const bool beside : {false, true}) {
    Shape shape = Tallies::make_shape(0, 0, kinds_of_technique);
    shape.grid("echo_by_process").beside_walks = {beside, false, false};
    Tallies t(shape);
    test::Random random(42);
    for (int b = 0; b < 64; ++b) {
      for (const std::int32_t order : {0, 1}) {
        const Technique technique = order == 0 ? Technique::none : Technique::laser;
        const double value = 1e-5 * random.between(0.9, 1.1);
        for (int k = 0; k < 50; ++k)
          t.batch.score({0, 0, order, 2.5, t.path_in(0), value, technique});
      }
      t.end_batch(1000);
    }
    const Result r = t.result();
    EXPECT_EQ(r.convergence_flags[0], beam_missed);
    EXPECT_EQ(r.grid("echo_by_order").flags[0], 0);
    EXPECT_EQ(r.grid("echo_by_order").flags[t.shape.gates], beam_missed);
    EXPECT_EQ(r.grid("echo_by_process").flags[0], beside ? 0 : beam_missed);
  }
}

}  // namespace
}  // namespace photic::tally
