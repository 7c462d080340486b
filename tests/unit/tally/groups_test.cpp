// Echoes by groups of batches.
#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

#include "unit/tally/tallies.hpp"

namespace photic::tally {
namespace {

Shape grouped(std::size_t environments = 0) {
  Shape shape = Tallies::make_shape(0, environments, 1);
  shape.keeps_groups = true;
  return shape;
}

/// Whole numbers, of which all sums are exact.
double score_of(std::uint64_t batch) { return static_cast<double>(1 + 7919 * batch % 1000); }

TEST(Groups, AreSixtyFourToAHundredAndTwentyEight) {
  for (std::uint64_t batches = 1; batches < 5000; ++batches) {
    const std::uint64_t of_each = batches_of_group(batches);
    EXPECT_TRUE(std::has_single_bit(of_each));
    EXPECT_EQ(groups_of(batches), (batches + of_each - 1) / of_each);
    EXPECT_LE(groups_of(batches), 128U) << batches;
    if (batches >= 64) {
      EXPECT_GE(groups_of(batches), 64U) << batches;
    }
    if (batches < 128) {
      EXPECT_EQ(groups_of(batches), batches);
    }
  }
  EXPECT_EQ(groups_of(0), 0U);
}

// Seen red: with neighbours that are not added up; with the second one left out; with groups twice
// as long.
TEST(Groups, HoldTheBatchesOfTheirTurn) {
  Tallies t(grouped());
  for (std::uint64_t batches = 1; batches <= 600; ++batches) {
    t.score(1, score_of(batches - 1));
    t.end_batch(1000);
    const std::size_t groups = groups_of(batches);
    const std::uint64_t of_each = batches_of_group(batches);
    const auto& sums = t.totals.state().groups.echo.sums;
    const auto& photons = t.totals.state().groups.photons.sums;
    ASSERT_EQ(sums.size(), groups * t.shape.cells()) << batches;
    ASSERT_EQ(photons.size(), groups * t.shape.rows()) << batches;
    for (std::size_t group = 0; group < groups; ++group) {
      double sum = 0;
      std::uint64_t emitted = 0;
      for (std::uint64_t b = group * of_each; b < std::min(batches, (group + 1) * of_each); ++b) {
        sum += score_of(b);
        emitted += 1000;
      }
      ASSERT_EQ(sums[group * t.shape.cells() + 1], sum) << batches << ' ' << group;
      ASSERT_EQ(photons[group * t.shape.rows()], emitted) << batches << ' ' << group;
    }
  }
}

/// A run of scores in cell 1 and an environment with so many times as much, of which row 1 rests
/// after 70 batches.
void run_with_rests(Tallies& t, int batches) {
  for (int b = 0; b < batches; ++b) {
    const std::vector<double> ratios(EnvironmentScores::size, 2.0);
    t.batch.rests[1] = b >= 70;
    const Score score{0, 0, 1, 7.5, t.path_in(1), score_of(static_cast<std::uint64_t>(b))};
    t.batch.score(score, t.batch.bins(score.path, score.depth), ratios.data());
    t.score(2, 3.0, 1, 1);
    t.end_batch(1000);
  }
}

// Seen red: with the scores of rows that rest; with the scene's echo in place of the environment's;
// with rows and groups exchanged.
TEST(Groups, AreMeansWhoseMeanIsTheEcho) {
  Tallies t(grouped(1));
  run_with_rests(t, 130);
  const Result r = t.result();
  const GroupMeans& by_group = r.by_group;
  ASSERT_EQ(by_group.groups, 65U);
  ASSERT_EQ(by_group.photons.size(), t.shape.rows() * 65);
  ASSERT_EQ(by_group.echo.size(), t.shape.cells() * 65);
  ASSERT_EQ(by_group.environment_echo.size(), t.shape.cells() * 65);
  for (const std::size_t cell : {std::size_t{1}, t.shape.cell(0, 1, 2)}) {
    const std::size_t row = t.shape.row_of(cell), gate = cell % t.shape.gates;
    double photons = 0, echo = 0, environment = 0;
    for (std::size_t group = 0; group < 65; ++group) {
      const double n = by_group.photons[row * 65 + group];
      const std::size_t at = (row * 65 + group) * t.shape.gates + gate;
      photons += n;
      if (n == 0) {
        EXPECT_TRUE(std::isnan(by_group.echo[at]));
        continue;
      }
      echo += n * static_cast<double>(by_group.echo[at]);
      environment += n * static_cast<double>(by_group.environment_echo[at]);
    }
    EXPECT_EQ(photons, static_cast<double>(r.channel_photons[row]));
    EXPECT_NEAR(echo / photons / r.echo.mean[cell], 1, 1e-6);
    EXPECT_NEAR(environment / photons / r.environment_echo.mean[cell], 1, 1e-6);
  }
  EXPECT_EQ(r.channel_photons[1], 70'000U);
}

// Seen red: with neighbours that are not added up.
TEST(Groups, GoOnToTheLastBit) {
  for (const int stop : {1, 70, 127, 128, 129, 255, 256, 299}) {
    Tallies t(grouped());
    test::Random random(5);
    Totals rest(t.shape);
    for (int b = 0; b < 300; ++b) {
      if (b == stop) rest = Totals(t.shape, t.totals.state());
      t.score(1, random.between(1e-6, 1e-3));
      t.batch.photons = 1000;
      t.totals.merge(t.batch);
      if (b >= stop) rest.merge(t.batch);
      t.batch.clear();
    }
    EXPECT_EQ(rest.state(), t.totals.state()) << stop;
  }
}

// Tangents have no echo, and no groups.
TEST(Groups, AreOfWatersAlone) {
  Shape shape = grouped(2);
  shape.tangents = 1;
  Tallies t(shape);
  run_with_rests(t, 3);
  EXPECT_EQ(t.totals.state().groups.environment.sums.size(), 3 * t.shape.cells());
}

TEST(Groups, AreNotKeptUnlessAskedFor) {
  Tallies t;
  t.score(1, 1e-3);
  t.end_batch(1000);
  EXPECT_EQ(t.totals.state().groups, BatchGroups{});
  EXPECT_EQ(t.result().by_group.groups, 0U);
}

}  // namespace
}  // namespace photic::tally
