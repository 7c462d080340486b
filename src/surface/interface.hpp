// What the interfaces between layers make of light: the flat surface, the black sea bed.
#pragma once

#include "core/vec3.hpp"

namespace photic::surface {

/// Where light goes that meets an interface: back to its own side, or on to the other one, each in
/// one direction alone, by these shares of its flux. The rest is absorbed.
template <class T>
struct Split {
  Vec3<T> reflected, transmitted;
  T reflectance{}, transmittance{};

  [[nodiscard]] T absorptance() const { return T(1) - reflectance - transmittance; }
};

}  // namespace photic::surface
