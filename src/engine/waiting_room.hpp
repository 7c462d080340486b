// Where the few lanes wait that are worth more work, until they fill a pack.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/lanes.hpp"

namespace photic::engine {

/// Item has so many `reals` (T) and `integers`, and calls f(member) for each in each_member(f).
template <class T, class Item>
class WaitingRoom {
 public:
  /// Adds the lanes of a mask; calls serve(item, mask) when a pack is full.
  template <class Serve>
  void admit(const Mask<T>& mask, Item item, Serve serve) {
    if constexpr (lanes == 1) {
      if (mask) serve(item, mask);
    } else {
      each_column(item, [&](const auto& member, auto* column) {
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
      if (waiting_ > 0) serve(first(), mask_of_bits<T>((1U << waiting_) - 1));
      waiting_ = 0;
    }
  }

 private:
  static constexpr std::size_t lanes = lanes_of<T>;
  template <class E>
  using Column = std::array<E, 2 * lanes>;

  /// Calls f(member, its column) for each.
  template <class F>
  void each_column(Item& item, F f) {
    std::size_t real = 0, integer = 0;
    item.each_member([&]<class M>(M& member) {
      if constexpr (std::is_same_v<M, T>) {
        f(member, real_[real++].data());
      } else {
        f(member, integer_[integer++].data());
      }
    });
  }
  Item first() {
    Item item;
    each_column(item, [](auto& member, const auto* column) {
      member = std::decay_t<decltype(member)>::load(column);
    });
    return item;
  }
  template <class Serve>
  void serve_full(Serve& serve) {
    if (waiting_ < lanes) return;
    const Item item = first();
    waiting_ -= lanes;
    Item rest;
    each_column(rest,
                [](const auto&, auto* column) { std::copy_n(column + lanes, lanes, column); });
    serve(item, Mask<T>(true));
  }

  std::array<Column<Element<T>>, Item::reals> real_{};
  std::array<Column<std::int32_t>, Item::integers> integer_{};
  std::size_t waiting_ = 0;
};

}  // namespace photic::engine
