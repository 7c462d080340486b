// Sobol' points and their scrambling.
#include "core/sobol.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "core/random.hpp"
#include "support/chi_squared.hpp"

namespace photic {
namespace {

constexpr std::array<std::uint32_t, 4> keys{0, 1, 0x9e3779b9, 0xffffffff};

TEST(Reversed, IsTheWordReadBackwards) {
  EXPECT_EQ(reversed_bits(0x00000001), 0x80000000);
  EXPECT_EQ(reversed_bits(0x12345678), 0x1e6a2c48);
}

// The first 2^k points have one point in each of the 2^k cells of an axis. Seen red: without the
// point at 0; with a multiplier of the scrambling that is odd.
TEST(SobolPoints, FillEachAxisEvenlyScrambledOrNot) {
  const SobolPoints points(1024, 36);
  for (std::size_t d = 0; d < points.dimensions(); ++d) {
    for (const std::uint32_t key : keys) {
      std::set<std::uint32_t> cells;
      for (std::size_t n = 0; n < 1024; ++n)
        cells.insert(scrambled(points.coordinate(d)[n], key) >> 22);
      ASSERT_EQ(cells.size(), 1024U) << "dimension " << d << ", key " << key;
    }
  }
}

// The first two dimensions are a net: one point in each elementary interval of every shape. Seen
// red: with the second dimension's words times an odd number.
TEST(SobolPoints, OfTwoDimensionsAreANet) {
  const SobolPoints points(256, 2);
  for (int wide = 0; wide <= 8; ++wide) {
    std::set<std::uint64_t> cells;
    for (std::size_t n = 0; n < 256; ++n) {
      const std::uint64_t x =
          std::uint64_t{scrambled(points.coordinate(0)[n], keys[1])} >> (32 - wide);
      const std::uint64_t y =
          std::uint64_t{scrambled(points.coordinate(1)[n], keys[2])} >> (24 + wide);
      cells.insert((x << (8 - wide)) | y);
    }
    EXPECT_EQ(cells.size(), 256U) << wide;
  }
}

// Each point alone is uniform over all keys, and so is where two of the same half lie in it: what
// keeps each batch unbiased. Seen red: with the key not added; with the mixing of Laine and Karras.
TEST(Scrambled, IsUniformOverKeys) {
  constexpr std::size_t cells = 64;
  constexpr std::uint64_t keys_drawn = 200 * cells;
  for (const std::uint32_t word : {0U, 0x80000000U, 0x35a1c000U}) {
    std::vector<double> one(cells), two(cells);
    for (std::uint64_t i = 0; i < keys_drawn; ++i) {
      const std::uint32_t key = philox_words(11, i, 0, 0)[0];
      const std::uint32_t a = scrambled(reversed_bits(word), key);
      const std::uint32_t b = scrambled(reversed_bits(word ^ 0x40000000), key);
      one[a >> 26] += 1;
      two[((a ^ b) >> 24) & 63] += 1;  // the first bit is the same, the second differs
    }
    test::expect_uniform(one, keys_drawn, 1e-3);
    test::expect_uniform(two, keys_drawn, 1e-3);
  }
}

}  // namespace
}  // namespace photic
