// Axes that the air bends.
#include "medium/bent_axis.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/constants.hpp"

namespace photic::medium {
namespace {

/// Air of an index that falls off by a height of 8 km, in layers of 100 m up to 100 km.
Air thin_air() {
  Air air;
  air.height_m.push_back(0);
  for (int k = 0; k < 1000; ++k) {
    air.height_m.push_back(100.0 * (k + 1));
    air.refractive_index.push_back(1 + 2.782e-4 * std::exp(-(100.0 * k + 50) / 8000));
    air.group_index.push_back(air.refractive_index.back());
  }
  return air;
}
/// Three layers that bend light much.
Air dense_air() {
  Air air;
  air.height_m = {0, 2, 5, 9};
  air.refractive_index = {1.3, 1.2, 1.1};
  air.group_index = {1.4, 1.25, 1.12};
  return air;
}

// From 705 km: how far axes meet the sea from where they would go straight, and by how much steeper
// they are there, in digits found by integration along the rays. The angles are those that a round
// earth makes of 0.1, 3, 15 and 30 degrees off nadir.
TEST(BentAxis, MeetsTheSeaAsideOfTheStraightOne) {
  struct Case {
    double incidence_deg, aside_m, steeper_urad;
  };
  const Air air = thin_air();
  for (const auto& [deg, aside, steeper] : {Case{0.11107, 0.0043, 0.54},
                                            {3.3323, 0.13, 16.2},
                                            {16.7059, 0.73, 83},
                                            {33.7334, 2.14, 186}}) {
    const double angle = deg * radian_per_degree;
    const auto bent = bent_axis(air, 705e3, std::cos(angle));
    EXPECT_NEAR(705e3 * std::tan(angle) - bent.aside_m, aside, 0.01 * aside) << deg;
    EXPECT_NEAR(1e6 * (angle - std::acos(bent.cosine)), steeper, 0.01 * steeper) << deg;
  }
}

/// Where a ray from an instrument at the origin's vertical meets the sea.
std::array<double, 2> meets_sea(const Air& air, double height, double x, double y) {
  const double sine = std::hypot(x, y);
  const double aside = bent_axis(air, height, std::sqrt(1 - sine * sine)).aside_m;
  return {aside * x / sine, aside * y / sine};
}

// The place, the direction and the group path follow from Snell's law layer by layer; the apparent
// distance and angle from neighbouring rays. Seen red: without the cosines' ratio; with the spread
// across for that along; with phase for group index.
TEST(BentAxis, SpreadsAsItsNeighboursDo) {
  const Air air = dense_air();
  for (const double height : {1.5, 7.0, 30.0})
    for (const double deg : {2.0, 20.0, 45.0}) {
      const double angle = deg * radian_per_degree, sine = std::sin(angle);
      const auto bent = bent_axis(air, height, std::cos(angle));
      const double index = height < 2 ? 1.3 : height < 9 ? 1.1 : 1.0;
      const double n[] = {1.3, 1.2, 1.1, 1.0}, group[] = {1.4, 1.25, 1.12, 1.0};
      const double top[] = {2, 5, 9, 1e9};
      double aside = 0, path = 0, length = 0, from = 0;
      for (int k = 0; k < 4 && from < height; from = top[k++]) {
        const double here = std::asin((height < 5 && height >= 2 ? 1.2 : index) * sine / n[k]);
        const double thick = std::min(height, top[k]) - from;
        aside += thick * std::tan(here);
        length += thick / std::cos(here);
        path += group[k] * thick / std::cos(here);
      }
      EXPECT_NEAR(bent.aside_m, aside, 1e-12 * height);
      EXPECT_NEAR(bent.length_m, length, 1e-12 * height);
      EXPECT_NEAR(bent.group_path_m, path, 1e-12 * height);
      EXPECT_NEAR(1.3 * std::sqrt(1 - bent.cosine * bent.cosine), index * sine, 1e-12);
      // Of a small cone of rays: what it fills of the sea.
      constexpr double small = 1e-4;
      const double cosine = std::cos(angle);
      const auto left = meets_sea(air, height, sine - small * cosine, 0),
                 right = meets_sea(air, height, sine + small * cosine, 0),
                 near = meets_sea(air, height, sine, -small),
                 far = meets_sea(air, height, sine, small);
      const double area = (right[0] - left[0]) * (far[1] - near[1]) / (4 * small * small);
      // A straight cone from the apparent distance fills as much.
      EXPECT_NEAR(area, std::pow(bent.apparent_distance_m * bent.apparent_angle, 2) / bent.cosine,
                  1e-5 * area)
          << height << ", " << deg;
    }
}

// Nothing is bent straight down, and in air of one index nowhere.
TEST(BentAxis, IsStraightDownOrInOneLayer) {
  const auto down = bent_axis(dense_air(), 7, 1);
  EXPECT_EQ(down.aside_m, 0);
  EXPECT_EQ(down.cosine, 1);
  EXPECT_NEAR(down.apparent_distance_m, 1.3 * (2 / 1.3 + 3 / 1.2 + 2 / 1.1), 1e-12);
  Air even = dense_air();
  even.refractive_index = {1.2, 1.2, 1.2};
  const auto straight = bent_axis(even, 8, std::cos(0.7));
  EXPECT_NEAR(straight.aside_m, 8 * std::tan(0.7), 1e-12);
  EXPECT_NEAR(straight.apparent_distance_m, 8 / std::cos(0.7), 1e-12);
  EXPECT_EQ(straight.apparent_angle, 1);
}

}  // namespace
}  // namespace photic::medium
