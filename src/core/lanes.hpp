// The lane type: the operations on T, besides arithmetic, of a template over T.
//
// Transport code is written once, for a T that is one double (the reference), one float, or a pack
// of them that walks several photons at a time. Such code never branches on a value: it blends with
// select() and loops with any(). This header gives the scalar meaning of each operation; a pack
// overloads them beside its own type, and the unqualified calls find it.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace photic {

/// f(0), f(1), … f(n - 1) with constants: what is indexed by them can stay in registers.
template <std::size_t n, class F>
void unrolled(F f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (f(std::integral_constant<std::size_t, i>()), ...);
  }(std::make_index_sequence<n>());
}

/// The types that belong to a lane type: its mask, its integers, its element.
template <class T>
struct LaneTraits;

template <std::floating_point T>
struct LaneTraits<T> {
  using Element = T;
  using Mask = bool;
  using Index = std::int32_t;
  using Word = std::uint32_t;
  using Counter = std::uint64_t;  ///< photon numbers, and the words of random numbers
  static constexpr int lanes = 1;
};

template <class T>
using Element = typename LaneTraits<T>::Element;
template <class T>
using Mask = typename LaneTraits<T>::Mask;
template <class T>
using Index = typename LaneTraits<T>::Index;
template <class T>
using Word = typename LaneTraits<T>::Word;
template <class T>
using Counter = typename LaneTraits<T>::Counter;
template <class T>
inline constexpr int lanes_of = LaneTraits<T>::lanes;

/// mask ? yes : no, lane by lane.
template <class V>
  requires std::is_arithmetic_v<V>
constexpr V select(bool mask, V yes, V no) {
  return mask ? yes : no;
}

constexpr bool any(bool mask) { return mask; }
constexpr bool all(bool mask) { return mask; }

/// A table in double and in float: each lane type gathers what its element is.
struct Table {
  const double* exact = nullptr;
  const float* rounded = nullptr;

  double operator[](std::int32_t i) const { return exact[i]; }
  Table operator+(std::int32_t entries) const { return {exact + entries, rounded + entries}; }
};

/// The same of a table that is often so short that a pack has it in its registers. The floats are
/// readable beyond the end, up to a multiple of `table_padding`.
inline constexpr std::size_t table_padding = 64;
struct ShortTable : Table {
  std::int32_t size = 0;
};

/// Two such tables, whose numbers are mostly wanted together: as columns and as rows.
struct ShortPairs {
  ShortTable first, second;
  Table rows;
};

/// A function's unit is cut into so many cells, from which its series start: in double 64, in float
/// no more than every register holds. The same terms do for both.
template <class T>
inline constexpr int cell_bits = sizeof(Element<T>) == sizeof(double) ? 6 : 3;
template <class T>
inline constexpr std::int32_t cells = std::int32_t{1} << cell_bits<T>;

/// f(lower edge of a cell, its width) for each cell.
class CellTable {
 public:
  template <class F>
  explicit CellTable(F f) {
    fill<double>(f, exact_);
    fill<float>(f, rounded_);
  }
  [[nodiscard]] const double* exact() const { return exact_.data(); }
  /// Readable as far as registers go.
  [[nodiscard]] const float* rounded() const { return rounded_.data(); }

 private:
  template <class T, class F, class Numbers>
  static void fill(F f, Numbers& table) {
    constexpr double width = 1.0 / cells<T>;
    for (std::size_t i = 0; i < cells<T>; ++i)
      table[i] = static_cast<T>(f(width * static_cast<double>(i), width));
  }

  std::array<double, cells<double>> exact_{};
  alignas(64) std::array<float, 16> rounded_{};
};

/// A short table of integers.
struct IndexTable {
  const std::int32_t* data = nullptr;
  std::int32_t size = 0;

  std::int32_t operator[](std::int32_t i) const { return data[i]; }
};

/// data[i], lane by lane. T is the lane type wanted, whatever the table is stored as.
template <std::floating_point T, class Stored>
constexpr T gather(const Stored* data, std::int32_t i) {
  return static_cast<T>(data[i]);
}
template <std::floating_point T>
T gather(const Table& table, std::int32_t i) {
  if constexpr (std::same_as<T, float>) {
    return table.rounded[i];
  } else {
    return table.exact[i];
  }
}
template <std::floating_point T>
T gather(const CellTable& table, std::int32_t i) {
  if constexpr (std::same_as<T, float>) {
    return table.rounded()[i];
  } else {
    return table.exact()[i];
  }
}
/// Lanes that stand one behind the other in memory.
template <class T>
T load(const Element<T>* from) {
  if constexpr (lanes_of<T> == 1) {
    return *from;
  } else {
    return T::load(from);
  }
}
template <class T>
T load(const Table& table, std::int32_t first) {
  if constexpr (std::same_as<Element<T>, float>) {
    return load<T>(table.rounded + first);
  } else {
    return load<T>(table.exact + first);
  }
}
template <class T>
void store(const T& lanes, Element<T>* to) {
  if constexpr (lanes_of<T> == 1) {
    *to = lanes;
  } else {
    lanes.store(to);
  }
}

template <std::floating_point T>
constexpr std::int32_t gather_index(const std::int32_t* data, std::int32_t i) {
  return data[i];
}
template <std::floating_point T>
std::int32_t gather_index(const IndexTable& table, std::int32_t i) {
  return table.data[i];
}

