// Vectors whose zeros cost no memory until they are written to.
#pragma once

#include <sys/mman.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
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
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
      throw std::bad_array_new_length();
    void* memory = is_large(count) ? ::mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE,
                                            MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                                   : std::calloc(count, sizeof(T));
    if (memory == nullptr || memory == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    if (is_large(count))
      ::munmap(memory, count * sizeof(T));
    else
      std::free(memory);
  }

  void construct(T* /*at*/) noexcept {}  // it is T{} already
  void construct(T* at, const T& value) noexcept {
    if (!is_zero(value)) ::new (at) T(value);
  }
  void destroy(T* at) noexcept {
    if (!is_zero(*at)) std::memset(static_cast<void*>(at), 0, sizeof(T));
  }

  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }

 private:
  /// calloc fills what it has at hand with zeros, which then take room; what the system hands out
  /// does not, and goes back to it.
  static bool is_large(std::size_t count) noexcept {
    constexpr std::size_t many_pages = 1U << 17U;
    return count * sizeof(T) >= many_pages;
  }
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
