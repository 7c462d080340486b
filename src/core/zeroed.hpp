// Vectors whose zeros cost no memory until they are written to.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <vector>

namespace photic {

/// Allocates memory that is all zeros, of which the system hands out a page when something is first
/// written to it. Zeros are not written: tallies that no light reaches take no room, nor do their
/// copies. What is not in use is all zeros again. Only for types of which all bytes 0 are T{}.
template <class T>
struct ZeroedAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;

  ZeroedAllocator() = default;
  template <class Other>
  explicit(false) ZeroedAllocator(const ZeroedAllocator<Other>& /*other*/) noexcept {}

  T* allocate(std::size_t count) {
    void* memory = std::calloc(count, sizeof(T));
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t /*count*/) noexcept { std::free(memory); }

  void construct(T* /*at*/) noexcept {}  // it is T{} already
  void construct(T* at, const T& value) noexcept {
    if (!is_zero(value)) ::new (at) T(value);
  }
  void destroy(T* at) noexcept {
    if (!is_zero(*at)) std::memset(static_cast<void*>(at), 0, sizeof(T));
  }

  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }

 private:
  static bool is_zero(const T& value) noexcept {
    using Word = std::conditional_t<sizeof(T) % 8 == 0, std::uint64_t, std::uint32_t>;
    constexpr std::size_t word_size = sizeof(Word);
    static_assert(sizeof(T) % word_size == 0);
    Word any = 0;
    for (const Word word : std::bit_cast<std::array<Word, sizeof(T) / word_size>>(value))
      any |= word;
    return any == 0;
  }
};

template <class T>
using ZeroedVector = std::vector<T, ZeroedAllocator<T>>;

}  // namespace photic
