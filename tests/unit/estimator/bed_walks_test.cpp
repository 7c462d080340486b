// Where walks meet on the sea bed, and what they know of having been there.
#include <gtest/gtest.h>

#include "unit/estimator/lidars.hpp"

namespace photic::estimator {
namespace {

// What Samples::translated counts them as. Seen red: with the whole part of a negative number for
// the one below.
TEST(MeetingGrid, HasAPointBelowTheBedSoOften) {
  constexpr int offsets = 1000;
  for (const double bed : {1e-3, 0.2, 3.3, 17.0}) {
    for (const auto& [order, share] : {std::pair{1, 0.125}, {2, 0.25}, {3, 1.0}, {7, 1.0}}) {
      int points = 0;
      for (int i = 0; i < offsets; ++i)
        points += grid.meets_on_bed(bed, order, (i + 0.5) / offsets) ? 1 : 0;
      EXPECT_NEAR(points, share * offsets, 1) << "bed at " << bed << " m, order " << order;
    }
  }
}

// Seen red: with the last vertex on the bed for the first.
TEST(WalksOverABed, KnowWhereTheyFirstCameToIt) {
  const auto sea = transport::make_sea(13, {0.1, 0.2, 0.3});
  Walks<double> walks(2, false, true, sea.view());
  for (const std::int32_t walk : {0, 1}) walks.birth(true, walk, {}, {});
  walks.come_to_bed(true, 1, 2);
  walks.come_to_bed(true, 1, 5);
  const auto bed = static_cast<std::int32_t>(transport::Touched::bed);
  for (const std::int32_t vertices : {0, 1, 2, 3, 4, 9}) {
    EXPECT_EQ(walks.touched(1, vertices), vertices > 2 ? bed : 0) << vertices;
    EXPECT_EQ(walks.touched(0, vertices), 0) << vertices;
  }
}

}  // namespace
}  // namespace photic::estimator
