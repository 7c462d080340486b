// Scores of flights in irradiances and fluences, against steps along them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimator/tallies/fluence.hpp"
#include "estimator/tallies/irradiance.hpp"
#include "unit/estimator/tally_flights.hpp"

namespace photic::estimator {
namespace {

/// One level in a vacuum above the bed: plane and scalar, away and towards the surface.
std::vector<double> at_level(const transport::Sea& sea, double level, double slab_m,
                             const std::vector<Flight>& flights, bool in_vacuum = true) {
  tally::TallyScores scores(4);
  const Irradiance irradiance({{0, level, slab_m}},
                              in_vacuum ? ContinuousAbsorption() : ContinuousAbsorption(sea.view()),
                              bed_of_flights_m, {0, 1}, {2, 3});
  for (Flight flight : flights) {
    if (in_vacuum) flight.layer = 0;
    irradiance.add(flight, scores);
  }
  return scored_in(scores);
}

// Light that ends at a level and sets out from there passes it once, if it goes on; what turns back
// from above has not passed it, and what turns back from below has, both ways. Seen red: with
// levels that count at both ends of flights.
TEST(TalliedFlights, PassLevelsOnce) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  const Flight down_to = between_depths(sea, 1, 3), down_from = between_depths(sea, 3, 6);
  const Flight up_to = between_depths(sea, 6, 3), up_from = between_depths(sea, 3, 1);
  const auto down = at_level(sea, 3, 1, {down_to, down_from});
  EXPECT_EQ(down[0], 1);
  EXPECT_EQ(down[2], 0);
  const auto up = at_level(sea, 3, 1, {up_to, up_from});
  EXPECT_EQ(up[0], 0);
  EXPECT_EQ(up[2], 1);
  const auto turned_from_above = at_level(sea, 3, 1, {down_to, up_from});
  EXPECT_EQ(turned_from_above[0] + turned_from_above[2], 0);
  const auto turned_from_below = at_level(sea, 3, 1, {up_to, down_from});
  EXPECT_EQ(turned_from_below[0], 1);
  EXPECT_EQ(turned_from_below[2], 1);
}

// Levels at the surface and at the bed are passed by light that begins or ends there. Seen red:
// without the step off the bed.
TEST(TalliedFlights, PassLevelsAtTheEnds) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  const Flight down = between_depths(sea, 0, bed_of_flights_m),
               up = between_depths(sea, bed_of_flights_m, 0);
  const ContinuousAbsorption absorption(sea.view());
  for (const double level : {0.0, bed_of_flights_m}) {
    const auto scores = at_level(sea, level, 0.5, {down, up}, false);
    EXPECT_NEAR(scores[0], absorption.weight_at(down, level), 1e-5) << level;
    EXPECT_NEAR(scores[2], absorption.weight_at(up, level), 1e-5) << level;
    // Their slabs are cut there: light straight down has the same scalar irradiance.
    EXPECT_NEAR(scores[1], scores[0], 0.02 * scores[0]) << level;
    EXPECT_NEAR(scores[3], scores[2], 0.02 * scores[2]) << level;
  }
}

// Slabs end at layers' edges, of which each belongs to the layer below. Seen red: with slabs that
// go on into the next layer.
TEST(TalliedFlights, CutSlabsAtLayers) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  const ContinuousAbsorption absorption(sea.view());
  for (const auto& [level, begin, end] :
       {std::array{5.0, 5.0, 5.5}, {4.8, 4.3, 5.0}, {5.3, 5.0, 5.8}, {8.0, 7.5, 8.5}}) {
    const Flight down = between_depths(sea, 0, bed_of_flights_m);
    double track = 0;
    constexpr int steps = 140000;
    each_step(absorption, down, steps,
              [&](std::size_t, const auto&, double at, double weight, double step) {
                if (at >= begin && at < end) track += weight * step / (end - begin);
              });
    const auto scores = at_level(sea, level, 1, {down}, false);
    EXPECT_NEAR(scores[1], track, 1e-6) << level;
    EXPECT_NEAR(scores[0], absorption.weight_at(down, level), 1e-12) << level;
  }
}

