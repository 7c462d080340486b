// The members of items side by side, column by column: items that wait for a pack, or for a lane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/lanes.hpp"
#include "core/members.hpp"

namespace photic::lanes {

/// Item calls f(member) for each of its reals (T) and integers in each_member(f).
template <class T, class Item, std::size_t length>
class LaneColumns {
 public:
  /// Calls f(member, its column) for each member of an item, or of what has the same members.
  template <class Like, class F>
  void each(Like& item, F f) {
    std::size_t real = 0, integer = 0;
    item.each_member([&]<class M>(M& member) {
      if constexpr (std::is_same_v<std::remove_const_t<M>, T>) {
        f(member, real_[real++].data());
      } else {
        f(member, integer_[integer++].data());
      }
    });
  }

 private:
  std::array<std::array<Element<T>, length>, members_of<Item>.reals> real_{};
  std::array<std::array<std::int32_t, length>, members_of<Item>.integers> integer_{};
};

}  // namespace photic::lanes
