// A queue of the few lanes that are worth more work, until they fill a pack.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "core/lanes.hpp"
#include "lanes/lane_columns.hpp"

namespace photic::lanes {

/// Packs are served together: what has just been written to memory is slow to read again.
template <class T, class Item>
class Queue {
 public:
  /// `like`: the values that are the same for all items, whose each_member() may leave them out.
  explicit Queue(const Item& like = {}) : like_(like) {}

  /// Adds the lanes of a mask of an item, or of what has the same members; calls serve(item, mask)
  /// for each full pack when the queue is full.
  template <class Like, class Serve>
  void push(const Mask<T>& mask, Like item, Serve serve) {
    if constexpr (lanes == 1) {
      if (mask) serve(Item(item), mask);
    } else {
      const std::size_t place = waiting_;
      columns_.each(
          item, [&](const auto& member, auto* column) { compress(mask, member, column + place); });
      waiting_ = place + count(mask);
      if (waiting_ > capacity) serve_full(serve);
    }
  }
  /// Serves all.
  template <class Serve>
  void flush(Serve serve) {
    if constexpr (lanes > 1) {
      serve_full(serve);
      if (waiting_ > 0) serve(pack_at(0), first_lanes<T>(waiting_));
      waiting_ = 0;
    }
  }

 private:
  static constexpr std::size_t lanes = lanes_of<T>;
  static constexpr std::size_t capacity = 8 * lanes;

  Item pack_at(std::size_t first) {
    Item item = like_;
    columns_.each(item, [first](auto& member, const auto* column) {
      member = std::decay_t<decltype(member)>::load(column + first);
    });
    return item;
  }
  template <class Serve>
  void serve_full(Serve& serve) {
    std::size_t served = 0;
    for (; served + lanes <= waiting_; served += lanes) serve(pack_at(served), Mask<T>(true));
    if (served == 0) return;
    columns_.each(like_, [served](const auto&, auto* column) {
      std::copy_n(column + served, lanes, column);
    });
    waiting_ -= served;
  }

  Item like_;
  LaneColumns<T, Item, capacity + lanes> columns_;
  std::size_t waiting_ = 0;
};

}  // namespace photic::lanes
