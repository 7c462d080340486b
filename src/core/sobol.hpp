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
  /// Coordinate d of all points, one behind the other, their bits reversed: for scrambled(). As
  /// many lanes as there may be are readable beyond the last one.
  [[nodiscard]] const std::uint32_t* coordinate(std::size_t d) const {
    return words_.data() + d * points_;
  }
  /// From a coordinate to the next one.
  [[nodiscard]] std::size_t points() const { return points_; }

 private:
  std::size_t points_ = 0, dimensions_ = 0;
  std::vector<std::uint32_t> words_;  ///< [dimension][point]
};

/// W: a word, or one in each lane.
template <class W>
constexpr W reversed_bits(W word) {
  word = (word >> 16) | (word << 16);
  word = ((word >> 8) & W(0x00ff00ff)) | ((word & W(0x00ff00ff)) << 8);
  word = ((word >> 4) & W(0x0f0f0f0f)) | ((word & W(0x0f0f0f0f)) << 4);
  word = ((word >> 2) & W(0x33333333)) | ((word & W(0x33333333)) << 2);
  return ((word >> 1) & W(0x55555555)) | ((word & W(0x55555555)) << 1);
}

/// One coordinate of a point, given with its bits reversed, after Owen's scrambling (Owen, in:
/// Monte Carlo and Quasi-Monte Carlo Methods, 1995), each bit turned or not by what `key` makes of
/// the bits above it: as Burley does (J. Comput. Graph. Tech. 9(4), 1, 2020), with the mixing of
/// Vegdahl (Building a better LK hash, 2021), since that of Laine and Karras leaves neighbours
/// alike.
template <class W>
constexpr W scrambled(const W& reversed, const W& key) {
  W x = reversed;  // each step lets bits change those above only
  x = x ^ (x * W(0x3d20adea));
  x = x + key;
  x = x * ((key >> 16) | W(1));
  x = x ^ (x * W(0x05526c56));
  x = x ^ (x * W(0x53a22864));
  return reversed_bits(x);
}

}  // namespace photic
