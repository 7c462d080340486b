// Splitting, photon by photon.
#include "estimator/forward/tools.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <set>

#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

World<double> world_with_tools(const std::string& tools) {
  const auto scene =
      test::read(test::ship_instrument + test::channel("elastic") +
                 test::water(0.06, 0.1, test::peaked_phase) + test::depth_gates(30, 3) +
                 test::simulation(5000, 3, "[simulation.tools]\n" + tools));
  static std::deque<Model> problems;  // that the worlds look into
  problems.push_back(make_model(scene, *test::tables()));
  return make_world<double>(problems.back());
}

// From a depth on, and 1 above the first. Seen red: with > for >=; with the first value above.
TEST(Importance, HoldsFromItsDepthOn) {
  const auto world =
      world_with_tools("importance = [ { depth_m = 2, value = 3 }, { depth_m = 5, value = 0.5 } ]");
  EXPECT_EQ(importance_at(world.forward.tools, 0.0), 1);
  EXPECT_EQ(importance_at(world.forward.tools, 1.99), 1);
  EXPECT_EQ(importance_at(world.forward.tools, 2.0), 3);
  EXPECT_EQ(importance_at(world.forward.tools, 5.0), 0.5);
  EXPECT_EQ(importance_at(world.forward.tools, 500.0), 0.5);
}

// As many photons as the ratio of importances, in the mean; weight is kept with what is booked, to
// rounding. Seen red: with the weight not divided; with the fraction rounded up always.
TEST(Importance, SplitsAndKillsInItsRatio) {
  const auto world = world_with_tools(
      "importance = [ { depth_m = 2, value = 2.3 }, { depth_m = 5, value = 0.4 } ]");
  for (const auto& [before, after, ratio] :
       {std::tuple{1.0, 3.0, 2.3}, {3.0, 1.0, 1 / 2.3}, {3.0, 6.0, 0.4 / 2.3}, {3.0, 4.0, 1.0}}) {
    double photons = 0;
    constexpr int trials = 20000;
    for (int i = 0; i < trials; ++i) {
      ForwardTracks<double> t(world, {});
      t.place = {7, static_cast<std::uint64_t>(i), 4};
      t.photon.weight = 0.8;
      t.photon.position = {0, 0, -after};
      t.importance_before = importance_at(world.forward.tools, before);
      tally::Ledger ledger;
      const bool on = split(world, t, true, ledger);
      const int all = on ? 1 + t.copies : 0;
      ASSERT_NEAR(all * t.photon.weight + ledger.roulette, 0.8, 1e-14);
      ASSERT_NEAR(t.photon.weight, 0.8 / ratio, 1e-14);
      ASSERT_LE(std::abs(all - ratio), 1);
      photons += all;
    }
    EXPECT_NEAR(photons / trials, ratio, 4 * 0.5 / std::sqrt(trials)) << before << " to " << after;
  }
}

// Seen red: with the event, or the copy, left out of it.
TEST(Copies, DrawNumbersOfTheirOwn) {
  std::set<std::uint64_t> seen;
  int copies = 0;
  for (std::uint64_t photon : {0, 1, 2}) {
    for (int event = 1; event < 40; ++event) {
      for (int copy = 0; copy < 5; ++copy, ++copies) {
        const auto number = copy_number(7, photon, event, copy);
        EXPECT_GE(number, std::uint64_t{1} << 63);
        seen.insert(number);
        seen.insert(copy_number(7, number, event, copy));  // a copy's copy
      }
    }
  }
  EXPECT_EQ(seen.size(), 2U * static_cast<std::size_t>(copies));
}

}  // namespace
}  // namespace photic::estimator
