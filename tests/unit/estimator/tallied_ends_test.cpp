// Absorption along flights, and where light ends, as `boundaries` has it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "estimator/tallies/boundaries.hpp"
#include "unit/estimator/tally_flights.hpp"

namespace photic::estimator {
namespace {

// Pieces of a flight in each layer are in order, and as long as it is. Weights at any distance are
// those of steps, also where they grow. Seen red: with the absorption of the layer where a flight
// begins all along it; with weights that stay as they are.
TEST(TalliedEnds, WeighFlightsByLayers) {
  for (const auto& sea : {transport::make_sea(bed_of_flights_m), sea_of_short_paths()}) {
    const ContinuousAbsorption absorption(sea.view());
    ASSERT_EQ(absorption.layers(), 3U);
    test::Random random(7);
    int over_edges = 0, grow = 0;
    for (int i = 0; i < 200; ++i) {
      const Flight flight = random_flight(sea, random);
      double whole = 0, depth = 0;
      int pieces = 0;
      each_layer(absorption, flight, [&](std::size_t layer, double length, double begun) {
        EXPECT_NEAR(begun, whole, 1e-9);
        const double middle =
            flight.from + (flight.to - flight.from) * (begun + length / 2) / flight.length;
        EXPECT_EQ(layer, absorption.layer_of(middle));
        whole += length;
        depth += absorption.per_m(layer) * length;
        ++pieces;
      });
      EXPECT_NEAR(whole, flight.length, 1e-9);
      over_edges += pieces > 1;
      if (flight.from == flight.to) continue;
      const double end = absorption.weight_at(flight, flight.to);
      EXPECT_NEAR(end, flight.weight * std::exp(-depth), 1e-9 * end);
      grow += end > flight.weight;
      double middle = 0;
      each_step(absorption, flight, 20001,
                [&](std::size_t, const auto&, double at, double weight, double step) {
                  if (std::abs(at - (flight.from + flight.to) / 2) < step / 100) middle = weight;
                });
      ASSERT_GT(middle, 0);
      EXPECT_NEAR(absorption.weight_at(flight, (flight.from + flight.to) / 2), middle,
                  1e-3 * middle);
    }
    EXPECT_GT(over_edges, 25);
    EXPECT_EQ(grow > 0, absorption.per_m(0) < 0);
  }
}

// A path times the mean weight along it, of weights that fall, stay or grow.
TEST(TalliedEnds, WeighPathsByTheirMean) {
  for (const auto& sea : {transport::make_sea(bed_of_flights_m), sea_of_short_paths()}) {
    const ContinuousAbsorption absorption(sea.view());
    double sum = 0;
    const Flight level = flight_through(sea, {0, 0, -7}, {1, 0, 0}, 3, 1.5);
    each_step(absorption, level, 3000,
              [&](std::size_t, const auto&, double, double weight, double step) {
                sum += weight * step;
              });
    EXPECT_NEAR(absorption.track(1, 1.5, 3), sum, 1e-5 * sum);
  }
  EXPECT_EQ(ContinuousAbsorption().track(0, 1.5, 3), 4.5);
}

/// Two constituents in three layers, by shares that differ; escape by angle; the rest.
struct Ends {
  Ends()
      : boundaries({.absorbed = 0,
                    .constituents = 2,
                    .escaped = 6,
                    .reflected_by_surface = 9,
                    .left_water = 10,
                    .bottom = 11,
                    .film = std::nullopt},
                   {0.9, 0.1, 0.4, 0.6, 1.0, 0.0}, {0.2, 0.0, 0.5}, {0, 30, 60, 90}),
        scores(12) {}
  [[nodiscard]] std::vector<double> scored() const { return scored_in(scores); }

  Boundaries boundaries;
  tally::TallyScores scores;
};

// The loss of a flight in each layer goes to the layer's own constituents. Seen red: with a layer's
// shares swapped.
TEST(TalliedEnds, AbsorbByLayerAndConstituent) {
  const auto sea = transport::make_sea(bed_of_flights_m);
  const ContinuousAbsorption absorption(sea.view());
  Ends ends;
  const Flight down = between_depths(sea, 1, 13);
  ends.boundaries.fly(down, absorption, ends.scores);
  const auto scored = ends.scored();
  const double at_5 = absorption.weight_at(down, 5), at_12 = absorption.weight_at(down, 12),
               at_13 = absorption.weight_at(down, 13);
  EXPECT_NEAR(scored[0], 0.9 * (1 - at_5), 1e-12);
  EXPECT_NEAR(scored[1], 0.1 * (1 - at_5), 1e-12);
  EXPECT_NEAR(scored[2], 0.4 * (at_5 - at_12), 1e-12);
  EXPECT_NEAR(scored[3], 0.6 * (at_5 - at_12), 1e-12);
  EXPECT_NEAR(scored[4], at_12 - at_13, 1e-12);
  EXPECT_EQ(scored[5], 0);
}

// Collisions lose the share of the layer, and nothing where all is lost along flights.
TEST(TalliedEnds, AbsorbAtCollisions) {
  Ends ends;
  for (const std::size_t layer : {0U, 1U, 2U}) ends.boundaries.collide(layer, 0.8, ends.scores);
  const auto scored = ends.scored();
  EXPECT_NEAR(scored[0] + scored[1], 0.8 * 0.2, 1e-12);
  EXPECT_EQ(scored[2] + scored[3], 0);
  EXPECT_NEAR(scored[4], 0.8 * 0.5, 1e-12);
}

// Where weights grow along flights nothing is booked there.
TEST(TalliedEnds, AbsorbNothingAlongFlightsThatGrow) {
  const auto sea = sea_of_short_paths();
  Ends ends;
  ends.boundaries.fly(between_depths(sea, 1, 13), ContinuousAbsorption(sea.view()), ends.scores);
  for (const double cell : ends.scored()) EXPECT_EQ(cell, 0);
}

// Angles between edges, of which each belongs to the larger ones, and the horizon to the last. Seen
// red: with edges that belong to the smaller ones.
TEST(TalliedEnds, EscapeByAngle) {
  for (const auto& [zenith_deg, cell] :
       {std::pair{0.0, 6U}, {29.0, 6U}, {30.0, 7U}, {59.0, 7U}, {60.0, 8U}, {90.0, 8U}}) {
    Ends ends;
    ends.boundaries.escape(std::cos(zenith_deg * radian_per_degree), 0.5, false, ends.scores);
    ends.boundaries.escape(std::cos(zenith_deg * radian_per_degree), 0.25, true, ends.scores);
    const auto scored = ends.scored();
    EXPECT_EQ(scored[cell], 0.75) << zenith_deg;
    EXPECT_EQ(scored[9], 0.5);
    EXPECT_EQ(scored[10], 0.25);
  }
}

// A world without a film has no cell for it.
TEST(TalliedEnds, BookOnlyWhatThereIs) {
  Ends ends;
  ends.boundaries.absorb_in_film(1, ends.scores);
  ends.boundaries.absorb_at_bottom(0.5, ends.scores);
  const auto scored = ends.scored();
  EXPECT_EQ(scored[11], 0.5);
  for (std::size_t i = 0; i < 11; ++i) EXPECT_EQ(scored[i], 0) << i;
}

}  // namespace
}  // namespace photic::estimator
