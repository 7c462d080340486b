// The split of light at a smooth interface, the flat surface.
#pragma once

#include "core/vec3.hpp"

namespace photic::surface {

/// The two ways of light that meets an interface: back to its own side, or on to the other one,
/// each in one direction alone, by these shares of its flux. The rest is absorbed.
template <class T>
struct Split {
  Vec3<T> reflected, transmitted;
  T reflectance{}, transmittance{};

  /// The reflected share of the light that does not pass. Where chance decides between the ways,
  /// light passes by the transmittance, which is the same from both sides, and light that goes back
  /// keeps this share of its weight.
  [[nodiscard]] T reflected_of_rest() const {
    const T rest = T(1) - transmittance;
    return reflectance / select(rest > T(0), rest, T(1));
  }
};

}  // namespace photic::surface
