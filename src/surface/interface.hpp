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
};

}  // namespace photic::surface
