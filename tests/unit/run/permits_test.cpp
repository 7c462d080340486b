// Permits to simulate batches, shared by runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "core/stop.hpp"
#include "run/batches.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

/// Counts the batches that are simulated at once.
class Counter {
 public:
  void enter() {
    const int now = ++now_;
    int most = most_;
    while (most < now && !most_.compare_exchange_weak(most, now)) {
    }
  }
  void leave() { --now_; }
  [[nodiscard]] int most() const { return most_; }

 private:
  std::atomic<int> now_ = 0, most_ = 0;
};

/// A set without light that takes its time.
class Slow final : public schedule::SetSimulator {
 public:
  explicit Slow(Counter& counter) : counter_(counter) {}

  void run(std::uint64_t /*first*/, std::uint64_t /*count*/, tally::BatchTally& /*tally*/,
           schedule::Arrivals* /*passed*/, const std::stop_token& /*stop*/) const override {
    counter_.enter();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    counter_.leave();
  }

 private:
  Counter& counter_;
};

estimator::Model short_model() {
  return estimator::make_model(
      test::read(test::ship_instrument + test::channel("elastic") +
                 "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n" + test::depth_gates(10, 2) +
                 test::simulation(8000, 5, "batch_photons = 250\n", "forward")),
      *test::tables());
}

/// The most batches that were under way at once, of several runs of three threads each.
int most_at_once(int runs, const std::shared_ptr<Permits>& permits) {
  const estimator::Model model = short_model();
  Counter counter;
  const schedule::Simulator simulator(estimator::make_plan(model),
                                      [&](const auto&) { return std::make_unique<Slow>(counter); });
  std::vector<std::jthread> threads;
  for (int i = 0; i < runs; ++i)
    threads.emplace_back([&] {
      RunOptions options;
      options.threads = 3;
      options.permits = permits;
      RunControl control(model.scene.simulation, options);
      EXPECT_EQ(BatchRunner(model, simulator, control).run().photons(), 8000U);
    });
  threads.clear();
  return counter.most();
}

// Seen red: with a permit more than asked for.
TEST(Permits, LimitTheBatchesOfAllRunsTogether) {
  EXPECT_EQ(most_at_once(6, std::make_shared<Permits>(2)), 2);
  EXPECT_EQ(most_at_once(6, std::make_shared<Permits>(5)), 5);
  EXPECT_EQ(most_at_once(1, std::make_shared<Permits>(1)), 1);
  EXPECT_GT(most_at_once(6, nullptr), 5);
}

// Seen red: with the last to come first.
TEST(Permits, GoToThoseThatCameFirst) {
  Permits permits(1);
  permits.take({});
  std::mutex mutex;
  std::vector<int> order;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 5; ++i) {
    threads.emplace_back([&, i] {
      permits.take({});
      {
        const std::scoped_lock lock(mutex);
        order.push_back(i);
      }
      permits.give_back();
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  permits.give_back();
  threads.clear();
  EXPECT_EQ(order, (std::vector{0, 1, 2, 3, 4}));
}

// One that is no longer wanted is out of the queue. Seen red: with it left in there, by which the
// other one waits for ever.
TEST(Permits, AreNotWaitedForByWhatIsStopped) {
  Permits permits(1);
  permits.take({});
  std::stop_source stop;
  std::jthread first([&] { EXPECT_THROW(permits.take(stop.get_token()), Stopped); });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::jthread second([&] { permits.take({}); });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  stop.request_stop();
  first.join();
  permits.give_back();
  second.join();
  permits.give_back();
}

}  // namespace
}  // namespace photic::run
