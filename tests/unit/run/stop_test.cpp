// Runs that are watched, and stopped in all their phases. Numbers of photons, events and batches
// are counted; nothing here is measured by a clock, but for the patience of tests that fail.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "core/stop.hpp"
#include "run/batches.hpp"
#include "run/run.hpp"
#include "schedule/engines.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t photons_of_batch = 2000;
constexpr double for_ever = 1e12;

scene::Scene watched_scene(double photons, const std::string& estimator = "forward",
                           const std::string& more = "") {
  return test::read(test::ship_instrument + test::channel("elastic") +
                    "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n" + test::depth_gates(10, 2) +
                    test::simulation(photons, 5,
                                     fmt::format("batch_photons = {}\n", photons_of_batch) + more,
                                     estimator));
}

/// A run on a thread of its own.
class Watched {
 public:
  explicit Watched(const scene::Scene& scene, std::shared_ptr<Permits> permits = {})
      : scene_(scene) {
    options_.threads = 2;
    options_.monitor = &monitor;
    options_.permits = std::move(permits);
    result_ =
        std::async(std::launch::async, [this] { return run(scene_, *test::tables(), options_); });
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;
  ~Watched() { monitor.stop(); }  // of a test that has failed

  /// Waits until is(progress).
  template <class Is>
  void wait_until(Is is) const {
    while (!is(monitor.progress()) && result_.wait_for(1ms) != std::future_status::ready) {
    }
  }
  [[nodiscard]] bool ends_within(std::chrono::seconds patience) const {
    return result_.wait_for(patience) == std::future_status::ready;
  }
  tally::Result result() { return result_.get(); }

  Monitor monitor;

 private:
  scene::Scene scene_;
  RunOptions options_;
  std::future<tally::Result> result_;
};

void expect_as_long_as(const tally::Result& result) {
  const auto alone = run(watched_scene(static_cast<double>(result.photons)), *test::tables());
  EXPECT_EQ(result.echo.mean, alone.echo.mean);
  EXPECT_EQ(result.state.value(), alone.state.value());
}

TEST(Stopped, ARunHasTheBatchesThatHaveEnded) {
  Watched run(watched_scene(for_ever));
  run.wait_until([](const Progress& p) { return p.photons >= 10 * photons_of_batch; });
  run.monitor.stop();
  const tally::Result result = run.result();
  EXPECT_EQ(result.stopped_by, "interrupt");
  EXPECT_TRUE(result.partial);
  EXPECT_GE(result.photons, 10 * photons_of_batch);
  EXPECT_EQ(result.photons % photons_of_batch, 0U);
  expect_as_long_as(result);
  EXPECT_EQ(run.monitor.progress().phase, Phase::ended);
  EXPECT_EQ(run.monitor.progress().photons, result.photons);
}

/// A set without light whose batches end at once, but for those from a photon on: they last until
/// they are stopped. The last of the others waits for the first of these.
class EndlessFrom final : public schedule::SetSimulator {
 public:
  explicit EndlessFrom(std::uint64_t photon) : photon_(photon) {}

  void run(std::uint64_t first, std::uint64_t count, tally::BatchTally& /*tally*/,
           schedule::Arrivals* /*passed*/, const std::stop_token& stop) const override {
    if (first < photon_) {
      if (first + count == photon_) begun_.wait(false);
      return;
    }
    begun_ = true;
    begun_.notify_all();
    while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
    throw_stopped();
  }

