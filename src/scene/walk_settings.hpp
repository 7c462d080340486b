// The sampling of walks, and of conversions by either estimator, where a scene does not set it.
#pragma once

#include <cstdint>

namespace photic::scene {

inline constexpr double usual_conversion_probability = 0.3;
inline constexpr std::int64_t usual_walks = 2;
inline constexpr double usual_meetings = 100;
inline constexpr double usual_connected_fraction = 0.3;

}  // namespace photic::scene
