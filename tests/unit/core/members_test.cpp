#include "core/members.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace photic {
namespace {

template <class T>
struct Point {
  T x{}, y{};
  std::int32_t number = 0;

  template <class F>
  constexpr void each_member(F& f) {
    f(x), f(y), f(number);
  }
};
template <class T>
struct Segment {
  Point<T> from, to;
  T width{};

  template <class F>
  constexpr void each_member(F f) {
    from.each_member(f), to.each_member(f), f(width);
  }
};

// Seen red: with integers among the reals.
TEST(Members, AreCountedByType) {
  static_assert(members_of<Segment<float>>.all() == 7);
  EXPECT_EQ(members_of<Segment<float>>.reals, 5U);
  EXPECT_EQ(members_of<Segment<float>>.integers, 2U);
}

}  // namespace
}  // namespace photic