 private:
  std::uint64_t photon_;
  mutable std::atomic<bool> begun_ = false;
};

/// The end of a run on three threads of batches that never end from a photon on, stopped when it
/// has come to that.
struct EndlessRun {
  std::uint64_t photons;
  std::string stopped_by;
};
EndlessRun endless_from(std::uint64_t photon, const std::string& more = "") {
  const auto model =
      estimator::make_model(watched_scene(for_ever, "forward", more), *test::tables());
  const schedule::Simulator simulator(estimator::make_plan(model), [&](const auto&) {
    return std::make_unique<EndlessFrom>(photon);
  });
  Monitor monitor;
  RunOptions options;
  options.threads = 3;
  options.monitor = &monitor;
  RunControl control(model.scene.simulation, options);
  control.shown_to = &monitor;
  BatchRunner runner(model, simulator, control);
  auto totals = std::async(std::launch::async, [&] { return runner.run(); });
  while (more.empty() && monitor.progress().photons < photon) std::this_thread::yield();
  if (more.empty()) monitor.stop();
  return {totals.get().photons(), control.ending.stopped_by};
}

// Seen red: with the batches that were broken off merged as they were.
TEST(Stopped, InABatchARunHasThoseBeforeIt) {
  for (const std::uint64_t batches : {0U, 1U, 7U}) {
    const auto [photons, stopped_by] = endless_from(batches * photons_of_batch);
    EXPECT_EQ(photons, batches * photons_of_batch);
    EXPECT_EQ(stopped_by, "interrupt");
  }
}

// Batches that are under way at the end of a run are of no use. Seen red, for ever: without a stop
// of them.
TEST(Stopped, AreTheBatchesThatARunDoesNotNeed) {
  const auto [photons, stopped_by] = endless_from(photons_of_batch, "max_time_s = 1e-9\n");
  EXPECT_EQ(photons, photons_of_batch);
  EXPECT_EQ(stopped_by, "time");
}

// Seen red: without the look at stops after each pilot.
TEST(Stopped, WhilePilotsCompareEstimatorsARunHasNoResult) {
  Watched run(watched_scene(for_ever, "auto"));
  run.wait_until([](const Progress& p) { return p.pilots_done >= 2; });
  EXPECT_EQ(run.monitor.progress().phase, Phase::choosing);
  run.monitor.stop();
  EXPECT_THROW(run.result(), StoppedBeforeFirstBatch);
  const Progress end = run.monitor.progress();
  EXPECT_EQ(end.phase, Phase::ended);
  EXPECT_LT(end.pilots_done, end.pilots);
}

TEST(Stopped, BeforeItBeginsARunHasNoResult) {
  Monitor monitor;
  monitor.stop();
  RunOptions options;
  options.monitor = &monitor;
  EXPECT_THROW(run(watched_scene(for_ever), *test::tables(), options), StoppedBeforeFirstBatch);
  EXPECT_EQ(monitor.progress().phase, Phase::ended);
}

// Seen red: without the look at stops in layers of water; in the air.
TEST(Stopped, NoModelIsMade) {
  std::stop_source stop;
  stop.request_stop();
  const scene::Scene scene = watched_scene(1000);
  EXPECT_THROW(estimator::make_model(scene, *test::tables(), stop.get_token()), photic::Stopped);
  scene::Scene in_air =
      test::read(test::ship_instrument + test::channel("elastic") +
                 "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n" +
                 "[atmosphere]\nprofile = \"midlatitude-summer\"\n" + test::depth_gates(10, 2) +
                 test::simulation(1000, 5, "", "forward"));
  const auto model = estimator::make_model(in_air, *test::tables());
  EXPECT_THROW(schedule::make_simulator(model, {}, stop.get_token()), photic::Stopped);
}

/// Collisions in a batch that is stopped before it begins.

std::uint64_t collisions_after_stop(const std::string& estimator, const std::optional<Isa>& lanes) {
  const auto model = estimator::make_model(watched_scene(for_ever, estimator), *test::tables());
  const auto simulator = schedule::make_simulator(model, lanes);
  tally::BatchTally tally(model.shape, model.gates);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(simulator->simulate(0, photons_of_batch, tally, stop.get_token()), photic::Stopped);
  return tally.collisions;
}

// After a stop no more is walked than one collision of the photons that are on their way together,
// or a set of walks. Seen red, all of them: with engines that never look.
TEST(Stopped, EnginesWalkNoFurtherThanToTheNextLook) {
  for (const auto& lanes : {std::optional<Isa>{}, std::optional(Isa::baseline)}) {
    EXPECT_LE(collisions_after_stop("forward", lanes), lanes ? 256U : 1U);
    EXPECT_LE(collisions_after_stop("analog", lanes), lanes ? 8U : 1U);
    EXPECT_LE(collisions_after_stop("bidirectional", lanes), lanes ? 3000U : 50U);
  }
}

// Seen red: with the batch at hand taken for one that has ended.
TEST(Stopped, WhereItIsTakenUpARunHasWhatItHadBefore) {
  const scene::Scene scene = watched_scene(10 * photons_of_batch);
  const auto model = estimator::make_model(scene, *test::tables());
  const auto before = run(watched_scene(4 * photons_of_batch), *test::tables());
  Monitor monitor;
  monitor.stop();
  RunOptions options;
  options.monitor = &monitor;
  options.start = Start{.state = before.state.value(), .wall_time_s = 1, .file = "old.nc"};
  RunControl control(model.scene.simulation, options);
  const auto totals = BatchRunner(model, *schedule::make_simulator(model, {}), control).run();
  EXPECT_EQ(totals.state(), before.state.value());
  EXPECT_EQ(control.ending.stopped_by, "interrupt");
}

// Both threads of a run wait for a permit that somebody else has. Seen red: with permits that are
// waited for whatever happens.
TEST(Stopped, WhileItWaitsForPermitsARunHasNoResult) {
  const auto permits = std::make_shared<Permits>(1);
  struct Held {
    explicit Held(Permits& of) : permits(of) { permits.take({}); }
    ~Held() { permits.give_back(); }
    Permits& permits;
  };
  auto held = std::make_unique<Held>(*permits);
  Watched run(watched_scene(for_ever), permits);
  run.wait_until([](const Progress& p) { return p.phase == Phase::running; });
  EXPECT_FALSE(run.monitor.so_far());
  run.monitor.stop();
  EXPECT_TRUE(run.ends_within(20s));
  held.reset();
  EXPECT_THROW(run.result(), StoppedBeforeFirstBatch);
}

// Seen red: with a state only where none is asked for.
TEST(Watched, SoFarIsWhatARunOfSoManyPhotonsHas) {
  Watched run(watched_scene(for_ever));
  run.wait_until([](const Progress& p) { return p.photons >= photons_of_batch; });
  std::uint64_t photons = 0;
  for (int k = 0; k < 3; ++k) {
    const auto so_far = run.monitor.so_far(true);
    ASSERT_TRUE(so_far);
    EXPECT_EQ(so_far->stopped_by, "checkpoint");
    EXPECT_TRUE(so_far->partial);
    EXPECT_GE(so_far->photons, photons);
    photons = so_far->photons;
    expect_as_long_as(*so_far);
  }
  EXPECT_FALSE(run.monitor.so_far()->state);
  run.monitor.stop();
  EXPECT_GE(run.result().photons, photons);
  EXPECT_FALSE(run.monitor.so_far());
}

// Seen red: without the phase at the end.
TEST(Watched, ProgressIsThatOfTheLastBatchEnd) {
  Watched run(watched_scene(40 * photons_of_batch, "forward", "target_relative_error = 1e-9\n"));
  EXPECT_EQ(run.result().photons, 40 * photons_of_batch);
  const Progress end = run.monitor.progress();
  EXPECT_EQ(end.phase, Phase::ended);
  EXPECT_EQ(end.photons, 40 * photons_of_batch);
  EXPECT_EQ(end.photons_asked, 40 * photons_of_batch);
  EXPECT_EQ(end.photons_before, 0U);
  EXPECT_EQ(end.target, 1e-9);
  EXPECT_EQ(end.pilots_done, 0U);
  EXPECT_GT(end.gates, 0U);
  EXPECT_GT(end.elapsed_s, 0);
}

TEST(Watched, AllPilotsThatAreAnnouncedAreDone) {
  Watched run(watched_scene(photons_of_batch, "auto"));
  run.result();
  const Progress end = run.monitor.progress();
  EXPECT_GT(end.pilots, 5U);
  EXPECT_EQ(end.pilots_done, end.pilots);
}

}  // namespace
}  // namespace photic::run
