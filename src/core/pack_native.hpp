// Operations that the vector extension of the compilers lacks, or does badly: masks, square roots
// and wide products by the instructions of x86, each with a plain loop for other processors;
// pack_native_memory.hpp has the operations that move lanes.
//
// Everything here depends on the processor that the including file is compiled for: see
// cmake/photic.cmake for how such code is kept apart (photic_for_each_isa).
#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "core/lanes.hpp"

namespace photic::native {

template <class E, int N>
struct VectorOf {
  // NOLINTNEXTLINE(modernize-use-using): an alias takes no such attribute
  typedef E type __attribute__((vector_size(N * sizeof(E))));
};
template <class E, int N>
using Vector = typename VectorOf<E, N>::type;

/// The integer as wide as E.
template <class E>
using Bits = std::conditional_t<sizeof(E) == 4, std::int32_t, std::int64_t>;

/// Floats in the registers that this is compiled for.
#if defined(__AVX512F__)
inline constexpr int float_lanes = 16;
#elif defined(__AVX2__)
inline constexpr int float_lanes = 8;
#else
inline constexpr int float_lanes = 4;
#endif

// Masks: with AVX-512 one bit for each lane, else a vector of 32-bit lanes that are 0 or -1.

#if defined(__AVX512F__)

template <int N>
using MaskBits = std::conditional_t<N == 16, __mmask16, __mmask8>;
template <int N>
inline constexpr MaskBits<N> every_lane = static_cast<MaskBits<N>>((1U << N) - 1);

template <int N>
MaskBits<N> same(bool value) {
  return value ? every_lane<N> : MaskBits<N>{};
}
template <int N>
bool any(MaskBits<N> mask) {
  return mask != 0;
}
template <int N>
std::uint32_t bits(MaskBits<N> mask) {
  return mask;
}
template <int N>
MaskBits<N> mask_of_bits(std::uint32_t bits) {
  return static_cast<MaskBits<N>>(bits);
}

enum Comparison { equal = _CMP_EQ_OQ, less = _CMP_LT_OQ, less_equal = _CMP_LE_OQ };

template <Comparison how, int N, class E>
MaskBits<N> compare(const Vector<E, N>& a, const Vector<E, N>& b) {
  constexpr int integer_how = how == equal  ? _MM_CMPINT_EQ
                              : how == less ? _MM_CMPINT_LT
                                            : _MM_CMPINT_LE;
  if constexpr (N == 16 && std::is_same_v<E, float>) {
    return _mm512_cmp_ps_mask((__m512)a, (__m512)b, how);
  } else if constexpr (N == 16 && std::is_same_v<E, std::int32_t>) {
    return _mm512_cmp_epi32_mask((__m512i)a, (__m512i)b, integer_how);
  } else {
    MaskBits<N> mask{};
    for (int i = 0; i < N; ++i) {
      const bool one = how == equal ? a[i] == b[i] : (how == less ? a[i] < b[i] : a[i] <= b[i]);
      mask = static_cast<MaskBits<N>>(mask | (one ? 1U << i : 0U));
    }
    return mask;
  }
}

template <int N, class E>
Vector<E, N> blend(MaskBits<N> mask, const Vector<E, N>& yes, const Vector<E, N>& no) {
  if constexpr (N == 16 && std::is_same_v<E, float>) {
    return (Vector<E, N>)_mm512_mask_blend_ps(mask, (__m512)no, (__m512)yes);
  } else if constexpr (N == 16 && std::is_same_v<E, std::int32_t>) {
    return (Vector<E, N>)_mm512_mask_blend_epi32(mask, (__m512i)no, (__m512i)yes);
  } else {
    Vector<E, N> out = no;
    for (int i = 0; i < N; ++i) {
      if ((mask >> i & 1U) != 0) out[i] = yes[i];
    }
    return out;
  }
}

#else

template <int N>
using MaskBits = Vector<std::int32_t, N>;

template <int N>
MaskBits<N> same(bool value) {
  return MaskBits<N>{} - (value ? 1 : 0);
}
template <int N>
std::uint32_t bits(const MaskBits<N>& mask) {
#if defined(__SSE2__)
  if constexpr (N == 4) return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)mask));
#endif
#if defined(__AVX2__)
  if constexpr (N == 8) return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
#endif
  std::uint32_t out = 0;
  for (int i = 0; i < N; ++i) out |= mask[i] != 0 ? 1U << i : 0U;
  return out;
}
template <int N>
bool any(const MaskBits<N>& mask) {
  return bits<N>(mask) != 0;
}
template <int N>
MaskBits<N> mask_of_bits(std::uint32_t bits) {
  MaskBits<N> lane{};
  for (int i = 0; i < N; ++i) lane[i] = 1 << i;
  return (lane & static_cast<std::int32_t>(bits)) != 0;
}

enum Comparison { equal, less, less_equal };

template <Comparison how, int N, class E>
MaskBits<N> compare(const Vector<E, N>& a, const Vector<E, N>& b) {
  const auto to_mask = [](const auto& m) {
    if constexpr (sizeof(E) == 4) {
      return (MaskBits<N>)m;
    } else {
      return __builtin_convertvector(m, MaskBits<N>);
    }
  };
  if constexpr (how == equal) return to_mask(a == b);
  if constexpr (how == less) return to_mask(a < b);
  if constexpr (how == less_equal) return to_mask(a <= b);
}

