// Lanes that come from memory, go there, or change places, by the instructions of x86, each with a
// plain loop for other processors (a part of pack_native.hpp, which states what this depends on).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/lanes.hpp"
#include "core/pack_native.hpp"

namespace photic::native {

/// data[index], lane by lane, of 32-bit numbers.
template <int N, class E>
Vector<E, N> gather(const E* data, const Vector<std::int32_t, N>& index) {
  static_assert(sizeof(E) == 4);
#if defined(__AVX512F__)
  if constexpr (N == 16) return (Vector<E, N>)_mm512_i32gather_epi32((__m512i)index, data, 4);
#endif
#if defined(__AVX2__)
  if constexpr (N == 8) {
    return (Vector<E, N>)_mm256_i32gather_epi32(reinterpret_cast<const int*>(data), (__m256i)index,
                                                4);
  }
#endif
  Vector<E, N> out;
  for (int i = 0; i < N; ++i) out[i] = data[index[i]];
  return out;
}

/// The same of a table of 64 numbers.
template <int N, class E>
Vector<E, N> gather_64(const E* data, const Vector<std::int32_t, N>& index) {
#if defined(__AVX512F__)
  if constexpr (N == 16) {
    const auto i = (__m512i)index;
    const auto half = [&](const E* from) {
      return _mm512_permutex2var_epi32(_mm512_loadu_si512(from), i, _mm512_loadu_si512(from + 16));
    };
    const __mmask16 upper = _mm512_test_epi32_mask(i, _mm512_set1_epi32(32));
    return (Vector<E, N>)_mm512_mask_blend_epi32(upper, half(data), half(data + 32));
  }
#endif
  return gather<N, E>(data, index);
}

/// The same of a table of eight numbers, readable as far as registers go.
template <int N, class E>
Vector<E, N> gather_cells(const E* data, const Vector<std::int32_t, N>& index) {
#if defined(__AVX512F__)
  if constexpr (N == 16)
    return (Vector<E, N>)_mm512_permutexvar_epi32((__m512i)index, _mm512_loadu_si512(data));
#endif
#if defined(__AVX2__)
  if constexpr (N == 8) {
    __m256i table;
    std::memcpy(&table, data, sizeof table);
    return (Vector<E, N>)_mm256_permutevar8x32_epi32(table, (__m256i)index);
  }
#endif
  return gather<N, E>(data, index);
}

/// Tables of more numbers than these are read from memory.
template <int N>
inline constexpr std::int32_t held_in_registers = N == 16 && float_lanes == 16 ? 64
                                                  : N == 8 && float_lanes >= 8 ? 8
                                                                               : 0;

/// The same of a table of so many numbers, readable up to a multiple of 64 of them: from registers
/// where it is short.
template <int N, class E>
Vector<E, N> gather_short(const E* data, std::int32_t size, const Vector<std::int32_t, N>& index) {
  static_assert(sizeof(E) == 4);
#if defined(__AVX512F__)
  if constexpr (N == 16) {
    if (size <= 16) {
      return (Vector<E, N>)_mm512_permutexvar_epi32((__m512i)index, _mm512_loadu_si512(data));
    }
    if (size <= held_in_registers<N>) return gather_64<N, E>(data, index);
  }
#endif
#if defined(__AVX2__)
  if constexpr (N == 8) {
    if (size <= held_in_registers<N>) {
      __m256i table;
      std::memcpy(&table, data, sizeof table);
      return (Vector<E, N>)_mm256_permutevar8x32_epi32(table, (__m256i)index);
    }
  }
#endif
  static_cast<void>(size);
  return gather<N, E>(data, index);
}

#if defined(__AVX2__)
/// The first two of each four numbers of a and of b, in turn; or the last two.
inline __m256 first_in_turn(__m256 a, __m256 b) { return _mm256_unpacklo_ps(a, b); }
inline __m256 last_in_turn(__m256 a, __m256 b) { return _mm256_unpackhi_ps(a, b); }
/// The first and third of the same numbers, a's before b's; or the others.
inline __m256 even_of(__m256 a, __m256 b) { return _mm256_shuffle_ps(a, b, 0x88); }
inline __m256 odd_of(__m256 a, __m256 b) { return _mm256_shuffle_ps(a, b, 0xdd); }
#endif
#if defined(__AVX512F__)
inline __m512 first_in_turn(__m512 a, __m512 b) { return _mm512_unpacklo_ps(a, b); }
inline __m512 last_in_turn(__m512 a, __m512 b) { return _mm512_unpackhi_ps(a, b); }
inline __m512 even_of(__m512 a, __m512 b) { return _mm512_shuffle_ps(a, b, 0x88); }
inline __m512 odd_of(__m512 a, __m512 b) { return _mm512_shuffle_ps(a, b, 0xdd); }
#endif

/// data[first] … data[first + n - 1], lane by lane: by one load for each lane, where lanes are
/// many.
template <int n, int N, class E>
std::array<Vector<E, N>, n> gather_row(const E* data, const Vector<std::int32_t, N>& first) {
  static_assert((n == 2 || n == 4) && sizeof(E) == 4);
  std::array<Vector<E, N>, n> out;
#if defined(__AVX2__)
  if constexpr (N == float_lanes) {
    // Two numbers of rows are read at once.
    const auto two = (Vector<std::uint64_t, N / 2>)first;
    const auto from = [&](int lane) {
      const std::uint64_t both = two[lane / 2];
      return data + (lane % 2 == 0 ? static_cast<std::uint32_t>(both) : both >> 32);
    };
    if constexpr (n == 2) {
      const auto pair = [&](int lane) {
        const auto row = [&](int i) { return reinterpret_cast<const double*>(from(i)); };
        return _mm_loadh_pd(_mm_load_sd(row(lane)), row(lane + 1));
      };
      // Pairs of lanes that are four apart, one behind the other.
      const auto pairs = [&](int lane) {
#if defined(__AVX512F__)
        const __m512d lower =
            _mm512_insertf64x2(_mm512_castpd128_pd512(pair(lane)), pair(lane + 4), 1);
        return _mm512_castpd_ps(
            _mm512_insertf64x2(_mm512_insertf64x2(lower, pair(lane + 8), 2), pair(lane + 12), 3));
#else
        return _mm256_castpd_ps(_mm256_set_m128d(pair(lane + 4), pair(lane)));
#endif
      };
      const auto pairs0 = pairs(0), pairs2 = pairs(2);
      out[0] = (Vector<E, N>)even_of(pairs0, pairs2);
      out[1] = (Vector<E, N>)odd_of(pairs0, pairs2);
      return out;
    }
    const auto row = [&](int lane) {
      return _mm_castsi128_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from(lane))));
    };
    // Rows of lanes that are four apart, one behind the other.
    const auto rows = [&](int lane) {
#if defined(__AVX512F__)
      const __m512 lower = _mm512_insertf32x4(_mm512_castps128_ps512(row(lane)), row(lane + 4), 1);
      return _mm512_insertf32x4(_mm512_insertf32x4(lower, row(lane + 8), 2), row(lane + 12), 3);
#else
      return _mm256_set_m128(row(lane + 4), row(lane));
#endif
    };
    const auto row0 = rows(0), row1 = rows(1), row2 = rows(2), row3 = rows(3);
    const auto even = first_in_turn(row0, row2), odd = first_in_turn(row1, row3);
    out[0] = (Vector<E, N>)first_in_turn(even, odd);
    out[1] = (Vector<E, N>)last_in_turn(even, odd);
    const auto upper_even = last_in_turn(row0, row2), upper_odd = last_in_turn(row1, row3);
    out[2] = (Vector<E, N>)first_in_turn(upper_even, upper_odd);
    out[3] = (Vector<E, N>)last_in_turn(upper_even, upper_odd);
    return out;
  }
