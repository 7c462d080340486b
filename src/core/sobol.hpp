// Sobol' points, and how a batch makes them random: points that fill the unit cube more evenly than
// random ones do, each of them nonetheless uniform in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace photic {

/// The first points of the Sobol' sequence with the direction numbers of Joe and Kuo (SIAM J. Sci.
/// Comput. 30, 2635, 2008), in words of 32 bits. From Boost, which leaves out the first point, 0.
class SobolPoints {
 public:
  SobolPoints() = default;
  SobolPoints(std::size_t points, std::size_t dimensions);

  [[nodiscard]] std::size_t dimensions() const { return dimensions_; }
  [[nodiscard]] std::uint32_t word(std::size_t point, std::size_t dimension) const {
    return words_[point * dimensions_ + dimension];
  }

 private:
  std::size_t dimensions_ = 0;
  std::vector<std::uint32_t> words_;  ///< [point][dimension]
};

constexpr std::uint32_t reversed_bits(std::uint32_t word) {
  word = (word >> 16) | (word << 16);
  word = ((word & 0xff00ff00) >> 8) | ((word & 0x00ff00ff) << 8);
  word = ((word & 0xf0f0f0f0) >> 4) | ((word & 0x0f0f0f0f) << 4);
  word = ((word & 0xcccccccc) >> 2) | ((word & 0x33333333) << 2);
  return ((word & 0xaaaaaaaa) >> 1) | ((word & 0x55555555) << 1);
}

/// One coordinate of a point after Owen's scrambling (Owen, in: Monte Carlo and Quasi-Monte Carlo
/// Methods, 1995), each bit turned or not by what `key` makes of the bits above it: as Burley does
/// (J. Comput. Graph. Tech. 9(4), 1, 2020), with the mixing of Vegdahl (Building a better LK hash,
/// 2021), since that of Laine and Karras leaves neighbours alike.
constexpr std::uint32_t scrambled(std::uint32_t word, std::uint32_t key) {
  std::uint32_t x = reversed_bits(word);  // now each step lets bits change those above only
  x ^= x * 0x3d20adea;
  x += key;
  x *= (key >> 16) | 1;
  x ^= x * 0x05526c56;
  x ^= x * 0x53a22864;
  return reversed_bits(x);
}

}  // namespace photic
