// Channels that have met the target rest while others go on (docs/decisions/0025).
#include <gtest/gtest.h>

#include "run/run.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

/// Without a target, if it is 0.
scene::Scene scene_of(std::uint64_t photons, double target) {
  return test::read(
      test::ship_instrument + test::channel("elastic") + test::channel("raman") +
      "[[sea.layer]]\nchlorophyll_mg_m3 = 0.5\n" + test::depth_gates(10, 2) +
      test::simulation(
          static_cast<double>(photons), 5,
          "max_order = 3\nwalk_attenuation = 0.6\n" + test::no_free_walks + "\n" +
              (target > 0 ? fmt::format("target_relative_error = {}", target) : std::string()),
          "bidirectional"));
}

tally::Result run_on(int threads, const scene::Scene& scene,
                     const tally::Result* earlier = nullptr) {
  RunOptions options;
  options.threads = threads;
  options.lanes = isas_here().back();
  if (earlier != nullptr)
    options.start = {.state = *earlier->state, .wall_time_s = 0, .file = "old.nc"};
  return run(scene, *test::tables(), options);
}

void expect_same(const tally::Result& a, const tally::Result& b) {
  EXPECT_EQ(a.state, b.state);
  EXPECT_EQ(a.echo.mean, b.echo.mean);
  EXPECT_EQ(a.channel_photons, b.channel_photons);
  EXPECT_EQ(a.collisions, b.collisions);
}

// Elastic light has met the target at the first look, after 32 batches of 2000 photons, and rests
// from the second on: its echo is that of 128 000 photons to the last bit. Seen red: with batches
// that rest as soon as they can, whose contents then depend on threads.
TEST(Target, OfAChannelThatHasMetItEndsThere) {
  constexpr double target = 0.002;
  const tally::Result once = run_on(1, scene_of(501'000, target));
  EXPECT_EQ(once.channel_photons, (std::vector<std::uint64_t>{128'000, 501'000}));
  expect_same(run_on(3, scene_of(501'000, target)), once);

  const tally::Result shorter = run_on(2, scene_of(128'000, 0));
  for (std::size_t gate = 0; gate < once.gates(); ++gate) {
    EXPECT_EQ(once.echo.mean[gate], shorter.echo.mean[gate]);
    EXPECT_EQ(once.echo.standard_error[gate], shorter.echo.standard_error[gate]);
  }
  EXPECT_LT(once.collisions, 501 * shorter.collisions / 128 * 19 / 20);

  for (const std::uint64_t earlier : {310'000U, 430'000U}) {
    const tally::Result first = run_on(2, scene_of(earlier, target));
    expect_same(run_on(2, scene_of(501'000, target), &first), once);
  }
  // What is asked for anew wakes it.
  const tally::Result longer = run_on(2, scene_of(600'000, 0), &once);
  EXPECT_EQ(longer.channel_photons, (std::vector<std::uint64_t>{228'000, 600'000}));
}

}  // namespace
}  // namespace photic::run
