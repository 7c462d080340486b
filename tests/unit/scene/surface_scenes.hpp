// The base scene with another sea surface.
#pragma once

#include <string>
#include <vector>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {

/// The surface stands in line 20, its first key at column 13.
inline std::vector<Edit> with_surface(const std::string& keys, const std::string& simulation = "") {
  return {{19, 19, "[sea]\nsurface = { " + keys + " }"}, {30, 30, "photons = 1e6\n" + simulation}};
}

inline Surface surface_of(const std::string& keys) {
  return read_text(edited(with_surface(keys))).sea.surface;
}

inline constexpr const char* waves = R"(model = "cox-munk", wind_speed_m_s = 5)";

}  // namespace photic::scene
