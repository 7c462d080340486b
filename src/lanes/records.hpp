// Records in memory that each lane reads and writes at a place of its own.
//
// In lanes the words of a record stand one behind the other, in whole cache lines, and packs of
// them are turned into packs of their members and back: gathers would take three times as long.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/lanes.hpp"
#include "core/members.hpp"

namespace photic::lanes {

/// The members that the given lanes have, lane by lane. A copy of the record, permuted in its
/// place, would go through memory twice.
template <class T, class R>
  requires(lanes_of<T> > 1)
R of_lanes(R& record, const Index<T>& lane) {
  std::array<Index<T>, members_of<R>.all()> words;
  std::size_t k = 0;
  record.each_member(
      [&](const auto& member) { words[k++] = permute(std::bit_cast<Index<T>>(member), lane); });
  R out;
  k = 0;
  out.each_member([&]<class M>(M& member) { member = std::bit_cast<M>(words[k++]); });
  return out;
}
template <std::floating_point T, class R>
const R& of_lanes(R& record, std::int32_t) {
  return record;
}

/// `to` = `from` in the lanes of a mask.
template <class T, class R>
  requires(lanes_of<T> > 1)
void assign(const Mask<T>& mask, R from, R& to) {
  std::array<Index<T>, members_of<R>.all()> words;
  std::size_t k = 0;
  from.each_member([&](const auto& member) { words[k++] = std::bit_cast<Index<T>>(member); });
  k = 0;
  to.each_member(
      [&]<class M>(M& member) { member = select(mask, std::bit_cast<M>(words[k++]), member); });
}
template <std::floating_point T, class R>
void assign(bool mask, const R& from, R& to) {
  if (mask) to = from;
}

/// R calls f(member) for each of its lanes of reals (T) and integers in each_member(f).
template <class T, class R>
class Records {
 public:
  explicit Records(std::size_t records) : line_(records * lines_of_record) {}

  [[nodiscard]] R at(const Index<T>& i) const {
    R record;
    const Columns columns = read(each_lane(i));
    std::size_t k = 0;
    record.each_member([&](auto& member) {
      member = std::bit_cast<std::decay_t<decltype(member)>>(columns[k++]);
    });
    return record;
  }
  /// The same record in all lanes.
  [[nodiscard]] R in_all_lanes(std::size_t i) const {
    R record;
    const std::int32_t* word = line_[i * lines_of_record].word.data();
    record.each_member([&]<class M>(M& member) {
      std::conditional_t<std::is_same_v<M, T>, Element<T>, std::int32_t> one;
      std::memcpy(&one, word++, sizeof one);
      member = M(one);
    });
    return record;
  }
  /// Writes the lanes of a mask.
  void put(const Mask<T>& mask, const Index<T>& i, R record) {
    Columns columns{};
    std::size_t k = 0;
    record.each_member([&](const auto& member) { columns[k++] = std::bit_cast<Index<T>>(member); });
    write(columns, mask, each_lane(i));
  }

 private:
  static constexpr std::size_t lanes = lanes_of<T>;
  static constexpr std::size_t words_of_line = 16;
  static constexpr std::size_t lines_of_record =
      (members_of<R>.all() + words_of_line - 1) / words_of_line;
  static constexpr std::size_t packs_of_record = (members_of<R>.all() + lanes - 1) / lanes;
  static_assert(sizeof(Element<T>) == sizeof(std::int32_t));

  struct alignas(64) CacheLine {
    std::array<std::int32_t, words_of_line> word{};
  };
  using Places = std::array<std::int32_t, lanes>;
  using Square = std::array<Index<T>, lanes>;
  using Columns = std::array<Index<T>, packs_of_record * lanes>;

  [[nodiscard]] const std::int32_t* words(std::int32_t i) const {
    return line_[static_cast<std::size_t>(i) * lines_of_record].word.data();
  }
  [[nodiscard]] std::int32_t* words(std::int32_t i) {
    return line_[static_cast<std::size_t>(i) * lines_of_record].word.data();
  }

  [[nodiscard]] Columns read(const Places& places) const {
    Columns columns;
    unrolled<packs_of_record>([&](auto pack) {
      Square rows;
      unrolled<lanes>(
          [&](auto lane) { rows[lane] = Index<T>::load(words(places[lane]) + pack * lanes); });
      transpose(rows);
      unrolled<lanes>([&](auto k) { columns[pack * lanes + k] = rows[k]; });
    });
    return columns;
  }
  void write(const Columns& columns, const Mask<T>& mask, const Places& places) {
    const std::uint32_t bits = lane_bits(mask);
    unrolled<packs_of_record>([&](auto pack) {
      Square rows;
      unrolled<lanes>([&](auto k) { rows[k] = columns[pack * lanes + k]; });
      transpose(rows);
      unrolled<lanes>([&](auto lane) {
        if ((bits >> lane & 1U) != 0) rows[lane].store(words(places[lane]) + pack * lanes);
      });
    });
  }

  std::vector<CacheLine> line_;
};

/// Records of one lane.
template <std::floating_point T, class R>
class Records<T, R> {
 public:
  explicit Records(std::size_t records) : record_(records) {}
  [[nodiscard]] const R& at(std::int32_t i) const { return record_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const R& in_all_lanes(std::size_t i) const { return record_[i]; }
  void put(bool mask, std::int32_t i, const R& record) {
    if (mask) record_[static_cast<std::size_t>(i)] = record;
  }

 private:
  std::vector<R> record_;
};

}  // namespace photic::lanes