template <int N, class E>
Vector<E, N> blend(const MaskBits<N>& mask, const Vector<E, N>& yes, const Vector<E, N>& no) {
#if defined(__AVX2__)
  if constexpr (N == 8 && sizeof(E) == 4)
    return (Vector<E, N>)_mm256_blendv_ps((__m256)no, (__m256)yes, (__m256)mask);
#endif
  using Wide = Vector<Bits<E>, N>;
  Wide wide;
  if constexpr (sizeof(E) == 4) {
    wide = mask;
  } else {
    wide = __builtin_convertvector(mask, Wide);
  }
  return (Vector<E, N>)((wide & (Wide)yes) | (~wide & (Wide)no));
}

#endif

template <int N, class E>
Vector<E, N> square_root(const Vector<E, N>& x) {
#if defined(__AVX512F__)
  if constexpr (N == 16 && sizeof(E) == 4) return (Vector<E, N>)_mm512_sqrt_ps((__m512)x);
#endif
#if defined(__AVX2__)
  if constexpr (N == 8 && sizeof(E) == 4) return (Vector<E, N>)_mm256_sqrt_ps((__m256)x);
#endif
#if defined(__SSE2__)
  if constexpr (N == 4 && sizeof(E) == 4) return (Vector<E, N>)_mm_sqrt_ps((__m128)x);
#endif
  Vector<E, N> out;
  for (int i = 0; i < N; ++i) out[i] = std::sqrt(x[i]);
  return out;
}

/// The lower or the upper half of the lanes.
template <int N, class E, std::size_t... i>
Vector<E, N / 2> half(const Vector<E, N>& x, bool upper, std::index_sequence<i...>) {
  if (upper) return __builtin_shufflevector(x, x, static_cast<int>(i + N / 2)...);
  return __builtin_shufflevector(x, x, static_cast<int>(i)...);
}
template <int N, class E>
Vector<E, N / 2> half(const Vector<E, N>& x, bool upper) {
  return half<N, E>(x, upper, std::make_index_sequence<N / 2>{});
}

/// Half of the floats as doubles.
template <int N>
Vector<double, N / 2> wide_half(const Vector<float, N>& x, bool upper) {
#if defined(__AVX512F__)
  if constexpr (N == 16) {
    const auto v = (__m512)x;
    return (Vector<double, N / 2>)_mm512_cvtps_pd(upper ? _mm512_extractf32x8_ps(v, 1)
                                                        : _mm512_castps512_ps256(v));
  }
#endif
#if defined(__AVX2__)
  if constexpr (N == 8) {
    const auto v = (__m256)x;
    return (Vector<double, N / 2>)_mm256_cvtps_pd(upper ? _mm256_extractf128_ps(v, 1)
                                                        : _mm256_castps256_ps128(v));
  }
#endif
  return __builtin_convertvector((half<N, float>(x, upper)), Vector<double, N / 2>);
}

/// The products of the lower halves of 64-bit lanes with a 32-bit number.
template <int N>
Vector<std::uint64_t, N> multiply_low(const Vector<std::uint64_t, N>& a, std::uint32_t b) {
  using Lanes = Vector<std::uint64_t, N>;
#if defined(__AVX512F__)
  if constexpr (N == 8) return (Lanes)_mm512_mul_epu32((__m512i)a, _mm512_set1_epi64(b));
#endif
#if defined(__AVX2__)
  if constexpr (N == 4) return (Lanes)_mm256_mul_epu32((__m256i)a, _mm256_set1_epi64x(b));
#endif
#if defined(__SSE2__)
  if constexpr (N == 2) return (Lanes)_mm_mul_epu32((__m128i)a, _mm_set1_epi64x(b));
#endif
  return (a & std::uint64_t{0xffffffff}) * std::uint64_t{b};
}

/// The lower words of two vectors of 64-bit lanes, one behind the other.
template <int N>
Vector<std::int32_t, N> low_words(const Vector<std::uint64_t, N / 2>& first,
                                  const Vector<std::uint64_t, N / 2>& second) {
#if defined(__AVX512F__)
  if constexpr (N == 16) {
    const __m512i even =
        _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    return (Vector<std::int32_t, N>)_mm512_permutex2var_epi32((__m512i)first, even,
                                                              (__m512i)second);
  }
#endif
  using Words = Vector<std::int32_t, N>;
  const auto pick = [&]<std::size_t... i>(std::index_sequence<i...>) {
    return __builtin_shufflevector((Words)first, (Words)second, static_cast<int>(2 * i)...);
  };
  return pick(std::make_index_sequence<N>{});
}

/// The lanes of two vectors, one behind the other.
template <int N>
Vector<std::int32_t, N> joined(const Vector<std::int32_t, N / 2>& first,
                               const Vector<std::int32_t, N / 2>& second) {
  const auto pick = [&]<std::size_t... i>(std::index_sequence<i...>) {
    return __builtin_shufflevector(first, second, static_cast<int>(i)...);
  };
  return pick(std::make_index_sequence<N>{});
}

/// Lanes of two vectors in turn, as words of 64-bit lanes: the lower words first.
template <int N>
std::array<Vector<std::uint64_t, N / 2>, 2> in_turn(const Vector<std::int32_t, N>& lower,
                                                    const Vector<std::int32_t, N>& upper) {
  const auto pick = [&]<std::size_t... i>(std::index_sequence<i...>) {
    using Wide = Vector<std::uint64_t, N / 2>;
    return std::array<Wide, 2>{
        (Wide)__builtin_shufflevector(lower, upper, static_cast<int>(i / 2 + i % 2 * N)...),
        (Wide)__builtin_shufflevector(lower, upper,
                                      static_cast<int>(N / 2 + i / 2 + i % 2 * N)...)};
  };
  return pick(std::make_index_sequence<N>{});
}

}  // namespace photic::native
