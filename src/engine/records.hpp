// Records in memory that each lane reads and writes at a place of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/lanes.hpp"

namespace photic::engine {

/// What the given lanes have, lane by lane.
template <class T, class R>
R of_lanes(R record, const Index<T>& lane) {
  if constexpr (lanes_of<T> > 1)
    record.each_member([&](auto& member) { member = permute(member, lane); });
  return record;
}

/// R has lanes of reals (T) and of integers, and calls f(member) for each in each_member(f).
template <class T, class R>
class Records {
 public:
  explicit Records(std::size_t records) {
    R().each_member([this]<class M>(const M&) { ++(std::is_same_v<M, T> ? reals_ : integers_); });
    real_.resize(records * reals_);
    integer_.resize(records * integers_);
  }

  [[nodiscard]] R at(const Index<T>& i) const {
    R out;
    const Element<T>* real = real_.data();
    const std::int32_t* integer = integer_.data();
    const Index<T> r = i * Index<T>(reals_), n = i * Index<T>(integers_);
    out.each_member([&]<class M>(M& member) {
      if constexpr (std::is_same_v<M, T>) {
        member = gather<T>(real++, r);
      } else {
        member = gather_index<T>(integer++, n);
      }
    });
    return out;
  }

  /// Writes the lanes of a mask.
  void put(const Mask<T>& mask, const Index<T>& i, R record) {
    Element<T>* real = real_.data();
    std::int32_t* integer = integer_.data();
    const Index<T> r = i * Index<T>(reals_), n = i * Index<T>(integers_);
    record.each_member([&]<class M>(const M& member) {
      if constexpr (std::is_same_v<M, T>) {
        scatter(mask, r, member, real++);
      } else {
        scatter(mask, n, member, integer++);
      }
    });
  }

  /// Real number k of record i.
  [[nodiscard]] Element<T> real(std::size_t i, std::size_t k) const {
    return real_[i * reals_ + k];
  }
  [[nodiscard]] std::int32_t integer(std::size_t i, std::size_t k) const {
    return integer_[i * integers_ + k];
  }

 private:
  std::size_t reals_ = 0, integers_ = 0;
  std::vector<Element<T>> real_;
  std::vector<std::int32_t> integer_;
};

}  // namespace photic::engine
