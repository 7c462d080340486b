// Gates by depth and by time.
#include "tally/gates.hpp"

#include <gtest/gtest.h>

#include "core/constants.hpp"
#include "support/random.hpp"
#include "support/slant_path.hpp"
#include "unit/tally/lines.hpp"

namespace photic::tally {
namespace {

scene::Scene with_depth_gates(double min, double max, double step) {
  scene::Scene scene = test::ship_scene();
  scene.gates.depth_m = {min, max, step};
  return scene;
}

/// An instrument at a height, tilted towards +x.
template <class Instrument>
void put(Instrument& instrument, double z, double tilt_deg) {
  const double tilt = tilt_deg * radian_per_degree;
  instrument.position_m = {0, 0, z};
  instrument.direction = {3 * std::sin(tilt), 0, -3 * std::cos(tilt)};  // need not be normalised
}

// t = 2 H / c0 + 2 n_g z / c0. Seen red: with the phase for the group index; with the way out
// counted twice.
TEST(DepthGates, AreTimesToTheDepthAndBack) {
  const Gates gates(test::ship_scene(), lines());
  ASSERT_EQ(gates.count(), 100);
  for (std::int32_t edge = 0; edge <= 100; ++edge) {
    const double z = 0.5 * edge;
    const double seconds = 2 * 12 / speed_of_light_m_s + 2 * 1.3638 * z / speed_of_light_m_s;
    EXPECT_NEAR(gates.edge_path(edge) / speed_of_light_m_s, seconds, 1e-20) << z;
    EXPECT_NEAR(gates.depth(gates.edge_path(edge), 0, lines()[0]), z, 1e-12);
  }
  EXPECT_NEAR(gates.edge_path(40) / metre_per_nanosecond, 262.0213, 1e-4);  // 20 m
  EXPECT_FALSE(gates.depth_is_range());
}

TEST(DepthGates, CountTheHeightsOfSourceAndTelescopeApart) {
  auto scene = test::ship_scene();
  scene.source.position_m = {3, 0, 10};
  scene.telescope[0].position_m = {0, 0, 25};
  EXPECT_NEAR(Gates(scene, lines()).edge_path(100), 35 + 2 * 1.3638 * 50, 1e-10);
  scene.telescope[0].position_m.z = -4;  // below the surface the way back ends earlier
  EXPECT_NEAR(Gates(scene, lines()).edge_path(100), 10 + 1.3638 * 50 + 1.3638 * 46, 1e-10);
}

TEST(DepthGates, HaveTheirBoundsAsAsked) {
  for (const auto& [min, max, step] :
       {std::tuple{0.0, 50.0, 0.5}, {0.0, 50.2, 0.5}, {-3.0, 7.0, 0.1}, {5.0, 6.0, 3.0}}) {
    const Gates gates(with_depth_gates(min, max, step), lines());
    EXPECT_EQ(gates.count(), std::lround(std::ceil((max - min) / step - 1e-6)));
    EXPECT_NEAR(gates.depth(gates.edge_path(0), 0, lines()[0]), min, 1e-12);
    EXPECT_NEAR(gates.depth(gates.last_path(), 0, lines()[0]), max, 1e-12);
  }
}

// Raman light of the same time comes from deeper: (n_L + n_R) z_R = 2 n_L z. Seen red: with the
// laser's group index both ways.
TEST(DepthGates, AreDeeperForLightThatReturnsFaster) {
  const Gates gates(test::ship_scene(), lines());
  const double path = gates.last_path();
  EXPECT_NEAR(gates.depth(path, 0, lines()[1]), 50 * 2 * 1.3638 / (1.3638 + 1.3541), 1e-12);
  EXPECT_NEAR(gates.depth(path, 0, lines()[1]) - 50, 0.2, 0.05);
  EXPECT_NEAR(gates.depth(path, 0, lines()[2]), 50 * 2 * 1.3638 / (1.3638 + 1.3525), 1e-12);
  EXPECT_NEAR(gates.depth(24, 0, lines()[1]), 0, 1e-12);  // at the surface they agree
  EXPECT_NEAR(gates.depth(20, 0, lines()[1]), -2, 1e-12);
}

// Seen red: with the group index above the surface too.
TEST(DepthGates, LieInTheAirWhereNegative) {
  const Gates gates(with_depth_gates(-5, 5, 1), lines());
  EXPECT_NEAR(gates.edge_path(0), 14, 1e-12);
  EXPECT_NEAR(gates.edge_path(4), 22, 1e-12);
  EXPECT_NEAR(gates.edge_path(5), 24, 1e-12);
  EXPECT_NEAR(gates.edge_path(6), 24 + 2 * 1.3638, 1e-12);
}

/// Of depth gates -0.3 … 0.3 by 0.1 m of the ship's lidar at a height, tilted so far.
void expect_depths_as_asked(double height, double tilt_deg, const std::vector<medium::Line>& in) {
  auto scene = with_depth_gates(-0.3, 0.3, 0.1);
  put(scene.source, height, tilt_deg);
  put(scene.telescope[0], height, tilt_deg);
  const Gates gates(scene, in);
  for (std::int32_t edge = 0; edge <= 6; ++edge) {
    const double depth = gates.edge_depth(edge, 0, in[0]);
    EXPECT_EQ(depth, (edge - 3) / 10.0) << height << " m, " << tilt_deg << " degrees";
    EXPECT_FALSE(edge == 3 && std::signbit(depth));
    EXPECT_EQ(depth + gates.edge_depth(6 - edge, 0, in[0]), 0);  // the middle of a gate about 0
  }
}

// Paths round: of 24 m to 4e-15, of those from 705 km to 2e-10. Seen red: with depth() of the
// edge's path, 2e-16 or -1e-10 for 0; with digits for 24 m from everywhere.
TEST(DepthGates, AreGivenWithoutTheRoundingOfPaths) {
  for (const double height : {0.3, 12.0, 11.7, 300.0, 9000.0, 705e3})
    for (const double tilt : {0.0, 15.0, 40.0})
      for (const auto& in : {lines(), lines_in_air()}) expect_depths_as_asked(height, tilt, in);
}

// Of other light the depths are no decimals. Seen red: rounded to millimetres.
TEST(DepthGates, AreGivenInAllTheirDigits) {
  const Gates gates(with_depth_gates(-5, 5, 1), lines());
  for (std::int32_t edge = 0; edge <= 10; ++edge)
    EXPECT_NEAR(gates.edge_depth(edge, 0, lines()[1]),
                gates.depth(gates.edge_path(edge), 0, lines()[1]), 1e-12);
  auto up = test::ship_scene();
  put(up.telescope[0], -3, 180);
  up.gates = {};
  up.gates.time_ns = {0, 100, 10};
  EXPECT_NEAR(Gates(up, lines()).edge_depth(10, 0, lines()[0]),
              Gates(up, lines()).depth(100 * metre_per_nanosecond, 0, lines()[0]), 1e-12);
}

// Where the gates begin at the laser their time does, too. Seen red: with the path over the speed;
// without the sum that makes 0 of -0.
TEST(Gates, HaveTimesWithoutTheRoundingOfPaths) {
  scene::Scene scene;
  for (int i = 1; i <= 100; ++i) {
    const double height = 0.37 * i;
    scene = with_depth_gates(-height, 5, 0.1);
    put(scene.source, height, 15);
    put(scene.telescope[0], height, 25);
    const double time = Gates(scene, lines()).edge_time_ns(0);
    EXPECT_EQ(time, 0) << height;
    EXPECT_FALSE(std::signbit(time)) << height;
  }
  scene.gates = {};
  scene.gates.time_ns = {80, 500, 2};
  const Gates gates(scene, lines());
  for (std::int32_t edge = 0; edge <= gates.count(); ++edge)
    EXPECT_EQ(gates.edge_time_ns(edge), 80 + 2 * edge);
}

// Whatever the gates, a path lies in the one gate between whose edges it is. Seen red: with find()
// counting from gate 1.
void finds_what_lies_between_edges(const Gates& gates) {
  test::Random random(1);
  for (std::int32_t gate = 0; gate < gates.count(); ++gate) {
    const double from = gates.edge_path(gate);
    const double to = gates.edge_path(gate + 1);
    ASSERT_LT(from, to);
    for (int i = 0; i < 20; ++i)
      ASSERT_EQ(gates.find(random.between(from + 1e-9, to - 1e-9)), gate);
  }
  EXPECT_EQ(gates.find(gates.edge_path(0) - 1e-9), -1);
  EXPECT_EQ(gates.find(gates.last_path() + 1e-9), -1);
  EXPECT_EQ(gates.find(-1.0), -1);
  EXPECT_EQ(gates.find(1e30), -1);
  EXPECT_EQ(gates.find(std::numeric_limits<double>::infinity()), -1);
}

TEST(Gates, FindWhatLiesBetweenTheirEdges) {
  finds_what_lies_between_edges(Gates(test::ship_scene(), lines()));
  finds_what_lies_between_edges(Gates(with_depth_gates(-5, 7.3, 0.4), lines()));
  auto scene = test::ship_scene();
  scene.gates = {};
  scene.gates.time_ns = {80, 500, 2};
  finds_what_lies_between_edges(Gates(scene, lines()));
  scene.gates = {};
  scene.gates.range_m = {3, 60, 0.7};
  scene.telescope[0].direction = {0.5, 0, -1};
  finds_what_lies_between_edges(Gates(scene, lines()));
  finds_what_lies_between_edges(Gates(scene, lines_in_air()));
  scene.telescope[0].direction = {0.5, 0, 1};
  finds_what_lies_between_edges(Gates(scene, lines_in_air()));
  finds_what_lies_between_edges(Gates(with_depth_gates(-11.7, 7.3, 0.4), lines_in_air()));
}

/// A metre of air counts as 1.3 below 2 m, as 1.1 below 5 m and as 1.02 below 9 m; of line 1, as
/// 1.4, 1.2 and 1.
double delay_to(double height, bool of_line_1) {
  const double low = std::min(height, 2.0), middle = std::clamp(height - 2, 0.0, 3.0),
               high = std::clamp(height - 5, 0.0, 4.0);
  return of_line_1 ? 0.4 * low + 0.2 * middle : 0.3 * low + 0.1 * middle + 0.02 * high;
}

// Heights in the air between the sea and the instruments, straight or aslant. Seen red: with the
// delay of line 0 for all; without the bends at the layers' edges.
TEST(DepthGates, AreHeightsInAirOfAnyGroupIndex) {
  auto scene = with_depth_gates(-11.5, 10, 0.5);
  put(scene.telescope[0], 11.8, 30);
  put(scene.source, 12, 10);
  const Gates gates(scene, lines_in_air());
  const double out = 1 / std::cos(10 * radian_per_degree),
               home = 1 / std::cos(30 * radian_per_degree);
  for (const bool raman : {false, true}) {
    const auto back = lines_in_air()[raman];
    for (double depth = -11.5; depth < 10; depth += 0.5) {
      const double height = std::max(0.0, -depth);
      const double path =
          test::slant_path(scene.source, scene.telescope[0], lines()[0], lines()[raman], depth) +
          (delay_to(12, false) - delay_to(height, false)) * out +
          (delay_to(11.8, raman) - delay_to(height, raman)) * home;
      EXPECT_NEAR(gates.depth(path, 0, back), depth, 1e-9) << raman;
      if (!raman) {
        EXPECT_EQ(gates.find(path + 1e-9), static_cast<int>(std::lround((depth + 11.5) * 2)));
      }
    }
  }
}

// Seen red: with bends before the surface where the axis looks up.
TEST(RangeGates, KnowTheAirTheyLookInto) {
  scene::Scene scene = test::ship_scene();
  scene.gates = {};
  scene.gates.range_m = {0, 20, 0.5};
  for (const double rise : {-0.8, 0.0, 0.6}) {
    scene.source.position_m = scene.telescope[0].position_m = {0, 0, rise < 0 ? 12.0 : 3.0};
    scene.source.direction = scene.telescope[0].direction = {std::sqrt(1 - rise * rise), 0, rise};
    const Gates gates(scene, lines_in_air());
    const double from = scene.source.position_m.z;
    for (std::int32_t edge = 0; edge < 30; ++edge) {
      const double range = 0.5 * edge, height = from + range * rise;
      const double delay =
          rise == 0 ? 0.1 * range : (delay_to(height, false) - delay_to(from, false)) / rise;
      EXPECT_NEAR(gates.edge_path(edge), 2 * (range + delay), 1e-9) << rise << ", " << range;
    }
  }
}

TEST(TimeGates, AreTimes) {
  auto scene = test::ship_scene();
  scene.gates = {};
  scene.gates.time_ns = {100, 500, 10};
  const Gates gates(scene, lines());
  ASSERT_EQ(gates.count(), 40);
  EXPECT_NEAR(gates.edge_path(0), 29.9792458, 1e-10);
  EXPECT_NEAR(gates.edge_path(40), 149.896229, 1e-10);
  // An instrument that looks down returns the depth that belongs to a time.
  EXPECT_FALSE(gates.depth_is_range());
  EXPECT_NEAR(gates.depth(149.896229, 0, lines()[0]), (149.896229 - 24) / 2 / 1.3638, 1e-9);
  scene.telescope[0].direction = {1, 0, -0.9};
  EXPECT_TRUE(Gates(scene, lines()).depth_is_range());
}

// Along both axes, each refracted by its own angle and wavelength; in the air, in the water, and
// one in each. Seen red: with heights for slant ways; with the angles in air below the surface;
// with the telescope's angle for the laser's; with the laser's index for the light's on its way
// home.
TEST(DepthGates, OfTiltedInstrumentsFollowTheirRefractedAxes) {
  for (const auto& [laser_z, laser_deg, telescope_z, telescope_deg] :
       {std::tuple{300.0, 20.0, 300.0, 20.0},
        {300.0, 80.0, 300.0, 80.0},
        {12.0, 0.0, 30.0, 45.0},
        {12.0, 45.0, 12.0, 0.0},
        {-2.0, 30.0, -3.0, 50.0},
        {12.0, 20.0, -4.0, 35.0}}) {
    auto scene = with_depth_gates(telescope_z < 0 ? 4 : -6, 20, 0.5);
    put(scene.source, laser_z, laser_deg);
    put(scene.telescope[0], telescope_z, telescope_deg);
    const Gates gates(scene, lines());
    EXPECT_FALSE(gates.depth_is_range());
    const auto path = [&](double depth, const medium::Line& back) {
      return test::slant_path(scene.source, scene.telescope[0], lines()[0], back, depth);
    };
    for (std::int32_t edge = 0; edge <= gates.count(); ++edge) {
      const double depth = scene.gates.depth_m->min + 0.5 * edge;
      EXPECT_NEAR(gates.edge_path(edge), path(depth, lines()[0]), 1e-9) << depth;
      EXPECT_NEAR(gates.depth(path(depth, lines()[0]), 0, lines()[0]), depth, 1e-9);
      EXPECT_NEAR(gates.depth(path(depth, lines()[1]), 0, lines()[1]), depth, 1e-9);
    }
  }
}

// Light from the surface of a lidar at 300 m and 20 degrees comes in the gate that begins at 0.
// Seen red: timed as if it looked straight down, where it comes 14.4 m later.
TEST(DepthGates, OfATiltedLidarBeginWhereItsLightMeetsTheSea) {
  auto scene = with_depth_gates(0, 40, 1);
  put(scene.source, 300, 20);
  put(scene.telescope[0], 300, 20);
  const Gates gates(scene, lines());
  EXPECT_NEAR(gates.edge_path(0), 2 * 300 / std::cos(20 * radian_per_degree), 1e-9);
  EXPECT_EQ(gates.find(2 * 300 / std::cos(20 * radian_per_degree) + 1e-6), 0);
}

// One grid of times, and in each telescope depths of its own. Seen red: with those of the first.
TEST(DepthGates, StandForDepthsOfTheirOwnInEachTelescope) {
  auto scene = with_depth_gates(0, 20, 0.5);
  scene.telescope.resize(4, scene.telescope[0]);
  put(scene.telescope[1], 30, 0);
  put(scene.telescope[2], 12, 40);
  put(scene.telescope[3], -3, 120);  // looks up
  const Gates gates(scene, lines());
  const auto path_of = [&](double depth, std::size_t telescope, const medium::Line& back) {
    return test::slant_path(scene.source, scene.telescope[telescope], lines()[0], back, depth);
  };
  EXPECT_NEAR(gates.edge_path(10), path_of(5, 0, lines()[0]), 1e-9);
  // Higher by 18 m: what is 7 m deep for the first lies 0.40 m deep for this one.
  const double path = path_of(7, 0, lines()[0]);
  EXPECT_NEAR(gates.depth(path, 1, lines()[0]), 7 - 18 / (2 * 1.3638), 1e-9);
  EXPECT_NEAR(gates.depth(path, 1, lines()[0]), 0.40, 0.005);
  EXPECT_NEAR(gates.depth(path_of(7, 2, lines()[1]), 2, lines()[1]), 7, 1e-9);
  EXPECT_TRUE(std::isnan(gates.depth(path, 3, lines()[0])));
}

// The water that the gates stand for, of all telescopes. Seen red: with those of the first one
// alone; with depths in the air.
TEST(DepthGates, TallyTheLastScatteringOnAGridOfItsOwn) {
  auto scene = with_depth_gates(-5, 20, 0.5);
  const auto edges = Gates(scene, lines()).depth_edges(40);
  ASSERT_EQ(edges.size(), 41U);
  for (std::size_t i = 0; i < edges.size(); ++i)
    EXPECT_NEAR(edges[i], 0.5 * static_cast<double>(i), 1e-12);
  scene.telescope.push_back(scene.telescope[0]);
  put(scene.telescope[1], 6, 0);
  EXPECT_NEAR(Gates(scene, lines()).depth_edges(1).back(), 20 + 6 / (2 * 1.3638), 1e-9);
  EXPECT_TRUE(Gates(scene, lines()).depth_edges(0).empty());
}

}  // namespace
}  // namespace photic::tally
