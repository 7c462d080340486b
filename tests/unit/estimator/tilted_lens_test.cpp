// Meetings right before a tilted lens in the water, of which some points are deeper than others;
// and rotations under tilted lasers.
#include <gtest/gtest.h>

#include "estimator/make_world.hpp"
#include "estimator/model.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "unit/estimator/lidars.hpp"
#include "unit/estimator/scores.hpp"

namespace photic::estimator {
namespace {

using test::Random;

// The laser's ray comes by close before a tilted lens or behind it, at depths where other points of
// the lens lie; the telescope's walk comes through one of these. Seen red: with first rays that
// begin no higher than where they were drawn, or higher by half of what may be; with rays that are
// met behind the lens.
TEST(StrategiesOfPath, BesideATiltedLensInTheWaterAgree) {
  Random random(110);
  int met = 0, behind = 0;
  const Sea sea(laser_at({0.5, 0, -3}, {0, 0, -1}), telescope_at({0, 0, -4}, {0.6, 0, -0.8}));
  const auto& telescope = sea.world.instruments.telescopes[0];
  const auto on_lens = [&] {
    return instrument::ring_point(0.05, 0.15, random.uniform(), random.uniform());
  };
  for (int n = 0; n < 400; ++n) {
    const V outward = instrument::outward(
        telescope, instrument::ring_point(0.0, 0.9, random.uniform(), random.uniform()));
    const double from_lens = random.between(-0.2, 0.3);
    Path path, drawn;
    path.lens = on_lens();
    path.vertex = {in_space(telescope, path.lens) + from_lens * outward};
    drawn.lens = on_lens();
    drawn.vertex = {in_space(telescope, drawn.lens) + outward};
    const StrategiesOfPath expected(sea.world, sea.medium, translating, path, max_vertices);
    const bool meets = from_lens > 0 && expected.translated(1) > 0;
    const double length =
        expected.group_path() - (from_lens > 0 ? 0 : 2 * expected.edge.back().path);
    const double scored =
        Scores(sea.world, translating, sea.medium, path, length).translated(1, drawn);
    EXPECT_NEAR(scored / expected.value(), meets ? 1 : 0, 1e-10) << n;
    met += meets;
    behind += from_lens < 0;
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(behind, 100);
}

// What walks draw about a tilted beam after a conversion changes if they are rotated. Seen red:
// with rotations wherever the laser looks.
TEST(Rotations, AreForNoTiltedLaserInWaterThatConverts) {
  const auto rotates = [](const std::string& direction, const std::string& channels) {
    auto scene =
        test::read(test::ship_instrument + channels + "[[sea.layer]]\nchlorophyll_mg_m3 = 1.0\n" +
                   test::depth_gates(16, 2) + test::simulation(1000, 1, "", "bidirectional"));
    if (direction == "tilted") scene.source.direction = {0.1, 0, -1};
    const Model model = make_model(scene, *test::tables());
    return make_world<double>(model).walks.uses.rotated;
  };
  const std::string elastic = test::channel("elastic");
  EXPECT_TRUE(rotates("upright", elastic));
  EXPECT_TRUE(rotates("tilted", elastic));
  EXPECT_TRUE(rotates("upright", elastic + test::channel("raman")));
  EXPECT_FALSE(rotates("tilted", elastic + test::channel("raman")));
}

}  // namespace
}  // namespace photic::estimator
