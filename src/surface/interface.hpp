// What an interface that is smooth makes of light: the flat surface.
#pragma once

#include "core/vec3.hpp"

namespace photic::surface {

/// Where light goes that meets an interface: back to its own side, or on to the other one, each in
/// one direction alone, by these shares of its flux. The rest is absorbed.
template <class T>
struct Split {
  Vec3<T> reflected, transmitted;
  T reflectance{}, transmittance{};

  /// Of what does not pass, the share that is reflected. Where chance decides which way light goes
  /// it passes by the transmittance, which is the same from both sides, and what goes back keeps
  /// this share of its weight.
  [[nodiscard]] T reflected_of_rest() const {
    const T rest = T(1) - transmittance;
    return reflectance / select(rest > T(0), rest, T(1));
  }
};

}  // namespace photic::surface
