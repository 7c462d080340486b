// Lanes of packs that come from memory, go there, or change places (core/lanes.hpp).
#pragma once

#include <array>
#include <type_traits>

#include "core/pack_native_memory.hpp"
#include "core/pack_type.hpp"

namespace photic {

template <class T, class Stored>
  requires is_pack<T>
T gather(const Stored* data, const Index<T>& i) {
  if constexpr (std::is_same_v<Stored, Element<T>> && sizeof(Stored) == 4) {
    return T::of(native::gather<T::lanes>(data, i.v));
  } else {
    T out;
    for (std::size_t k = 0; k < T::lanes; ++k) out.set(k, static_cast<Element<T>>(data[i[k]]));
    return out;
  }
}
template <class T>
  requires is_pack<T>
T gather(const Table& table, const Index<T>& i) {
  if constexpr (sizeof(Element<T>) == 4) {
    return gather<T>(table.rounded, i);
  } else {
    return gather<T>(table.exact, i);
  }
}
template <class T>
  requires is_pack<T>
T gather(const ShortTable& table, const Index<T>& i) {
  if constexpr (sizeof(Element<T>) == 4) {
    return T::of(native::gather_short<T::lanes>(table.rounded, table.size, i.v));
  } else {
    return gather<T>(table.exact, i);
  }
}
template <class T>
  requires is_pack<T>
T gather(const CellTable& table, const Index<T>& i) {
  if constexpr (sizeof(Element<T>) == 4) {
    return T::of(native::gather_cells<T::lanes>(table.rounded(), i.v));
  } else {
    return gather<T>(table.exact(), i);
  }
}
template <int n, class T>
  requires is_pack<T>
std::array<T, n> gather_row(const Table& table, const Index<T>& first) {
  std::array<T, n> out;
  if constexpr (sizeof(Element<T>) == 4) {
    const auto rows = native::gather_row<n, T::lanes>(table.rounded, first.v);
    for (std::size_t k = 0; k < n; ++k) out[k] = T::of(rows[k]);
  } else {
    for (std::int32_t k = 0; k < n; ++k)
      out[static_cast<std::size_t>(k)] = gather<T>(table + k, first);
  }
  return out;
}
template <class T>
  requires is_pack<T>
std::array<T, 2> gather_pair(const ShortPairs& pairs, const Index<T>& i) {
  if (sizeof(Element<T>) == 4 && pairs.first.size > native::held_in_registers<T::lanes>)
    return gather_row<2, T>(pairs.rows, i + i);
  return {gather<T>(pairs.first, i), gather<T>(pairs.second, i)};
}
template <class T>
  requires is_pack<T>
Index<T> gather_index(const std::int32_t* data, const Index<T>& i) {
  return Index<T>::of(native::gather<T::lanes>(data, i.v));
}
template <class T>
  requires is_pack<T>
Index<T> gather_index(const IndexTable& table, const Index<T>& i) {
  return Index<T>::of(native::gather_short<T::lanes>(table.data, table.size, i.v));
}

template <class T>
  requires is_pack<T>
Mask<T> mask_of_bits(std::uint32_t bits) {
  return Mask<T>::of_bits(bits);
}
template <class T>
  requires is_pack<T>
Mask<T> first_lanes(std::size_t n) {
  return mask_of_bits<T>(n >= 32 ? ~std::uint32_t{0} : (std::uint32_t{1} << n) - 1);
}

/// Lane j of row i becomes lane i of row j.
template <class E, int N, std::size_t rows>
void transpose(std::array<Pack<E, N>, rows>& row) {
  static_assert(rows == N);
  native::transpose<N>(row);
}
template <class E, int N>
Pack<E, N> permute(const Pack<E, N>& from, const Pack<std::int32_t, N>& lane) {
  return Pack<E, N>::of(native::permute<N, E>(from.v, lane.v));
}

#if defined(__AVX2__)
/// By fewer steps than the plain text takes (core/sobol.hpp).
inline Pack<std::uint32_t, native::float_lanes> reversed_bits(
    const Pack<std::uint32_t, native::float_lanes>& words) {
  return Pack<std::uint32_t, native::float_lanes>::of(
      native::reversed_bits<native::float_lanes>(words.v));
}
#endif

/// Up to N numbers are written.
template <class E, int N>
void compress(const PackMask<N>& mask, const Pack<E, N>& lanes, E* to) {
  native::compress<N, E>(mask.value, lanes.v, to);
}
/// Up to N are read.
template <class E, int N>
void expand(const PackMask<N>& mask, const E* from, Pack<E, N>& lanes) {
  lanes.v = native::expand<N, E>(mask.value, lanes.v, from);
}

template <class T>
  requires is_pack<T>
Word<T> gather_word(const std::uint32_t* data, const Index<T>& i) {
  return Word<T>::of(native::gather<T::lanes>(data, i.v));
}
template <class E, int N>
void scatter(const PackMask<N>& mask, const Pack<std::int32_t, N>& i, const Pack<E, N>& value,
             E* to) {
  native::scatter<N, E>(mask.value, i.v, value.v, to);
}

}  // namespace photic