/// data[first] … data[first + n - 1], lane by lane.
template <int n, std::floating_point T>
std::array<T, n> gather_row(const Table& table, std::int32_t first) {
  std::array<T, n> out{};
  for (std::int32_t k = 0; k < n; ++k)
    out[static_cast<std::size_t>(k)] = gather<T>(table, first + k);
  return out;
}

/// Both numbers of a pair.
template <std::floating_point T>
std::array<T, 2> gather_pair(const ShortPairs& pairs, std::int32_t i) {
  return gather_row<2, T>(pairs.rows, 2 * i);
}

template <std::floating_point T>
std::uint32_t gather_word(const std::uint32_t* data, std::int32_t i) {
  return data[i];
}
template <class T>
Word<T> load_words(const std::uint32_t* from) {
  if constexpr (lanes_of<T> == 1) {
    return *from;
  } else {
    return Word<T>::load(from);
  }
}

/// to[i] = value in the lanes of a mask, in their order.
template <class V>
  requires std::is_arithmetic_v<V>
constexpr void scatter(bool mask, std::int32_t i, V value, V* to) {
  if (mask) to[i] = value;
}

/// The values of all lanes; and one bit for each lane of a mask, the first lane's lowest.
template <class V>
  requires std::is_arithmetic_v<V>
constexpr std::array<V, 1> each_lane(V value) {
  return {value};
}
constexpr std::uint32_t lane_bits(bool mask) { return mask ? 1 : 0; }

template <std::floating_point T>
constexpr bool mask_of_bits(std::uint32_t bits) {
  return (bits & 1U) != 0;
}
/// The first n lanes, or all if there are not so many.
template <std::floating_point T>
constexpr bool first_lanes(std::size_t n) {
  return n > 0;
}

/// 0, 1, 2, … in the lanes.
template <class T>
constexpr Index<T> lane_numbers() {
  if constexpr (lanes_of<T> == 1) {
    return 0;
  } else {
    Index<T> out;
    for (std::size_t i = 0; i < lanes_of<T>; ++i) out.set(i, static_cast<std::int32_t>(i));
    return out;
  }
}

/// The lanes of a mask to, or from, numbers one behind the other.
template <class V>
  requires std::is_arithmetic_v<V>
constexpr void compress(bool mask, V value, V* to) {
  if (mask) *to = value;
}
template <class V>
  requires std::is_arithmetic_v<V>
constexpr void expand(bool mask, const V* from, V& value) {
  if (mask) value = *from;
}

/// The number of lanes that a mask holds.
template <class M>
std::uint32_t count(const M& mask) {
  return static_cast<std::uint32_t>(std::popcount(lane_bits(mask)));
}

/// Calls visit(i) for every lane i of a mask, in their order.
template <class M, class Visit>
void for_each_lane(const M& mask, Visit visit) {
  for (std::uint32_t left = lane_bits(mask); left != 0; left &= left - 1)
    visit(std::countr_zero(left));
}

/// Integer lanes to real lanes, and the floor of real lanes x >= 0 as integers.
template <std::floating_point T>
constexpr T to_real(std::int32_t i) {
  return static_cast<T>(i);
}
/// In double, and the smaller and the larger of two: b, where a is not a number.
inline double to_double(double x) { return x; }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double larger(double a, double b) { return a > b ? a : b; }
inline std::int32_t floor_index(double x) { return static_cast<std::int32_t>(x); }
inline std::int32_t floor_index(float x) { return static_cast<std::int32_t>(x); }

/// The place of a positive x on a grid with 2^bits equal cells in every octave: the number of its
/// cell counted from that of 1.0 (negative below), and the fraction of the cell below x, 0 <=
/// fraction < 1.
template <class T>
struct OctaveCell {
  Index<T> cell;
  T fraction;
};

inline OctaveCell<double> octave_cell(double x, int bits) {
  const auto u = std::bit_cast<std::uint64_t>(x);
  const int drop = 52 - bits;
  const auto cell = static_cast<std::int32_t>(u >> drop) - (1023 << bits);
  const std::uint64_t rest = u & ((std::uint64_t{1} << drop) - 1);
  return {cell,
          static_cast<double>(rest) * std::bit_cast<double>(std::uint64_t(1023 - drop) << 52)};
}

inline OctaveCell<float> octave_cell(float x, int bits) {
  const auto u = std::bit_cast<std::uint32_t>(x);
  const int drop = 23 - bits;
  const auto cell = static_cast<std::int32_t>(u >> drop) - (127 << bits);
  const std::uint32_t rest = u & ((std::uint32_t{1} << drop) - 1);
  return {cell, static_cast<float>(rest) * std::bit_cast<float>(std::uint32_t(127 - drop) << 23)};
}

/// The lower edge of a cell of that grid: the inverse of octave_cell().
template <class T>
  requires std::same_as<T, double>
double octave_edge(std::int32_t cell, int bits) {
  return std::bit_cast<double>((static_cast<std::uint64_t>(cell + (1023 << bits))) << (52 - bits));
}
template <class T>
  requires std::same_as<T, float>
float octave_edge(std::int32_t cell, int bits) {
  return std::bit_cast<float>((static_cast<std::uint32_t>(cell + (127 << bits))) << (23 - bits));
}

}  // namespace photic
