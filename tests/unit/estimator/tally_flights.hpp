// Flights as tallies beside echoes take them, through a sea made by hand, and what they scored.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/tallies/continuous_absorption.hpp"
#include "estimator/tallies/flight.hpp"
#include "support/random.hpp"
#include "tally/tally_scores.hpp"
#include "unit/transport/sea.hpp"

namespace photic::estimator {

constexpr double bed_of_flights_m = 14;

/// From a depth, in a direction (z up).
inline Flight flight_through(const transport::Sea& sea, const Vec3<double>& start,
                             const Vec3<double>& direction, double length, double weight = 1) {
  return {start,
          direction,
          -start.z,
          -start.z - length * direction.z,
          length,
          weight,
          static_cast<std::size_t>(sea.layer_at(-start.z))};
}
/// Straight down or up between two depths.
inline Flight between_depths(const transport::Sea& sea, double from, double to) {
  Flight flight = flight_through(sea, {0, 0, -from}, {0, 0, to > from ? -1.0 : 1.0},
                                 to > from ? to - from : from - to);
  flight.to = to;
  return flight;
}
/// Within the sea; some are level.
inline Flight random_flight(const transport::Sea& sea, test::Random& random) {
  const Vec3<double> start{random.between(-4, 4), random.between(-4, 4),
                           -random.between(0.1, bed_of_flights_m - 0.1)};
  Vec3<double> direction = random.direction();
  if (random.chance(0.1)) direction = normalised(Vec3<double>{direction.x, direction.y, 0});
  const double room = direction.z > 0 ? -start.z / direction.z
                                      : (bed_of_flights_m + start.z) / (1e-9 - direction.z);
  return flight_through(sea, start, direction, std::min(8.0, room) * random.uniform(),
                        random.between(0.5, 2));
}
/// The weight by steps: how much is left of it at the middle of each.
template <class F>
void each_step(const ContinuousAbsorption& absorption, const Flight& flight, int steps, F f) {
  double depth = 0;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps, step = flight.length / steps;
    const double distance = flight.from + share * (flight.to - flight.from);
    const std::size_t layer = absorption.layer_of(distance);
    depth += absorption.per_m(layer) * step / 2;
    f(layer, flight.start + share * flight.length * flight.direction, distance,
      flight.weight * std::exp(-depth), step);
    depth += absorption.per_m(layer) * step / 2;
  }
}

/// The sums of scores, [cell].
inline std::vector<double> scored_in(const tally::TallyScores& scores) {
  std::vector<double> out;
  for (const double sum : scores.sums) out.push_back(sum / tally::tally_score_unit);
  return out;
}

/// Free paths are drawn three times as often as light collides: weights grow along them.
inline transport::Sea sea_of_short_paths() {
  transport::Sea sea = transport::make_sea(bed_of_flights_m);
  sea.paths = {sea, std::vector<double>(sea.c.size(), 3.0)};
  return sea;
}

}  // namespace photic::estimator
