// The scalar meaning of the operations on lanes.
#include "core/lanes.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace photic {
namespace {

TEST(Lanes, SelectAnyAllFloorAndGather) {
  EXPECT_EQ(select(true, 1.0, 2.0), 1.0);
  EXPECT_EQ(select(false, 1.0, 2.0), 2.0);
  EXPECT_TRUE(any(true) && all(true) && !any(false) && !all(false));
  EXPECT_EQ(floor_index(2.999), 2);
  EXPECT_EQ(floor_index(2.999F), 2);
  EXPECT_EQ(floor_index(3.0), 3);
  EXPECT_EQ(floor_index(0.0), 0);
  const double table[] = {1.5, 2.5};
  const std::int32_t numbers[] = {7, 8};
  EXPECT_EQ(gather<double>(table, 1), 2.5);
  EXPECT_EQ(gather<float>(table, 0), 1.5F);
  EXPECT_EQ(gather_index<double>(numbers, 1), 8);
  EXPECT_EQ(to_real<double>(-3), -3.0);
}

template <class T>
class OctaveOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(OctaveOf, Reals);

// Every edge is the start of its own cell and the end of the one before. Seen red: with a bias of
// 1022.
TYPED_TEST(OctaveOf, EdgeIsTheInverseOfCell) {
  using T = TypeParam;
  for (const int bits : {0, 3, 7}) {
    EXPECT_EQ(octave_edge<T>(0, bits), T(1));
    EXPECT_EQ(octave_edge<T>(1 << bits, bits), T(2));
    for (std::int32_t cell = -(30 << bits); cell <= 10 << bits; ++cell) {
      const T edge = octave_edge<T>(cell, bits);
      const auto at = octave_cell(edge, bits);
      ASSERT_EQ(at.cell, cell);
      ASSERT_EQ(at.fraction, T(0));
      const auto before = octave_cell(std::nextafter(edge, T(0)), bits);
      ASSERT_EQ(before.cell, cell - 1);
      ASSERT_LT(before.fraction, T(1));
      ASSERT_GT(before.fraction, T(0.999));
    }
  }
}

TYPED_TEST(OctaveOf, CellsAreEqualWithinAnOctave) {
  using T = TypeParam;
  for (std::int32_t cell = 0; cell < 128; ++cell) {
    EXPECT_EQ(octave_edge<T>(cell, 7), T(1) + T(cell) / T(128));
    EXPECT_EQ(octave_edge<T>(cell - 128, 7), T(0.5) + T(cell) / T(256));
  }
}

// Cell and fraction together are x, to the last bit. Seen red: with the fraction one bit short.
TYPED_TEST(OctaveOf, CellAndFractionGiveXBack) {
  using T = TypeParam;
  test::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const T x = static_cast<T>(random.scale(1e-9, 100));
    const auto at = octave_cell(x, 7);
    const T low = octave_edge<T>(at.cell, 7);
    ASSERT_EQ(low + at.fraction * (octave_edge<T>(at.cell + 1, 7) - low), x);
  }
}

}  // namespace
}  // namespace photic
