// Work given out to lanes: one after the other, so many at a time as there are lanes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/lanes.hpp"

namespace photic::lanes {

/// Calls act(Index, mask) for the whole numbers below `count`, so many at a time as there are
/// lanes.
template <class T, class Act>
void each_index(std::int32_t count, Act act) {
  for (std::int32_t base = 0; base < count; base += lanes_of<T>) {
    const Index<T> i = Index<T>(base) + lane_numbers<T>();
    act(i, i < Index<T>(count));
  }
}

/// Calls act(which lane, number, mask) for all whole numbers from `first` to below `last` of the
/// lanes of a mask, so many at a time as there are lanes.
template <class T, class Act>
void each_number(const Mask<T>& mask, const T& first, const T& last, Act act) {
  constexpr std::size_t lanes = lanes_of<T>;
  std::array<std::int32_t, lanes> lane{};
  std::array<Element<T>, lanes> number{};
  std::size_t found = 0;
  const auto firsts = each_lane(first), lasts = each_lane(last);
  const auto pass_on = [&] {
    Index<T> from(0);
    T n(0);
    const Mask<T> all = first_lanes<T>(found);
    expand(all, lane.data(), from);
    expand(all, number.data(), n);
    act(from, n, all);
    found = 0;
  };
  for_each_lane(mask, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    for (auto n = std::ceil(firsts[i]); n < lasts[i]; n += 1) {
      lane[found] = k;
      number[found] = n;
      if (++found == lanes) pass_on();
    }
  });
  if (found > 0) pass_on();
}

}  // namespace photic::lanes
