// What is straight between the sea surface and instruments on its other side.
#include "medium/outside_column.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Layer layer(double bottom_m, double a, double b) {
  scene::Layer out;
  out.bottom_depth_m = bottom_m;
  scene::IopEntry blue, red;
  blue.wavelength_nm = 400, blue.a_per_m = a, blue.b_per_m = b;
  red.wavelength_nm = 900, red.a_per_m = 2 * a, red.b_per_m = b;
  out.iop = {blue, red};
  return out;
}

// Through two layers, and as much deeper as the water of an environment is. Seen red: RED_MARK
TEST(OutsideColumn, OfWaterEndsAtADepth) {
  auto scene = scene_of({layer(2, 0.1, 0.3), layer(10, 0.5, 0.2)}, {test::channel_of(Process::elastic)});
  const auto darker = scene_of({layer(2, 0.2, 0.3), layer(10, 0.5, 0.25)}, {test::channel_of(Process::elastic)});
  scene.environment.push_back({"darker", {}, darker.optics, darker.sea});
  const Medium sea = medium_of(scene);
  const double across = column_to(sea, 3.5).optical_depth.front();
  EXPECT_NEAR(across, 2 * sea.c[0] + 1.5 * sea.c[1], 1e-12);
  EXPECT_NEAR(column_to(sea, 0.5).optical_depth.front(), 0.5 * sea.c[0], 1e-12);
  EXPECT_NEAR(column_to(sea, 3.5).delay_m.front(), (sea.line.front().group_index - 1) * 3.5, 1e-12);
  EXPECT_DOUBLE_EQ(column_to(sea, 4).per_metre, 0.25);
  const Medium other = medium_of(darker);
  const auto excess = excess_depths(sea, {3.5, -12});
  ASSERT_EQ(excess.size(), 2 * sea.line.size());
  EXPECT_NEAR(excess.front(), column_to(other, 3.5).optical_depth.front() - across, 1e-12);
  EXPECT_EQ(excess.back(), 0) << "in the air there is no water";
}

}  // namespace
}  // namespace photic::medium
