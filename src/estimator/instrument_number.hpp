// The numbers of a scene's instruments.
#pragma once

#include <cstddef>
#include <cstdint>

namespace photic::estimator {

/// Instruments are counted from the laser on, behind which the telescopes stand.
inline constexpr std::int32_t of_laser = 0;
inline std::int32_t of_telescope(std::size_t telescope) {
  return 1 + static_cast<std::int32_t>(telescope);
}

}  // namespace photic::estimator
