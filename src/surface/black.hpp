// The black sea bed.
#pragma once

namespace photic::surface {

/// Absorbs all light that comes to it.
struct Black {
  static constexpr bool reflects = false;
};

}  // namespace photic::surface
