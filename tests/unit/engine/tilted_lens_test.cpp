// Meetings right before a tilted lens in the water, of which some points are deeper than others.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "unit/engine/lidars.hpp"
#include "unit/engine/scores.hpp"

namespace photic::engine {
namespace {

using test::Random;

// The laser's ray comes by close before a tilted lens or behind it, at depths where other points of
// the lens lie; the telescope's walk comes through one of these. Seen red: with first rays that
// begin no higher than where they were drawn, or higher by half of what may be; with rays that are
// met behind the lens.
TEST(Strategies, BesideATiltedLensInTheWaterAgree) {
  Random random(110);
  int met = 0, behind = 0;
  const Sea sea(laser_at({0.5, 0, -3}, {0, 0, -1}), telescope_at({0, 0, -4}, {0.6, 0, -0.8}));
  const auto& telescope = sea.world.telescopes[0];
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
    const Strategies expected(sea.world, sea.medium, shifted, path, most_vertices);
    const bool meets = from_lens > 0 && expected.meeting(1) > 0;
    const double length =
        expected.group_path() - (from_lens > 0 ? 0 : 2 * expected.edge.back().path);
    const double scored = Scores(sea.world, shifted, sea.medium, path, length).meeting(1, drawn);
    EXPECT_NEAR(scored / expected.value(), meets ? 1 : 0, 1e-10) << n;
    met += meets;
    behind += from_lens < 0;
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(behind, 100);
}

}  // namespace
}  // namespace photic::engine
