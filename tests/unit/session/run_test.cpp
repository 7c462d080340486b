// Several runs at once in one process.
#include "session/run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "run/run.hpp"
#include "session_support.hpp"
#include "support/scenes.hpp"

namespace photic::session {
namespace {

using std::chrono::milliseconds;

scene::Scene scene_of(std::uint64_t photons, double chlorophyll,
                      const std::string& estimator = "forward") {
  return test::read(
      test::ship_instrument + test::channel("elastic") + test::channel("raman") +
      fmt::format("[[sea.layer]]\nbottom_depth_m = 9.1\nchlorophyll_mg_m3 = {}\n", chlorophyll) +
      "[bottom]\nalbedo = 0.2\n" + test::depth_gates(10, 2) +
      test::simulation(static_cast<double>(photons), 5, "batch_photons = 500\n", estimator));
}

run::RunOptions on_threads(int threads) {
  run::RunOptions options;
  options.threads = threads;
  return options;
}

tally::Result alone(const scene::Scene& scene) {
  return run::run(scene, *test::context().library, on_threads(1));
}

void expect_same(const tally::Result& a, const tally::Result& b) {
  EXPECT_EQ(a.echo.mean, b.echo.mean);
  EXPECT_EQ(a.state, b.state);
  EXPECT_EQ(a.photons, b.photons);
}

constexpr std::uint64_t long_run = 1'000'000'000;

// Seen red: with one monitor for all runs.
TEST(Run, FourAtOnceAreAsFourInTurn) {
  const std::array<scene::Scene, 4> scenes{scene_of(6'000, 0.2), scene_of(5'000, 2),
                                           scene_of(1'000, 0.5, "bidirectional"),
                                           scene_of(long_run, 1)};
  std::vector<std::unique_ptr<session::Run>> runs;
  for (const scene::Scene& scene : scenes)
    runs.push_back(std::make_unique<session::Run>(test::context(), scene, on_threads(2)));
  std::optional<tally::Result> partial;
  while (!partial) partial = runs.back()->so_far();
  runs.back()->stop();
  const tally::Result stopped = runs.back()->result();
  for (std::size_t i = 0; i < 3; ++i) expect_same(runs[i]->result(), alone(scenes[i]));
  EXPECT_TRUE(stopped.partial);
  EXPECT_FALSE(partial->state);
  EXPECT_LE(partial->photons, stopped.photons);
  expect_same(stopped, alone(scene_of(stopped.photons, 1)));
  EXPECT_EQ(partial->echo.mean, alone(scene_of(partial->photons, 1)).echo.mean);
}

TEST(Run, ReportsItsProgressUntilItEnds) {
  session::Run run(test::context(), scene_of(3'000, 1), on_threads(1));
  EXPECT_TRUE(run.wait_for(milliseconds(600'000)));
  const run::Progress at_end = run.progress();
  EXPECT_EQ(at_end.phase, run::Phase::ended);
  EXPECT_EQ(at_end.photons, 3'000U);
  EXPECT_FALSE(run.so_far());
  EXPECT_EQ(run.result().photons, 3'000U);
}

// Seen red: with a destructor that does not stop.
TEST(Run, StopsWhenNobodyWantsIt) {
  const session::Run run(test::context(), scene_of(long_run, 1), on_threads(2));
  EXPECT_FALSE(run.wait_for(milliseconds(1)));
}

TEST(Run, ThatIsStoppedAtOnceHasNoResult) {
  session::Run run(test::context(), scene_of(long_run, 1), on_threads(1));
  run.stop();
  EXPECT_TRUE(run.wait_for(milliseconds(600'000)));
}

}  // namespace
}  // namespace photic::session