#endif
  for (std::int32_t k = 0; k < n; ++k)
    out[static_cast<std::size_t>(k)] = gather<N>(data + k, first);
  return out;
}

#if defined(__AVX2__)
/// For each mask of 8 lanes the numbers of those that it holds, and the place of each lane among
/// those, a byte each.
struct PlacesOfLanes {
  std::array<std::uint64_t, 256> held{}, place{};
  constexpr PlacesOfLanes() {
    for (std::size_t mask = 0; mask < held.size(); ++mask) {
      std::uint64_t before = 0;
      for (std::uint64_t lane = 0; lane < 8; ++lane) {
        place[mask] |= before << 8 * lane;
        if ((mask >> lane & 1U) != 0) held[mask] |= lane << 8 * before++;
      }
    }
  }
};
inline constexpr PlacesOfLanes places_of_lanes;

/// Eight bytes as numbers of lanes.
inline __m256i lane_numbers(std::uint64_t bytes) {
  return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(bytes)));
}
#endif

/// Lanes of a mask one behind the other, from `to` on; up to N numbers are written there.
template <int N, class E>
void compress(MaskBits<N> mask, const Vector<E, N>& lanes, E* to) {
  static_assert(sizeof(E) == 4);
#if defined(__AVX512F__)
  if constexpr (N == 16) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, (__m512i)lanes));
    return;
  }
