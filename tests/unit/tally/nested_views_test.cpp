// Views one inside the other: a score in the narrowest is one in all that hold it.
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

/// Four telescopes, with an environment; if their views nest, 3 within 1 within 0.
Shape shape_of_four(bool nested) {
  Shape shape = Tallies::make_shape(2, 1, kinds_of_technique);
  shape.telescopes = 4;
  if (nested) shape.wider = {std::nullopt, 0, std::nullopt, 1};
  return shape;
}
/// The telescopes that see what a telescope sees.
const std::array<std::vector<std::size_t>, 4> seen_by{{{0}, {1, 0}, {2}, {3, 1, 0}}};

/// Scores of the same kind in both: given to the narrowest telescope, or to each that sees them.
/// All sums of their powers have digits enough, in any order.
void add_scores(Tallies& nested, Tallies& each, test::Random& random, std::size_t narrowest) {
  const auto below = [&](int n) { return static_cast<std::int32_t>(random.uniform() * n); };
  for (int k = 0; k < 100; ++k) {
    std::array<double, EnvironmentScores::size> ratio{};
    ratio.fill(0.5 * (1 + below(4)));
    Score score{narrowest,
                below(3),
                1 + below(4),
                20 * random.uniform(),
                0,
                (1 + below(8)) / 64.0,
                below(2) == 0 ? Technique::laser : Technique::both};
    score.path = nested.path_in(below(4));
    const auto at = nested.batch.bins(score.path, score.depth);
    nested.batch.score(score, at, ratio.data());
    for (const std::size_t telescope : seen_by[narrowest]) {
      score.telescope = telescope;
      each.batch.score(score, at, ratio.data());
    }
  }
}

std::vector<std::vector<std::uint32_t>> sorted(std::vector<std::vector<std::uint32_t>> rows) {
  for (auto& row : rows) std::ranges::sort(row);
  return rows;
}

void expect_same(const BatchTally& a, const BatchTally& b) {
  EXPECT_TRUE(std::ranges::equal(a.parts, b.parts));
  EXPECT_TRUE(std::ranges::equal(a.profile.sums, b.profile.sums));
  EXPECT_EQ(sorted(a.profile.touched), sorted(b.profile.touched));
  EXPECT_EQ(sorted(a.touched_cells), sorted(b.touched_cells));
  for (std::size_t k = 0; k < a.cells.size(); ++k) {
    EXPECT_EQ(a.cells[k].largest, b.cells[k].largest);
    EXPECT_EQ(a.cells[k].cut_order, b.cells[k].cut_order);
    EXPECT_EQ(a.cells[k].scores, b.cells[k].scores);
    for (std::size_t kind = 0; kind < kinds_of_technique; ++kind)
      EXPECT_EQ(a.octaves[kind][k], b.octaves[kind][k]);
  }
  for (std::size_t k = 0; k < a.environment.size(); ++k) {
    const EnvironmentScores &x = a.environment[k], &y = b.environment[k];
    EXPECT_EQ(x.echo, y.echo);
    EXPECT_EQ(x.difference, y.difference);
    EXPECT_EQ(x.largest, y.largest);
    EXPECT_EQ(x.squares, y.squares);
    EXPECT_EQ(x.fourths, y.fourths);
    EXPECT_EQ(x.squares_of_differences, y.squares_of_differences);
    EXPECT_EQ(x.fourths_of_differences, y.fourths_of_differences);
  }
}

/// All but how many scores were offered.
void expect_same(TotalsState a, const TotalsState& b) {
  EXPECT_LT(a.scores, b.scores);
  a.scores = b.scores;
  EXPECT_EQ(a, b);
}

// Seen red: with telescopes taken in the order of the scene; with any of the sums left out; with
// depths that are touched not reported.
TEST(NestedViews, AreScoredAsIfEachWereAlone) {
  Tallies nested(shape_of_four(true)), each(shape_of_four(false));
  test::Random random(7);
  for (int batch = 0; batch < 2; ++batch) {
    for (std::size_t narrowest = 0; narrowest < 4; ++narrowest)
      add_scores(nested, each, random, narrowest);
    nested.batch.pass_to_wider();
    expect_same(nested.batch, each.batch);
    nested.end_batch(1000);
    each.end_batch(1000);
  }
  expect_same(nested.totals.state(), each.totals.state());
}

// What the narrow one alone has scored is in the wide ones' tallies, too, and gone when cleared.
// Seen red: with cells that are touched not reported.
TEST(NestedViews, OfWhichTheWideOnesScoredNothing) {
  Tallies nested(shape_of_four(true)), each(shape_of_four(false));
  test::Random random(8);
  add_scores(nested, each, random, 3);
  nested.batch.pass_to_wider();
  expect_same(nested.batch, each.batch);
  nested.batch.clear();
  each.batch.clear();
  expect_same(nested.batch, each.batch);
}

// A narrow row that rests still sees for the wide ones. Seen red: with scores of rows that rest not
// passed on.
TEST(NestedViews, PassOnWhileTheyRest) {
  for (const std::size_t resting : {0U, 1U, 3U}) {
    SCOPED_TRACE(resting);
    Tallies nested(shape_of_four(true)), each(shape_of_four(false));
    for (Tallies* t : {&nested, &each})
      for (std::size_t c = 0; c < t->shape.channels; ++c)
        t->batch.rests[resting * t->shape.channels + c] = true;
    test::Random random(9);
    for (std::size_t narrowest = 0; narrowest < 4; ++narrowest)
      add_scores(nested, each, random, narrowest);
    nested.batch.pass_to_wider();
    nested.end_batch(1000);
    each.end_batch(1000);
    expect_same(nested.totals.state(), each.totals.state());
  }
}

// The widest asks for light while any within it does. Seen red: without those within.
TEST(NestedViews, AreAskedForTogether) {
  Tallies t(shape_of_four(true));
  const auto rest = [&](std::size_t telescope) {
    for (std::size_t c = 0; c < t.shape.channels; ++c)
      t.batch.rests[telescope * t.shape.channels + c] = true;
  };
  rest(0);
  rest(1);
  EXPECT_TRUE(t.batch.wants(0, 1));
  EXPECT_TRUE(t.batch.wants(1, 1));
  rest(3);
  for (const std::size_t telescope : {0U, 1U, 3U}) EXPECT_FALSE(t.batch.wants(telescope, 1));
  EXPECT_TRUE(t.batch.wants(2, 1));
}

}  // namespace
}  // namespace photic::tally
