// The random numbers of walks, drawn independently or spread over a batch.
#include "estimator/draws.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

World<double> world_with(const std::string& sampling) {
  using namespace test;
  const auto model =
      make_model(read(ship_instrument + channel("elastic") +
                      water(0.06, 0.1, "{ model = \"isotropic\" }") + depth_gates(10, 2) +
                      simulation(1e4, 5, "batch_photons = 2000\nsampling = \"" + sampling + "\"",
                                 "bidirectional")),
                 *test::tables());
  return make_world<double>(model);
}

constexpr std::uint32_t laser = 0, telescope = 1;

TEST(Draws, AreIndependentIfAskedTo) {
  const auto world = world_with("random");
  const Draws<double> draws{world.random, world.random.batch_photons, 4, telescope};
  EXPECT_EQ(draws(7, 1, 1),
            uniforms(RandomPlace<double>{world.random.key, world.random.batch_photons + 7, 1}, 5));
}

// Seen red: without the check, with the last telescopes drawing what facets do.
TEST(Draws, AreThereForAThousandTelescopes) {
  using namespace test;
  const auto with = [](int telescopes) {
    auto scene =
        read(ship_instrument + channel("elastic") + water(0.06, 0.1, "{ model = \"isotropic\" }") +
             depth_gates(10, 2) + simulation(1e4, 5, "", "bidirectional"));
    const auto first = scene.telescope.front();
    for (int i = 1; i < telescopes; ++i) {
      scene.telescope.push_back(first);
      scene.telescope.back().position_m.x += i;
    }
    return scene;
  };
  EXPECT_NO_THROW((void)make_model(with(1023), *test::tables()));
  EXPECT_THROW((void)make_model(with(1024), *test::tables()), InputError);
}

// Seen red: with photons of later batches at other points than those of the first.
TEST(Draws, OfAnyBatchFillTheirRange) {
  const auto world = world_with("quasi-random");
  for (const std::uint64_t batch : {0U, 3U}) {
    for (std::int32_t event = 0; event < 3; ++event) {
      for (std::size_t i = 0; i < 4; ++i) {
        std::set<int> cells;
        const Draws<double> draws{world.random, batch * world.random.batch_photons, 4, telescope};
        for (std::int32_t n = 0; n < 1024; ++n)
          cells.insert(static_cast<int>(1024 * draws(n, event, 1)[i]));
        EXPECT_EQ(cells.size(), 1024U) << batch << ", " << event << ", " << i;
      }
    }
  }
}

// Seen red: with the first slot left out.
TEST(Draws, OfOneEventTogetherAreThoseOfEach) {
  for (const char* sampling : {"quasi-random", "random"}) {
    const auto world = world_with(sampling);
    for (const std::uint32_t slot : {laser, telescope}) {
      const Draws<double> draws{world.random, 2 * world.random.batch_photons, 4, slot};
      for (std::int32_t event = 0; event < 5; ++event) {
        for (std::uint32_t block = 0; block < 5; ++block) {
          for (const std::int32_t n : {0, 1, 777, 1999})
            EXPECT_EQ(draws.together(n, event, block), draws(n, event, block))
                << sampling << " " << slot << " " << event << " " << block << " " << n;
        }
      }
    }
  }
}

// Where flags look at the tail of scores, and that has an end (decision 26).
TEST(Draws, OfTheForwardEstimatorAreSpreadWhereFlagsSuffice) {
  using namespace test;
  const auto spreads = [](const std::string& instrument, const std::string& estimator,
                          bool with_environment) {
    auto scene =
        read(instrument + channel("elastic") + water(0.06, 0.1, "{ model = \"isotropic\" }") +
             depth_gates(10, 2) + simulation(1e4, 5, "", estimator));
    if (with_environment) scene.environment.push_back({"same", {}, scene.optics, scene.sea});
    return spreads_evenly(scene);
  };
  EXPECT_TRUE(spreads(ship_instrument, "forward", false));
  EXPECT_FALSE(spreads(ship_instrument, "forward", true));
  EXPECT_FALSE(spreads(ship_instrument + submerged_telescope, "forward", false));
  EXPECT_FALSE(spreads(ship_instrument, "analog", false));
  EXPECT_TRUE(spreads(ship_instrument + submerged_telescope, "bidirectional", true));
}

// Where the laser's light leaves: one photon in each of 32 x 32 cells. Seen red: with one
// coordinate for all four numbers.
TEST(Draws, FillTheLasersDisc) {
  const auto world = world_with("quasi-random");
  std::set<std::pair<int, int>> cells;
  const Draws<double> draws{world.random, 0, 0, laser};
  for (std::int32_t n = 0; n < 1024; ++n) {
    const auto u = draws(n, 0, 0);
    cells.emplace(static_cast<int>(32 * u[0]), static_cast<int>(32 * u[1]));
  }
  EXPECT_EQ(cells.size(), 1024U);
}

// Seen red: with keys that do not know the batch, the event or the block; with one key for all four
// numbers.
TEST(Draws, OfBatchesEventsAndBlocksDiffer) {
  const auto world = world_with("quasi-random");
  std::set<double> seen;
  std::size_t drawn = 0;
  const auto note = [&](const Draws<double>& draws, std::uint32_t block) {
    for (std::int32_t event = 0; event < 5; ++event) {
      for (const double u : draws(0, event, block)) {
        seen.insert(u);
        ++drawn;
      }
    }
  };
  for (const std::uint64_t photon :
       {std::uint64_t{0}, world.random.batch_photons, 2 * world.random.batch_photons}) {
    note({world.random, photon, 0, laser}, 0);
    for (const std::uint32_t receiver : {0U, 1U}) {
      note({world.random, photon, 4 + 4 * receiver, telescope}, 0);
      note({world.random, photon, 4 + 4 * receiver, telescope}, 1);
    }
  }
  EXPECT_EQ(seen.size(), drawn);
}

TEST(Draws, OfLaterEventsAreIndependent) {
  const auto world = world_with("quasi-random");
  const Draws<double> draws{world.random, 0, 0, laser};
  EXPECT_EQ(draws(7, 3, 0), uniforms(RandomPlace<double>{world.random.key, 7, 3}, 0));
}

}  // namespace
}  // namespace photic::estimator