#endif
#if defined(__AVX2__)
  if constexpr (N == 8) {
    const __m256i lane = lane_numbers(places_of_lanes.held[bits<N>(mask)]);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_permutevar8x32_epi32((__m256i)lanes, lane));
    return;
  }
#endif
  for (std::uint32_t left = bits<N>(mask); left != 0; left &= left - 1)
    *to++ = lanes[std::countr_zero(left)];
}

/// Swaps the halves off the diagonal of each square of 2 x step rows and lanes.
template <std::size_t step, std::size_t N, class V, std::size_t... l>
void swap_off_diagonal(V& a, V& b, std::index_sequence<l...>) {
  const V above = a;
  a = __builtin_shufflevector(a, b, ((l & step) != 0 ? N + l - step : l)...);
  b = __builtin_shufflevector(above, b, ((l & step) != 0 ? N + l : l + step)...);
}
/// Lane j of row i of N becomes lane i of row j.
template <int N, std::size_t step = 1, class Rows>
void transpose(Rows& row) {
  photic::unrolled<N>([&](auto i) {
    if constexpr ((i & step) == 0)
      swap_off_diagonal<step, N>(row[i].v, row[i + step].v, std::make_index_sequence<N>());
  });
  if constexpr (2 * step < N) transpose<N, 2 * step>(row);
}

/// from[lane], lane by lane.
template <int N, class E>
Vector<E, N> permute(const Vector<E, N>& from, const Vector<std::int32_t, N>& lane) {
#if defined(__AVX512F__)
  if constexpr (N == 16 && sizeof(E) == 4)
    return (Vector<E, N>)_mm512_permutexvar_epi32((__m512i)lane, (__m512i)from);
#endif
#if defined(__AVX2__)
  if constexpr (N == 8 && sizeof(E) == 4)
    return (Vector<E, N>)_mm256_permutevar8x32_epi32((__m256i)from, (__m256i)lane);
#endif
  Vector<E, N> out;
  for (int i = 0; i < N; ++i) out[i] = from[lane[i]];
  return out;
}

