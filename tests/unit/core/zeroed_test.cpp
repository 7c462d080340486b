#include "core/zeroed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace photic {
namespace {

using Row = std::array<double, 3>;

// What a plain vector holds, whatever has been done to it. Seen red: without destroy(), where
// elements come back that had been taken away.
TEST(ZeroedVector, HoldsWhatAVectorHolds) {
  ZeroedVector<Row> zeroed(3);
  std::vector<Row> plain(3);
  const auto both = [&](auto act) {
    act(zeroed);
    act(plain);
    ASSERT_EQ(zeroed.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(zeroed[i], plain[i]) << i;
  };
  both([](auto& v) { v[1] = {1, 2, 3}; });
  both([](auto& v) { v.push_back({4, 5, 6}); });
  both([](auto& v) { v.resize(2); });
  both([](auto& v) { v.resize(5); });
  both([](auto& v) { v.push_back({}); });
  both([](auto& v) { v.erase(v.begin()); });
  both([](auto& v) { v.clear(); });
  both([](auto& v) { v.resize(4); });
  const ZeroedVector<Row> copy = zeroed;
  EXPECT_EQ(copy, zeroed);
}

// Seen red: with zeros found by ==.
TEST(ZeroedVector, KeepsTheSignOfZeroAndNaN) {
  ZeroedVector<double> v;
  v.push_back(-0.0);
  v.push_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::signbit(v[0]));
  EXPECT_TRUE(std::isnan(v[1]));
}

}  // namespace
}  // namespace photic
