// How much pilots of `auto` take, by counted operations.
#include "run/contest.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

estimator::Model model_of(double photons, double target = 0) {
  scene::Scene scene = test::read(test::ship_instrument + test::channel("elastic") +
                                  test::water(0.06, 0.1, test::peaked_phase) +
                                  test::depth_gates(30, 3) + test::simulation(1, 3, "", "auto"));
  scene.simulation.photons.reset();
  if (photons > 0) scene.simulation.photons = static_cast<std::uint64_t>(photons);
  if (target > 0) scene.simulation.target_relative_error = target;
  return estimator::make_model(scene, *test::tables());
}

Contender contender(scene::Estimator estimator) {
  Contender out{scene::word_of(estimator), {}};
  out.simulation.estimator = estimator;
  if (estimator == scene::Estimator::bidirectional) out.simulation.walk_attenuation = 0.6;
  out.simulation.seed = 5;
  return out;
}

Outcome outcome_of(const estimator::Model& model, int threads = 1) {
  RunOptions options;
  options.threads = threads;
  return contend(model,
                 {contender(scene::Estimator::bidirectional), contender(scene::Estimator::forward)},
                 {}, options);
}

// Seen red: with pilots of a fixed size.
TEST(Contest, TakesLessForAShorterRun) {
  const double short_run = outcome_of(model_of(1000)).operations;
  const double longer = outcome_of(model_of(3e5)).operations;
  EXPECT_LT(4 * short_run, longer);
  EXPECT_LT(4 * outcome_of(model_of(0, 0.3)).operations, outcome_of(model_of(0, 0.005)).operations);
}

// Of two limits the nearer one sets how long the run is. Seen red: with the target alone.
TEST(Contest, LooksAtPhotonsAndTarget) {
  EXPECT_EQ(outcome_of(model_of(1000, 0.005)).operations,
            outcome_of(model_of(1000, 0.3)).operations);
}

// However long the run: 10240 photons of the bidirectional estimator, 81920 of the other. Seen red:
// with stages without end.
TEST(Contest, HasAnEnd) {
  for (const Standing& standing : outcome_of(model_of(1e15)).standing) {
    EXPECT_LE(standing.photons, 81920U);
  }
}

// Forward photons are at a loss in these gates by far, which few photons show. Seen red: with all
// contenders in all stages.
TEST(Contest, GivesUpWhatIsClearlyWorse) {
  estimator::Model model = model_of(1e15);
  const Outcome outcome =
      contend(model,
              {contender(scene::Estimator::bidirectional),
               contender(scene::Estimator::bidirectional), contender(scene::Estimator::analog)},
              {}, {});
  EXPECT_TRUE(outcome.standing[2].given_up_early);
  EXPECT_FALSE(outcome.standing[0].given_up_early);
  EXPECT_EQ(outcome.standing[0].photons, 10240U);
}

// Each in a medium made for its own walks. Seen red: with the medium of the open scene for all.
TEST(Contest, TriesEachWithItsOwnWalks) {
  Contender other = contender(scene::Estimator::bidirectional);
  other.simulation.walk_attenuation = 0.9;
  const Outcome outcome =
      contend(model_of(1000), {contender(scene::Estimator::bidirectional), other}, {}, {});
  EXPECT_NE(outcome.standing[0].times_the_work, outcome.standing[1].times_the_work);
}

Setting meetings(double number) {
  return {fmt::format("meetings = {}", number), true,
          [=](scene::Simulation& s) { s.meetings = number; }};
}

// One after another, each on top of what is best so far; what changes nothing is not tried. Seen
// red: with each tried on the contender alone; with what is worse taken.
TEST(Contest, TriesSettingsWithTheBestSoFar) {
  const Contender walks = contender(scene::Estimator::bidirectional);
  const Setting longer{"walk_attenuation = 0.99", true,
                       [](scene::Simulation& s) { s.walk_attenuation = 0.99; }};
  const Outcome outcome =
      contend(model_of(1e15), {walks}, {meetings(30), meetings(30), longer, meetings(1e4)}, {});
  ASSERT_EQ(outcome.tried.size(), 3U);
  EXPECT_TRUE(outcome.tried[0].taken);
  for (const Tried& worse : {outcome.tried[1], outcome.tried[2]}) {
    EXPECT_FALSE(worse.taken) << worse.name;
    EXPECT_GT(worse.times_the_work, 1.2) << worse.name;
  }
  EXPECT_EQ(outcome.simulation.meetings, 30);
  EXPECT_EQ(outcome.simulation.walk_attenuation, 0.6);
}

// Hardly cheaper, and hardly better. Seen red: without the gain that is asked for.
TEST(Contest, LeavesSettingsThatGainLittle) {
  const Outcome outcome =
      contend(model_of(3e5), {contender(scene::Estimator::bidirectional)}, {meetings(90)}, {});
  ASSERT_EQ(outcome.tried.size(), 1U);
  EXPECT_LT(outcome.tried[0].times_the_work, 1.0);
  EXPECT_FALSE(outcome.tried[0].taken);
}

// Seen red: with settings of walks tried with any estimator.
TEST(Contest, TriesNoSettingsOfWalksWithHistories) {
  const Outcome outcome =
      contend(model_of(1e15), {contender(scene::Estimator::forward)}, {meetings(30)}, {});
  EXPECT_TRUE(outcome.tried.empty());
}

// All of them take a tenth of the run at most. Seen red: with settings tried for however short a
// run.
TEST(Contest, TriesNoSettingsInAShortRun) {
  const Outcome outcome =
      contend(model_of(2000), {contender(scene::Estimator::bidirectional)}, {meetings(30)}, {});
  EXPECT_TRUE(outcome.tried.empty());
}

// Seen red: with one more stage for a second thread.
TEST(Contest, IsTheSameOnTwoThreads) {
  const estimator::Model model = model_of(0, 0.01);
  const Outcome one = outcome_of(model, 1), two = outcome_of(model, 2);
  EXPECT_EQ(one.best, two.best);
  EXPECT_EQ(one.operations, two.operations);
  for (std::size_t i = 0; i < one.standing.size(); ++i) {
    EXPECT_EQ(one.standing[i].photons, two.standing[i].photons);
    EXPECT_EQ(one.standing[i].times_the_work, two.standing[i].times_the_work);
  }
}

}  // namespace
}  // namespace photic::run
