// The photons of a batch, and the numbers of batches after which the target is looked at.
#include <gtest/gtest.h>

#include "estimator/model.hpp"
#include "run/batches.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

scene::Simulation simulation_of(scene::Estimator estimator, std::optional<std::uint64_t> photons) {
  scene::Simulation s;
  s.estimator = estimator;
  s.photons = photons;
  return s;
}

// Seen red: with 39 batches enough; without the smallest; with as many for walks.
TEST(BatchPhotons, AreTheMostOfWhichTheRunHoldsFortyBatches) {
  struct Case {
    std::optional<std::uint64_t> asked;
    std::uint64_t forward, bidirectional;
  };
  for (const auto& [asked, forward, bidirectional] :
       {Case{std::nullopt, 8000, 2000}, Case{320'000, 8000, 2000}, Case{319'999, 4000, 2000},
        Case{130'000, 2000, 2000}, Case{100'000, 2000, 2000}, Case{79'999, 1000, 1000},
        Case{20'000, 500, 500}, Case{10'000, 250, 250}, Case{9'999, 250, 250}, Case{1, 250, 250}}) {
    SCOPED_TRACE(asked.value_or(0));
    using scene::Estimator;
    EXPECT_EQ(estimator::batch_photons(simulation_of(Estimator::forward, asked)), forward);
    EXPECT_EQ(estimator::batch_photons(simulation_of(Estimator::analog, asked)), forward);
    EXPECT_EQ(estimator::batch_photons(simulation_of(Estimator::bidirectional, asked)),
              bidirectional);
  }
}

// Seen red: without the scene's own number.
TEST(BatchPhotons, AreThoseThatASceneAsksFor) {
  auto s = simulation_of(scene::Estimator::bidirectional, 1'000'000);
  s.batch_photons = 8000;
  EXPECT_EQ(estimator::batch_photons(s), 8000U);
}

// Gates of a short run may be unflagged: 30 batches at least are in it.
TEST(BatchPhotons, AreInTheEffectiveScene) {
  const auto batches = [](double photons) {
    return run(test::read(test::ship_instrument + test::channel("elastic") +
                          "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n" + test::depth_gates(10, 2) +
                          test::simulation(photons, 5, "max_order = 3\n", "forward")),
               *test::tables());
  };
  const tally::Result result = batches(20'000);
  EXPECT_EQ(result.batches, 40U);
  EXPECT_NE(result.scene_toml.find("batch_photons = 500"), std::string::npos) << result.scene_toml;
}

// Rows rest as a look has found from the next one on: batches up to the look after that may begin.
// Seen red: with looks every 32 batches; with none at 64.
TEST(RunControl, LooksAfter32BatchesThenAfterTwiceAsManyThenEvery128) {
  auto s = simulation_of(scene::Estimator::bidirectional, {});
  s.target_relative_error = 0.02;
  const RunOptions options;
  const RunControl control(s, options);
  struct Case {
    std::uint64_t merged, known_until;
  };
  for (const auto& [merged, known_until] :
       {Case{0, 64}, Case{31, 64}, Case{32, 128}, Case{63, 128}, Case{64, 256}, Case{127, 256},
        Case{128, 384}, Case{255, 384}, Case{256, 512}})
    EXPECT_EQ(control.known_until(merged), known_until) << merged << " batches";
}

// Seen red: with a look at 48 batches.
TEST(RunControl, EndsAtTheFirstLookThatFindsTheTargetMet) {
  const auto photons_to = [](const std::string& target) {
    const auto result =
        run(test::read(test::ship_instrument + test::channel("elastic") +
                       "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n" + test::depth_gates(4, 2) +
                       test::simulation(1e9, 5, "target_relative_error = " + target + "\n",
                                        "bidirectional")),
            *test::tables());
    EXPECT_EQ(result.stopped_by, "target");
    return result.photons;
  };
  EXPECT_EQ(photons_to("0.5"), 32U * 2000);
  const auto later = photons_to("0.0008");
  EXPECT_TRUE(later == 64 * 2000 || later % (128 * 2000) == 0) << later;
}

}  // namespace
}  // namespace photic::run