// Aslant the path is longer; level flights pass no level, but have a path in its slab.
TEST(TalliedFlights, HaveLongerPathsAslant) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  const double sine = std::sqrt(0.75);
  const auto aslant = at_level(sea, 3, 1, {flight_through(sea, {0, 0, -1}, {sine, 0, -0.5}, 10)});
  EXPECT_EQ(aslant[0], 1);
  EXPECT_NEAR(aslant[1], 2, 1e-12);
  const auto level = at_level(sea, 3, 1, {flight_through(sea, {0, 0, -3.2}, {1, 0, 0}, 7)});
  EXPECT_EQ(level[0] + level[2], 0);
  EXPECT_NEAR(level[1] + level[3], 7, 1e-12);
  const auto outside = at_level(sea, 3, 1, {flight_through(sea, {0, 0, -3.6}, {1, 0, 0}, 7)});
  EXPECT_EQ(outside[1] + outside[3], 0);
}

/// The cell of a point, or none: -1.
int cell_by_geometry(const Fluence::Edges& edges, const Vec3<double>& axis,
                     const Vec3<double>& point, double distance) {
  const double aside = edges.rings ? std::hypot(point.x - axis.x, point.y - axis.y) : point.x;
  const auto between = [](const std::vector<double>& list, double x) {
    for (std::size_t i = 0; i + 1 < list.size(); ++i)
      if (x >= std::min(list[i], list[i + 1]) && x < std::max(list[i], list[i + 1]))
        return static_cast<int>(i);
    return -1;
  };
  const int row = between(edges.distance, distance), column = between(edges.aside, aside);
  return row < 0 || column < 0 ? -1 : row * static_cast<int>(edges.aside.size() - 1) + column;
}

/// Random flights through a grid against steps along them.
void expect_paths_by_steps(const transport::Sea& sea, const Fluence::Edges& edges,
                           int least = 300) {
  const Vec3<double> axis = edges.rings ? Vec3<double>{0.5, -1, 0} : Vec3<double>{};
  const ContinuousAbsorption absorption(sea.view());
  const Fluence fluence(edges, axis, absorption, 0);
  const std::size_t cells = (edges.distance.size() - 1) * (edges.aside.size() - 1);
  test::Random random(5);
  int within = 0;
  for (int i = 0; i < 300; ++i) {
    const Flight flight = random_flight(sea, random);
    tally::TallyScores scores(cells);
    fluence.add(flight, scores);
    std::vector<double> by_steps(cells);
    constexpr int steps = 4000;
    each_step(absorption, flight, steps,
              [&](std::size_t, const auto& point, double at, double weight, double step) {
                const int cell = cell_by_geometry(edges, axis, point, at);
                if (cell >= 0) by_steps[static_cast<std::size_t>(cell)] += weight * step;
              });
    const auto scored = scored_in(scores);
    const double greatest = absorption.weight_at(flight, flight.to);
    for (std::size_t k = 0; k < cells; ++k) {
      // A step is in a cell or not, at each of its ends.
      const double step = flight.length / steps;
      const double tolerance =
          3 * std::max(flight.weight, greatest) * step + 2 * step * by_steps[k];
      EXPECT_NEAR(scored[k], by_steps[k], tolerance + 1e-12) << "flight " << i << ", cell " << k;
      within += scored[k] > 0;
    }
  }
  EXPECT_GT(within, least);
}
const std::vector<double> rows{1, 3, 6, 13}, radii{0, 0.7, 1.5, 4}, strips{-3, -1, 0.4, 2};

// Seen red: with the weight at the start of a piece for that in each column; with the order of rows
// as it is where edges descend; with one of the two passages of a ring.
TEST(TalliedFlights, HavePathsInRings) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  expect_paths_by_steps(sea, {rows, radii, true});
  expect_paths_by_steps(sea, {{13, 6, 3, 1}, radii, true});
  expect_paths_by_steps(sea, {rows, {0.7, 1.5}, true}, 50);
  expect_paths_by_steps(sea_of_short_paths(), {rows, radii, true});
}
TEST(TalliedFlights, HavePathsInStrips) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  expect_paths_by_steps(sea, {rows, strips, false});
  expect_paths_by_steps(sea, {{13, 6, 3, 1}, strips, false});
}

// Light along the axis itself, or across x, passes no edge.
TEST(TalliedFlights, HavePathsAlongTheAxis) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  for (const bool rings : {true, false}) {
    tally::TallyScores scores(9);
    const Fluence fluence({rows, rings ? radii : strips, rings}, {}, ContinuousAbsorption(), 0);
    fluence.add(between_depths(sea, 0.5, 4.5), scores);
    const auto scored = scored_in(scores);
    const std::size_t column = rings ? 0 : 1;
    EXPECT_NEAR(scored[column], 2, 1e-12);
    EXPECT_NEAR(scored[3 + column], 1.5, 1e-12);
    EXPECT_EQ(scored[6 + column], 0);
  }
}

}  // namespace
}  // namespace photic::estimator
