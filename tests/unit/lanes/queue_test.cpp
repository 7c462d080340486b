// What waits until it fills a pack.
#include <gtest/gtest.h>

#include "core/pack.hpp"
// Packs first: what follows is made of them.
#include "lanes/queue.hpp"
#include "support/random.hpp"

namespace photic::lanes {
namespace {

using Lanes = Pack<float, 4>;

template <class T>
struct Item {
  T real{};
  Index<T> number{};

  template <class F>
  constexpr void each_member(F f) {
    f(real), f(number);
  }
};

// Seen red: with the last pack served in full; with what is left over not moved to the front.
TEST(Queue, ServesAllInTheirOrderAndFullPacksFirst) {
  test::Random random(5);
  Queue<Lanes, Item<Lanes>> queue;
  std::vector<int> pushed, served;
  int packs = 0, full = 0;
  const auto serve = [&](const Item<Lanes>& item, const Mask<Lanes>& mask) {
    ++packs;
    full += count(mask) == 4 ? 1 : 0;
    for_each_lane(mask, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      served.push_back(item.number[i]);
      EXPECT_EQ(item.real[i], 0.5F * static_cast<float>(item.number[i]));
    });
  };
  for (int n = 0; n < 200; ++n) {
    Item<Lanes> item;
    Mask<Lanes> mask(false);
    for (std::size_t i = 0; i < 4; ++i) {
      item.number.set(i, 4 * n + static_cast<int>(i));
      item.real.set(i, 0.5F * static_cast<float>(4 * n + static_cast<int>(i)));
    }
    mask = item.number < Index<Lanes>(4 * n + random.below(5));
    for_each_lane(mask, [&](int lane) { pushed.push_back(4 * n + lane); });
    queue.push(mask, item, serve);
  }
  EXPECT_EQ(full, packs);
  queue.flush(serve);
  EXPECT_EQ(served, pushed);
  EXPECT_LE(packs - full, 1);
}

}  // namespace
}  // namespace photic::lanes
