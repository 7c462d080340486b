// Runs in several sittings.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "run/run.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

constexpr std::uint64_t whole_batch = 8000;

scene::Scene scene_of(std::uint64_t photons, const std::string& more = "",
                      const std::string& estimator = "forward") {
  return test::read(
      test::ship_instrument + test::channel("elastic") + test::channel("raman") +
      "[[sea.layer]]\nbottom_depth_m = 9.1\nchlorophyll_mg_m3 = 0.5\n[bottom]\nalbedo = 0.2\n" +
      test::depth_gates(10, 2) +
      test::simulation(static_cast<double>(photons), 5,
                       fmt::format("max_order = 3\nbatch_photons = {}\n", whole_batch) + more,
                       estimator));
}

tally::Result run_on(int threads, const scene::Scene& scene) {
  RunOptions options;
  options.threads = threads;
  return run(scene, *test::tables(), options);
}

/// As far as the application takes a result to be gone on from.
Start start_of(const tally::Result& result) {
  return {.state = result.state.value(), .wall_time_s = result.wall_time_s, .file = "old.nc"};
}

tally::Result go_on(const tally::Result& earlier, const scene::Scene& scene, int threads = 1) {
  RunOptions options;
  options.threads = threads;
  options.start = start_of(earlier);
  return run(scene, *test::tables(), options);
}

void expect_same(const tally::Estimates& a, const tally::Estimates& b) {
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.standard_error, b.standard_error);
}

/// Equal in all that is not of the sitting itself.
void expect_same(const tally::Result& a, const tally::Result& b) {
  expect_same(a.echo, b.echo);
  expect_same(a.grid("echo_by_process"), b.grid("echo_by_process"));
  expect_same(a.grid("echo_by_order"), b.grid("echo_by_order"));
  expect_same(a.grid("echo_by_depth"), b.grid("echo_by_depth"));
  EXPECT_EQ(a.convergence_flags, b.convergence_flags);
  EXPECT_EQ(a.grid("echo_by_process").flags, b.grid("echo_by_process").flags);
  EXPECT_EQ(a.grid("echo_by_order").flags, b.grid("echo_by_order").flags);
  EXPECT_EQ(a.largest_score_share, b.largest_score_share);
  EXPECT_EQ(a.variance_of_variance, b.variance_of_variance);
  EXPECT_EQ(a.order_cut_share, b.order_cut_share);
  EXPECT_EQ(a.photons, b.photons);
  EXPECT_EQ(a.batches, b.batches);
  EXPECT_EQ(a.collisions, b.collisions);
  EXPECT_EQ(a.ledger, b.ledger);
  EXPECT_EQ(a.stopped_by, b.stopped_by);
  EXPECT_EQ(a.partial, b.partial);
  EXPECT_EQ(a.warnings, b.warnings);
  EXPECT_EQ(a.state, b.state);
}

// An incomplete batch at the end of the earlier run is done again, whole. Seen red: with the state
// taken after that batch; with the first batch to do off by one; with the photons of the first
// batch left in the tally they were checked in.
TEST(Continued, EqualsOneLongRun) {
  const scene::Scene long_scene = scene_of(362'700);
  const tally::Result once = run_on(1, long_scene);
  ASSERT_EQ(once.state->photons, 360'000U);
  for (const std::uint64_t earlier :
       {7'500U, 8'000U, 8'500U, 160'000U, 161'500U, 360'000U, 362'700U}) {
    for (const int threads : {1, 3}) {
      SCOPED_TRACE(fmt::format("{} photons, then {} threads", earlier, threads));
      const tally::Result first = run_on(threads, scene_of(earlier));
      EXPECT_EQ(first.photons, earlier);
      EXPECT_EQ(first.state->photons, earlier / whole_batch * whole_batch);
      expect_same(go_on(first, long_scene, threads), once);
    }
  }
}

// Whatever the estimator does within a batch.
TEST(Continued, InManySittingsEqualsOneLongRun) {
  struct Way {
    std::string more, estimator;
  };
  const std::string nested =
      "[[telescope]]\nposition_m = [0.0, 0.0, 12.0]\ndirection = [0.0, 0.0, -1.0]\n"
      "diameter_m = 0.40\nfocal_length_m = 2.0\ndetector_diameter_m = 0.01\n";
  for (const Way& way :
       {Way{"", "forward"}, Way{nested, "forward"}, Way{"walks = 3", "bidirectional"}}) {
    const auto scene = [&](std::uint64_t photons) {
      return scene_of(photons, way.more, way.estimator);
    };
    tally::Result result = run(scene(700), *test::tables());
    for (std::uint64_t photons = 12'700; photons <= 36'700; photons += 12'000)
      result = go_on(result, scene(photons), 2);
    expect_same(result, run(scene(36'700), *test::tables()));
  }
}

// Seen red: without the time of the earlier sittings.
TEST(Continued, AddsUpTheTime) {
  tally::Result earlier = run(scene_of(16'000), *test::tables());
  earlier.wall_time_s = 1000;
  const tally::Result result = go_on(earlier, scene_of(32'000, "max_time_s = 900.0"));
  EXPECT_EQ(result.photons, 32'000U);
  EXPECT_EQ(result.stopped_by, "photons");
  EXPECT_GT(result.wall_time_s, 1000);
  EXPECT_LT(result.wall_time_s, 1900);
}

TEST(Continued, ReportsThePhotonsOfEarlierSittings) {
  Monitor monitor;
  RunOptions options;
  options.monitor = &monitor;
  options.start = start_of(run(scene_of(16'000), *test::tables()));
  run(scene_of(80'000), *test::tables(), options);
  EXPECT_EQ(monitor.progress().photons, 80'000U);
  EXPECT_EQ(monitor.progress().photons_before, 16'000U);
}

// The target is looked at before anything is added. Seen red: without that look.
TEST(Continued, EndsWhereATargetIsMetAlready) {
  const scene::Scene scene =
      scene_of(100'000'000, "target_relative_error = 0.5\ndirected_fraction = 0.5");
  const tally::Result once = run(scene, *test::tables());
  ASSERT_EQ(once.stopped_by, "target");
  expect_same(go_on(once, scene), once);
}

template <class Change>
std::string refusal(const Change& change) {
  RunOptions options;
  options.start = start_of(run(scene_of(32'000), *test::tables()));
  change(options.start->state);
  try {
    run(scene_of(64'000), *test::tables(), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

// Seen red: without the comparison of the first batch.
TEST(Continued, FromOtherHistoriesIsRefused) {
  const scene::Scene other = scene_of(32'000, "directed_fraction = 0.4");
  EXPECT_EQ(refusal([&](tally::TotalsState& state) { state = *run(other, *test::tables()).state; }),
            "old.nc: made by another build of Photic, or with other data tables: its first photons "
            "scored differently (continue with those, or start anew)");
  EXPECT_EQ(refusal([](tally::TotalsState&) {}), "none");
}

// Seen red: without either half of the check.
TEST(Continued, FromWhatIsNoNumberOfBatchesIsRefused) {
  EXPECT_EQ(refusal([](tally::TotalsState& state) { ++state.photons; }),
            "old.nc: a damaged result, or one of another build: 32001 photons in 4 batches");
  EXPECT_EQ(refusal([](tally::TotalsState& state) { state.photons = 40'000; }),
            "old.nc: a damaged result, or one of another build: 40000 photons in 4 batches");
}

TEST(Continued, ToLessIsABug) {
  const tally::Result earlier = run(scene_of(32'000), *test::tables());
  EXPECT_THROW(go_on(earlier, scene_of(16'000)), ContractViolation);
}

}  // namespace
}  // namespace photic::run
