// All strategies that draw a path give the same: what each makes of it, against the direct sum.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "unit/estimator/lidars.hpp"
#include "unit/estimator/scores.hpp"

namespace photic::estimator {

struct Counts {
  int connected = 0, met = 0, rotated = 0, not_rotated = 0, free_telescope = 0, free_laser = 0;
};

/// The path with all its vertices elsewhere, by so much sideways.
inline Path moved_path(const Path& path, double x, double y) {
  Path other = path;
  for (V& place : other.vertex) place = place + V{x, y, 0};
  return other;
}

/// Every strategy that draws the path with walks of at most `most` vertices gives what the direct
/// sum says.
inline Counts expect_same_of_all(Sea& sea, const Path& path, const Samples<double>& samples,
                                 std::int32_t most) {
  Counts counts;
  sea.world.walks.max_vertices = most;
  const StrategiesOfPath expected(sea.world, sea.medium, samples, path, most);
  const double value = expected.value();
  Scores scores(sea.world, samples, sea.medium, path, expected.group_path());
  for (std::int32_t e = 0; e <= path.order(); ++e) {
    if (expected.connecting(e) == 0) continue;
    EXPECT_NEAR(scores.connecting(e) / value, 1, 1e-10) << "connecting edge " << e;
    ++counts.connected;
  }
  for (std::int32_t i = 1; i <= path.order(); ++i) {
    if (expected.as_long_elsewhere(i)) continue;  // other meetings would be taken for this one
    const Path other =
        translated_path(sea.world, path, {0.1 * std::sin(i), 0.1 * std::cos(3 * i), 0});
    if (expected.translated(i) == 0) {
      if (most == max_vertices) {
        EXPECT_EQ(scores.translated(i, other), 0) << "translated to meet at " << i;
      }
      continue;
    }
    // Of a tilted lens in the water it comes as far as its first vertex so often, and counts so
    // little.
    const double drawn = i == path.order()
                             ? 1
                             : expected.drawn_to_last_vertex() /
                                   StrategiesOfPath(sea.world, sea.medium, samples, other, most)
                                       .drawn_to_last_vertex();
    EXPECT_NEAR(scores.translated(i, other) / (drawn * value), 1, 1e-10)
        << "translated to meet at " << i;
    ++counts.met;
  }
  for (std::int32_t i = 1; i <= path.order(); ++i) {
    if (expected.as_long_elsewhere(i)) continue;
    const Path other = moved_path(path, 0.4 * std::sin(i), 0.4 * std::cos(3 * i));
    if (expected.free_telescope(i) > 0) {
      EXPECT_NEAR(scores.free_telescope(i, other) / value, 1, 1e-10)
          << "a free walk of the telescope at " << i;
      ++counts.free_telescope;
    }
    if (expected.free_laser(i) > 0) {
      EXPECT_NEAR(scores.free_laser(i, other) / value, 1, 1e-10)
          << "a free walk of the laser at " << i;
      ++counts.free_laser;
    }
  }
  for (std::int32_t i = 1; i < path.pivot(); ++i) {
    const Path other = rotated_path(path, 1.0 + i);
    if (samples.rotated > 0 && expected.meets_facets_with_sides(i)) {
      EXPECT_EQ(scores.rotated(i, other), 0) << "rotated to meet at " << i;
      ++counts.not_rotated;
    }
    if (expected.rotated(i) == 0) continue;
    // It is drawn so often, and counts so little.
    const double drawn =
        expected.drawn_at_pivot() /
        StrategiesOfPath(sea.world, sea.medium, samples, other, most).drawn_at_pivot();
    EXPECT_NEAR(scores.rotated(i, other) / (drawn * value), 1, 1e-8) << "rotated to meet at " << i;
    ++counts.rotated;
  }
  return counts;
}

/// With walks that may be free, and without.
inline Counts expect_same_of_all(Sea& sea, const Path& path, std::int32_t most = max_vertices) {
  Samples<double> samples = sea.world.walks.uses.rotated_scattered ? rotating : translating;
  const Counts counts = expect_same_of_all(sea, path, samples, most);
  samples.free_telescope = samples.free_laser = {};
  sea.begin(false);
  const Counts bound = expect_same_of_all(sea, path, samples, most);
  sea.begin(true);
  EXPECT_EQ(bound.connected, counts.connected);
  EXPECT_EQ(bound.met, counts.met);
  EXPECT_EQ(bound.free_telescope + bound.free_laser, 0);
  return counts;
}

}  // namespace photic::estimator
