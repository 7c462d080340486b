// The black sea bed.
#pragma once

#include "surface/interface.hpp"

namespace photic::surface {

/// Absorbs all light that comes to it.
struct Black {
  template <class T>
  static Split<T> from_above(const Vec3<T>&) {
    return {};
  }
};

}  // namespace photic::surface
