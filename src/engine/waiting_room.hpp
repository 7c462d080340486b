// Where the few lanes wait that are worth more work, until they fill a pack.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "core/lanes.hpp"
#include "engine/lane_columns.hpp"

namespace photic::engine {

template <class T, class Item>
class WaitingRoom {
 public:
  /// `like`: what is the same for all items, whose each_member() may leave that out.
  explicit WaitingRoom(const Item& like = {}) : like_(like) {}

  /// Adds the lanes of a mask; calls serve(item, mask) when a pack is full.
  template <class Serve>
  void admit(const Mask<T>& mask, Item item, Serve serve) {
    if constexpr (lanes == 1) {
      if (mask) serve(item, mask);
    } else {
      columns_.each(item, [&](const auto& member, auto* column) {
        compress(mask, member, column + waiting_);
      });
      waiting_ += count(mask);
      serve_full(serve);
    }
  }
  /// Serves those who are left.
  template <class Serve>
  void close(Serve serve) {
    if constexpr (lanes > 1) {
      if (waiting_ > 0) serve(first(), first_lanes<T>(waiting_));
      waiting_ = 0;
    }
  }

 private:
  static constexpr std::size_t lanes = lanes_of<T>;

  Item first() {
    Item item = like_;
    columns_.each(item, [](auto& member, const auto* column) {
      member = std::decay_t<decltype(member)>::load(column);
    });
    return item;
  }
  template <class Serve>
  void serve_full(Serve& serve) {
    if (waiting_ < lanes) return;
    const Item item = first();
    waiting_ -= lanes;
    columns_.each(like_,
                  [](const auto&, auto* column) { std::copy_n(column + lanes, lanes, column); });
    serve(item, Mask<T>(true));
  }

  Item like_;
  LaneColumns<T, Item, 2 * lanes> columns_;
  std::size_t waiting_ = 0;
};

}  // namespace photic::engine
