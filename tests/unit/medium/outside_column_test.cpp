// Columns straight between the sea surface and instruments outside a medium.
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

// Through two layers, and as much deeper as the water of each environment is, for every line. Seen
// red: with the upper layer's water all the way; with the rows of an environment for those of a
// line.
TEST(OutsideColumn, OfWaterEndsAtADepth) {
  auto scene = scene_of({layer(2, 0.1, 0.3), layer(10, 0.5, 0.2)}, all_channels);
  const auto darker = scene_of({layer(2, 0.2, 0.3), layer(10, 0.5, 0.25)}, all_channels),
             clearer = scene_of({layer(2, 0.1, 0.2), layer(10, 0.3, 0.2)}, all_channels);
  for (const auto& other : {darker, clearer})
    scene.environment.push_back({"other", {}, other.optics, other.sea});
  const Medium sea = medium_of(scene);
  const std::size_t lines = sea.line.size(), layers = 2;
  const auto column = column_to(sea, 3.5);
  EXPECT_DOUBLE_EQ(column_to(sea, 4).per_metre, 0.25);
  const auto excess = excess_depths(sea, {3.5, -12});
  ASSERT_EQ(excess.size(), 2 * 2 * lines);
  for (std::size_t l = 0; l < lines; ++l) {
    SCOPED_TRACE(l);
    const double here = column.optical_depth[l];
    EXPECT_NEAR(here, 2 * sea.c[l * layers] + 1.5 * sea.c[l * layers + 1], 1e-12);
    EXPECT_NEAR(column_to(sea, 0.5).optical_depth[l], 0.5 * sea.c[l * layers], 1e-12);
    EXPECT_NEAR(column.delay_m[l], (sea.line[l].group_index - 1) * 3.5, 1e-12);
    std::size_t e = 0;
    for (const auto& other : {darker, clearer}) {
      EXPECT_NEAR(excess[2 * e * lines + l],
                  column_to(medium_of(other), 3.5).optical_depth[l] - here, 1e-12);
      EXPECT_EQ(excess[(2 * e + 1) * lines + l], 0) << "in the air there is no water";
      ++e;
    }
  }
}

}  // namespace
}  // namespace photic::medium