/// The lanes of a mask from numbers one behind the other, the others as they are; up to N are read.
template <int N, class E>
Vector<E, N> expand(MaskBits<N> mask, Vector<E, N> lanes, const E* from) {
#if defined(__AVX512F__)
  if constexpr (N == 16 && sizeof(E) == 4) {
    // Half as many reads reach into two cache lines if they are half as long.
    if (std::popcount(bits<N>(mask)) > N / 2)
      return (Vector<E, N>)_mm512_mask_expandloadu_epi32((__m512i)lanes, mask, from);
    const __m256i few = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    return (Vector<E, N>)_mm512_mask_expand_epi32((__m512i)lanes, mask,
                                                  _mm512_zextsi256_si512(few));
  }
#endif
#if defined(__AVX2__)
  if constexpr (N == 8 && sizeof(E) == 4) {
    const __m256i read = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    const auto placed = (Vector<E, N>)_mm256_permutevar8x32_epi32(
        read, lane_numbers(places_of_lanes.place[bits<N>(mask)]));
    return blend<N, E>(mask, placed, lanes);
  }
#endif
  for (std::uint32_t left = bits<N>(mask); left != 0; left &= left - 1)
    lanes[std::countr_zero(left)] = *from++;
  return lanes;
}

#if defined(__AVX2__)
/// The bytes of each sixteen whose numbers stand in each sixteen of another vector.
inline __m256i pick_bytes(__m256i from, __m256i number) {
  return _mm256_shuffle_epi8(from, number);
}
inline __m256i repeated(__m128i bytes, std::integral_constant<int, 8>) {
  return _mm256_broadcastsi128_si256(bytes);
}
#if defined(__AVX512BW__)
inline __m512i pick_bytes(__m512i from, __m512i number) {
  return _mm512_shuffle_epi8(from, number);
}
inline __m512i repeated(__m128i bytes, std::integral_constant<int, 16>) {
  return _mm512_broadcast_i32x4(bytes);
}
#endif

/// The bytes as they are read backwards: the halves of a byte by two tables, then the bytes.
struct BackwardsTables {
  alignas(16) std::array<std::uint8_t, 16> of_upper_half{}, of_lower_half{}, of_bytes{};
  constexpr BackwardsTables() {
    for (std::size_t i = 0; i < 16; ++i) {
      std::uint8_t turned = 0;
      for (std::size_t bit = 0; bit < 4; ++bit)
        if ((i >> bit & 1U) != 0) turned |= static_cast<std::uint8_t>(8U >> bit);
      of_upper_half[i] = turned;
      of_lower_half[i] = static_cast<std::uint8_t>(turned << 4);
      of_bytes[i] = static_cast<std::uint8_t>(i / 4 * 4 + 3 - i % 4);
    }
  }
};
inline constexpr BackwardsTables backwards;

/// The bits of words read backwards.
template <int N>
Vector<std::uint32_t, N> reversed_bits(const Vector<std::uint32_t, N>& words) {
  static_assert(N == float_lanes);
  const auto table = [](const auto& bytes) {
    return repeated(_mm_load_si128(reinterpret_cast<const __m128i*>(bytes.data())),
                    std::integral_constant<int, N>());
  };
  using Bytes = decltype(table(backwards.of_bytes));
  constexpr std::uint32_t half = 0x0f0f0f0f;
  const auto lower = pick_bytes(table(backwards.of_lower_half), (Bytes)(words & half));
  const auto upper = pick_bytes(table(backwards.of_upper_half), (Bytes)((words >> 4) & half));
  return (Vector<std::uint32_t, N>)pick_bytes(lower | upper, table(backwards.of_bytes));
}
#endif

/// to[index] = the value, in the lanes of a mask.
template <int N, class E>
void scatter(MaskBits<N> mask, const Vector<std::int32_t, N>& index, const Vector<E, N>& value,
             E* to) {
#if defined(__AVX512F__)
  if constexpr (N == 16 && sizeof(E) == 4)
    return _mm512_mask_i32scatter_epi32(to, mask, (__m512i)index, (__m512i)value, 4);
#endif
  for (std::uint32_t left = bits<N>(mask); left != 0; left &= left - 1) {
    const int lane = std::countr_zero(left);
    to[index[lane]] = value[lane];
  }
}

}  // namespace photic::native
