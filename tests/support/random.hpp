// Random cases for tests, the same on every machine: from the bits of a Mersenne twister (the
// distributions of the standard library are not the same everywhere).
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/constants.hpp"
#include "core/vec3.hpp"

namespace photic::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In (0, 1).
  double uniform() { return (static_cast<double>(engine_() >> 12) + 0.5) * std::ldexp(1.0, -52); }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in the logarithm.
  double scale(double low, double high) { return low * std::pow(high / low, uniform()); }
  int below(int count) { return static_cast<int>(uniform() * count); }
  bool chance(double probability) { return uniform() < probability; }

  /// Uniform on the unit sphere.
  Vec3<double> direction() {
    const double z = between(-1, 1);
    const double azimuth = between(0, 2 * pi);
    const double sine = std::sqrt(1 - z * z);
    return normalised(Vec3<double>{sine * std::cos(azimuth), sine * std::sin(azimuth), z});
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace photic::test
